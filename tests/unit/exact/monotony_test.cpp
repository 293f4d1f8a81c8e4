// Monotony of mappings decided by roots, against slopes that are known by construction and against fine samples.
#include "torse/exact/quasi/monotony.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "torse/spline/piece_polynomials.hpp"

namespace torse {
namespace {

using Q = Rational;

Mapping<Q> bezier(const std::vector<Q>& beta) {
  return mapping_of(bezier_knots<Q>(static_cast<int>(beta.size()) - 1), beta);
}

/// The Bezier mapping with sigma(0) = 0 and this slope.
Mapping<Q> with_slope(const Polynomial<Q>& slope) {
  std::vector<Q> power{Q(0)};
  for (int i = 0; i <= slope.degree(); ++i) power.push_back(slope[i] / Q(i + 1));
  const auto points = bezier_rows(std::array<Polynomial<Q>, 1>{Polynomial<Q>(power)}, slope.degree() + 1, Q(0), Q(1));
  return Mapping<Q>(bezier_knots<Q>(slope.degree() + 1), points);
}

Polynomial<Q> poly(const std::vector<int>& c) {
  std::vector<Q> list;
  for (int x : c) list.push_back(Q(x));
  return Polynomial<Q>(list);
}

TEST(Monotony, ADoubleRootInsideIsNoTurn) {
  // (3t-1)^2 and (2t^2-1)^2: a rational and an irrational double root; the coefficients fall.
  for (const Polynomial<Q>& root : {poly({-1, 3}), poly({-1, 0, 2})}) {
    const Mapping<Q> sigma = with_slope(root * root);
    EXPECT_EQ(monotone(sigma), Truth::unknown);
    EXPECT_EQ(decide_monotony(sigma).kind, Monotony::strict);
    const Mapping<Q> falling = with_slope(root * root - Polynomial<Q>::constant(ratio<Q>(1, 1000000)));
    const MonotonyVerdict verdict = decide_monotony(falling);
    EXPECT_EQ(verdict.kind, Monotony::none);
    EXPECT_LT(mapping_slope(falling, *verdict.witness), Q(0));
  }
}

TEST(Monotony, RootsBesideTheDomainAndAtItsEnds) {
  EXPECT_EQ(decide_monotony(with_slope(poly({0, 0, 1}) * poly({1, -1}))).kind, Monotony::strict);      // t^2 (1 - t)
  EXPECT_EQ(decide_monotony(with_slope(poly({2, 0, -1}) * poly({1, -2, 2}))).kind, Monotony::strict);  // root sqrt 2
  const Polynomial<Q> near_end = poly({-1, 0, 1000002}) * poly({1, -1, 1});  // negative up to t = 0.000999999
  const MonotonyVerdict verdict = decide_monotony(with_slope(near_end));
  EXPECT_EQ(verdict.kind, Monotony::none);
  EXPECT_LT(*verdict.witness, ratio<Q>(1, 1000));
}

TEST(Monotony, TwoIrrationalRootsNearEachOther) {
  // (t^2 - 1/2)(t^2 - 1/2 - 10^-12): negative on an interval of length 7e-13.
  const Q tiny = Q(1) / Q(1000000000000);
  const Polynomial<Q> f(std::vector<Q>{ratio<Q>(-1, 2), Q(0), Q(1)});
  const Mapping<Q> sigma = with_slope(f * (f - Polynomial<Q>::constant(tiny)));
  const MonotonyVerdict verdict = decide_monotony(sigma);
  ASSERT_EQ(verdict.kind, Monotony::none);
  EXPECT_LT(mapping_slope(sigma, *verdict.witness), Q(0));
}

/// An irrational root of the slope just behind the begin or before the end of a piece, with another one on either side
/// of the domain: the slope is negative from there to the end of the piece.
TEST(Monotony, IrrationalRootsNextToTheEnds) {
  const Q tiny = Q(1) / Q(1LL << 45);
  for (const Q& bend : {ratio<Q>(1, 7), ratio<Q>(-1, 7)}) {
    // t - tiny + bend t^2, and the same for 1 - t.
    const Polynomial<Q> f(std::vector<Q>{-tiny, Q(1), bend});
    const MonotonyVerdict begin = decide_monotony(with_slope(f));
    ASSERT_EQ(begin.kind, Monotony::none);
    EXPECT_LT(Q(0), *begin.witness);
    EXPECT_LT(f(*begin.witness), Q(0));
    const Polynomial<Q> g(std::vector<Q>{Q(1) - tiny + bend, -Q(1) - Q(2) * bend, bend});
    const MonotonyVerdict end = decide_monotony(with_slope(g));
    ASSERT_EQ(end.kind, Monotony::none);
    EXPECT_LT(*end.witness, Q(1));
    EXPECT_LT(g(*end.witness), Q(0));
  }
}

/// The same on a piece that is not [0, 1], between others.
TEST(Monotony, TheWitnessIsInItsPiece) {
  const Mapping<Q> sigma =
      mapping_of(KnotList<Q>(2, {Q(0), Q(0), Q(3), Q(5), Q(9), Q(9)}), {Q(0), Q(3), Q(2), Q(4), Q(5)});
  const MonotonyVerdict verdict = decide_monotony(sigma);
  ASSERT_EQ(verdict.kind, Monotony::none);
  EXPECT_LT(Q(0), *verdict.witness);
  EXPECT_LT(*verdict.witness, Q(3));
  EXPECT_LT(mapping_slope(sigma, *verdict.witness), Q(0));
}

TEST(Monotony, ConstantPiecesAreWeak) {
  const KnotList<Q> u(2, {Q(0), Q(0), Q(1), Q(2), Q(3), Q(3)});
  const MonotonyVerdict verdict = decide_monotony(mapping_of(u, {Q(0), Q(1), Q(1), Q(1), Q(2)}));
  EXPECT_EQ(verdict.kind, Monotony::weak);
  EXPECT_EQ(*verdict.witness, ratio<Q>(3, 2));
  EXPECT_EQ(decide_monotony(mapping_of(u, {Q(0), Q(1), Q(1), Q(1), Q(0)})).kind, Monotony::none);
}

TEST(Monotony, DrawnCubicsAgainstTheirDiscriminant) {
  // The slope a s^2 + 2 b s t + c t^2 is negative inside iff a < 0 or c < 0 or b < -sqrt(ac).
  std::mt19937_64 rng(5);
  int strict = 0;
  for (int round = 0; round < 300; ++round) {
    const int a = static_cast<int>(rng() % 12) - 1;
    const int b = static_cast<int>(rng() % 16) - 8;
    const int c = static_cast<int>(rng() % 12) - 1;
    const Mapping<Q> sigma = bezier({Q(0), Q(a), Q(a + b), Q(a + b + c)});
    const bool falls = a < 0 || c < 0 || (b < 0 && b * b > a * c);
    const bool constant = a == 0 && b == 0 && c == 0;
    const Monotony expected = falls ? Monotony::none : constant ? Monotony::weak : Monotony::strict;
    EXPECT_EQ(decide_monotony(sigma).kind, expected) << a << ' ' << b << ' ' << c;
    strict += expected == Monotony::strict ? 1 : 0;
  }
  EXPECT_GT(strict, 50);
}

}  // namespace
}  // namespace torse
