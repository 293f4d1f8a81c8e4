// Snapped mappings: exact values at the crossings, small changes, smoothness, order, and Algorithm 1 on top of them.
#include "torse/exact/quasi/snap.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "support/refusal.hpp"
#include "torse/exact/quasi/monotony.hpp"
#include "torse/quasi/preimages.hpp"
#include "torse/quasi/surface.hpp"
#include "torse/spline/compatible.hpp"

namespace torse {
namespace {

using Q = Rational;

KnotList<Q> uniform(int degree, int pieces) {
  std::vector<Q> list(static_cast<std::size_t>(degree), Q(0));
  for (int i = 1; i < pieces; ++i) list.push_back(ratio<Q>(i, pieces));
  list.insert(list.end(), static_cast<std::size_t>(degree), Q(1));
  return KnotList<Q>(degree, list);
}

/// Steps drawn from 0..9, so that some coefficients are equal.
Mapping<Q> drawn(const KnotList<Q>& u, std::uint64_t seed) {
  std::mt19937_64 rng(seed);
  std::vector<Q> beta{Q(0)};
  for (int i = 1; i <= u.last(); ++i) beta.push_back(beta.back() + Q(static_cast<int>(rng() % 10)));
  for (Q& b : beta) b = Q::from_double((b / beta.back()).to_double());
  return mapping_of(u, beta);
}

const Q relative = Q(1) / Q(1LL << 40);

void expect_result(const SnappedMapping& result, const Mapping<Q>& sigma, const KnotList<Q>& of_c2,
                   const Q& tolerance) {
  const Mapping<Q>& fine = result.sigma;
  std::vector<Q> passed;
  for (const Q& t : result.parameters) {
    EXPECT_TRUE(std::ranges::find(fine.knots.list(), t) != fine.knots.list().end());
    passed.push_back(mapping_value(fine, t));
  }
  std::vector<Q> inner;
  for (const Q& v : of_c2.list()) {
    if (fine.control.front()[0] < v && v < fine.control.back()[0] && (inner.empty() || inner.back() < v))
      inner.push_back(v);
  }
  EXPECT_EQ(passed, inner);
  EXPECT_FALSE(tolerance * (of_c2.domain_end() - of_c2.domain_begin()) < result.change);
  EXPECT_NE(decide_monotony(fine).kind, Monotony::none);
  if (definitely(monotone(sigma))) {
    EXPECT_EQ(monotone(fine), Truth::yes);
  }
  for (int i = 0; i <= 60; ++i) {
    const Q t = sigma.knots.domain_begin() + ratio<Q>(i, 60) * (sigma.knots.domain_end() - sigma.knots.domain_begin());
    const Q difference = mapping_value(fine, t) - mapping_value(sigma, t);
    EXPECT_FALSE(result.change < difference || difference < -result.change);
  }
  for (const Q& t : fine.knots.list()) {  // no knot is repeated that was not
    if (!(fine.knots.domain_begin() < t && t < fine.knots.domain_end())) continue;
    EXPECT_EQ(multiplicity(fine.knots, t), std::max(1, multiplicity(sigma.knots, t)));
  }
}

void expect_snapped(const Mapping<Q>& sigma, const KnotList<Q>& of_c1, const KnotList<Q>& of_c2) {
  expect_result(snapped(sigma, of_c1, of_c2), sigma, of_c2, relative);
}

TEST(Snapped, DrawnMappings) {
  for (int degree = 1; degree <= 4; ++degree) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      expect_snapped(drawn(uniform(degree, 12), seed), uniform(3, 5), uniform(3, 7));
    }
  }
}

/// With much room a first trial may take coefficients past each other: they rise all the same.
TEST(Snapped, WideTolerances) {
  int answers = 0;
  for (int degree = 1; degree <= 5; ++degree) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      const Mapping<Q> sigma = drawn(uniform(degree, 1 + static_cast<int>(seed % 5)), seed);
      const Q tolerance = Q(1) / Q(1LL << (2 + seed % 7));
      try {
        expect_result(snapped(sigma, uniform(3, 2), uniform(3, 7), tolerance), sigma, uniform(3, 7), tolerance);
        ++answers;
      } catch (const Undecided&) {
      }
    }
  }
  EXPECT_GT(answers, 150);
}

TEST(Snapped, AKnotOfC2BetweenAnyTwoOfTheMapping) {
  for (int degree = 1; degree <= 3; ++degree) {
    const Mapping<Q> sigma = drawn(uniform(degree, 5), 3);
    expect_snapped(sigma, uniform(3, 1), uniform(3, 60));
    std::size_t longest = 0;
    for (const Q& b : coefficients(snapped(sigma, uniform(3, 1), uniform(3, 60)).sigma)) {
      longest = std::max(longest, b.numerator_bits() + b.denominator_bits());
    }
    EXPECT_LT(longest, 2500U) << degree;
  }
}

TEST(Snapped, KnotsThatArePassedNearAMarkAreTakenThere) {
  Mapping<Q> sigma = identity_mapping(uniform(2, 4));
  sigma.control[2][0] += Q(1) / Q(1LL << 50);
  const SnappedMapping result = snapped(sigma, uniform(3, 6), uniform(3, 12));
  ASSERT_EQ(result.parameters.size(), 11U);
  for (int i = 1; i < 12; ++i) {
    const bool mark = i % 2 == 0 || i % 3 == 0;
    EXPECT_EQ(result.parameters[static_cast<std::size_t>(i - 1)] == ratio<Q>(i, 12), mark) << i;
  }
  expect_snapped(sigma, uniform(3, 6), uniform(3, 12));
}

TEST(Snapped, TheLastKnotLeavesTheLevelEndAlone) {
  // Three knots in a row share their coefficients; the last two coefficients are equal, so the last knot's may not
  // grow.
  const Mapping<Q> sigma = mapping_of(uniform(2, 1), {Q(0), ratio<Q>(247, 312), ratio<Q>(247, 312)});
  const KnotList<Q> of_c2(1, {Q(0), ratio<Q>(1, 13), ratio<Q>(4, 13), ratio<Q>(8, 13), Q(1)});
  expect_snapped(sigma, uniform(3, 1), of_c2);
}

TEST(Snapped, NothingToDo) {
  const Mapping<Q> sigma = drawn(uniform(2, 7), 9);
  const SnappedMapping result = snapped(sigma, uniform(3, 4), uniform(3, 1));
  EXPECT_EQ(coefficients(result.sigma), coefficients(sigma));
  EXPECT_EQ(result.change, Q(0));
  EXPECT_TRUE(result.parameters.empty());
}

TEST(Snapped, EndsAreTakenToKnotsOfTheSecondRail) {
  const Q tiny = Q(1) / Q(1LL << 45);
  const Mapping<Q> sigma = mapping_of(uniform(2, 2), {-tiny, ratio<Q>(1, 8), ratio<Q>(1, 3), ratio<Q>(1, 2) + tiny});
  const SnappedMapping result = snapped(sigma, uniform(1, 1), uniform(3, 4));
  EXPECT_EQ(result.sigma.control.front()[0], Q(0));
  EXPECT_EQ(result.sigma.control.back()[0], ratio<Q>(1, 2));
  EXPECT_EQ(result.parameters.size(), 1U);
  const Mapping<Q> beyond = mapping_of(uniform(1, 1), {Q(0), ratio<Q>(9, 8)});
  EXPECT_THROW(snapped(beyond, uniform(1, 1), uniform(3, 4)), InvalidInput);
  EXPECT_THROW(snapped(mapping_of(uniform(1, 1), {Q(1), Q(0)}), uniform(1, 1), uniform(3, 4)), InvalidInput);
  EXPECT_THROW(snapped(sigma, uniform(1, 1), uniform(3, 4), Q(0)), InvalidInput);
}

/// Ends at all distances from a knot of the second rail. Some of them are too far from it to be taken there within
/// 2^-40 and too near to leave room for a coefficient in between.
TEST(Snapped, EndsAreAtAnyDistanceFromAKnot) {
  int wider = 0;
  for (int degree = 1; degree <= 4; ++degree) {
    for (int exponent = 36; exponent <= 43; ++exponent) {
      for (const int part : {-3, -2, -1, 1, 2, 3}) {
        std::vector<Q> beta;
        const KnotList<Q> u = uniform(degree, 4);
        for (int i = 0; i <= u.last(); ++i) beta.push_back(ratio<Q>(i, 2 * u.last()));
        beta.back() += Q(part) / Q(1LL << exponent);
        const Mapping<Q> sigma = mapping_of(u, beta);
        const SnappedMapping result = snapped(sigma, uniform(1, 1), uniform(3, 4));
        std::vector<Q> passed;
        for (const Q& t : result.parameters) passed.push_back(mapping_value(result.sigma, t));
        EXPECT_EQ(passed, inner_values(result.sigma, uniform(3, 4)));
        EXPECT_NE(decide_monotony(result.sigma).kind, Monotony::none);
        EXPECT_LE(result.change, Q(1) / Q(1LL << 30));
        for (int i = 0; i <= 20; ++i) {
          const Q t = ratio<Q>(i, 20);
          const Q moved = mapping_value(result.sigma, t) - mapping_value(sigma, t);
          EXPECT_FALSE(result.change < moved || moved < -result.change);
        }
        if (relative < result.change) ++wider;
      }
    }
  }
  EXPECT_GT(wider, 0) << "no case needs the wider tolerance";
  EXPECT_LT(wider, 40);
}

TEST(Snapped, LevelPartsOnAndNearKnotsOfTheSecondRail) {
  const Q tiny = Q(1) / Q(1LL << 46);
  for (const Q& level : {ratio<Q>(1, 3), ratio<Q>(1, 3) + tiny, ratio<Q>(1, 3) - tiny, ratio<Q>(2, 5)}) {
    const Mapping<Q> sigma = mapping_of(uniform(2, 4), {Q(0), ratio<Q>(1, 9), level, level, level, Q(1)});
    expect_snapped(sigma, uniform(3, 1), uniform(3, 3));
    EXPECT_EQ(strictly_monotone(snapped(sigma, uniform(3, 1), uniform(3, 3)).sigma), strictly_monotone(sigma));
  }
}

TEST(Snapped, SteepLevelAndFarAway) {
  // Nearly a jump at 1/2, domains far from [0, 1], a mapping that is not clamped, a cubic whose coefficients fall.
  expect_snapped(mapping_of(uniform(2, 1), {Q(0), Q(0), Q(1)}), uniform(3, 1), uniform(3, 9));
  const Q tiny = Q(1) / Q(1LL << 60);
  const KnotList<Q> jump(1, {Q(0), ratio<Q>(1, 2), ratio<Q>(1, 2) + tiny, Q(1)});
  expect_snapped(mapping_of(jump, {Q(0), ratio<Q>(1, 10), ratio<Q>(9, 10), Q(1)}), uniform(3, 1), uniform(3, 5));
  const KnotList<Q> huge(3, {Q(-3), Q(-2), Q(0), Q(1LL << 50), Q(1LL << 51), Q(1LL << 52)});
  const KnotList<Q> small(3, {Q(0), Q(0), Q(0), tiny / Q(3), tiny, tiny, tiny});
  expect_snapped(mapping_of(huge, {Q(0), tiny / Q(5), tiny / Q(2), tiny}), huge, small);
  expect_snapped(mapping_of(uniform(3, 1), {Q(0), ratio<Q>(5, 9), ratio<Q>(4, 9), Q(1)}), uniform(3, 1), uniform(3, 4));
}

/// Knots of C2 beyond its domain are no ends that a mapping may have, and no tolerance of 0 is met.
TEST(Snapped, RefusesWhatIsNoQuestion) {
  const KnotList<Q> unclamped(2, {Q(0), Q(1), Q(2), Q(3)});
  const auto place = [&](const Q& first, const Q& last, const Q& tolerance) {
    return test::place_of([&] {
      return snapped(mapping_of(uniform(1, 1), {first, last}), uniform(1, 1), unclamped, tolerance);
    });
  };
  EXPECT_EQ(place(Q(1), Q(2), relative), "");
  EXPECT_EQ(place(Q(1), Q(3), relative), "sigma");
  EXPECT_EQ(place(Q(0), Q(2), relative), "sigma");
  EXPECT_EQ(place(Q(1), Q(2), Q(0)), "tolerance");
  EXPECT_EQ(place(Q(1), Q(2), -relative), "tolerance");
}

TEST(Snapped, AlgorithmOneIsExactOnIt) {
  // The worked example of BZZ19's Fig. 4: p = 3, 5 points, a quadratic mapping with 10 coefficients.
  const KnotList<Q> rails = uniform(3, 2);
  std::vector<Q> list{Q(0), Q(0)};
  for (int i : {3, 5, 7, 9, 11, 13, 15}) list.push_back(ratio<Q>(i, 18));
  list.insert(list.end(), {Q(1), Q(1)});
  const Mapping<Q> sigma = drawn(KnotList<Q>(2, list), 5);
  using P = Vec<Q, 3>;
  std::mt19937_64 rng(6);
  const auto rail = [&] {
    std::vector<P> row;
    for (int i = 0; i < 5; ++i) {
      const auto draw = [&] { return Q(static_cast<int>(rng() % 100)); };
      const Q x = draw();
      const Q y = draw();
      row.push_back(P(x, y, draw()));
    }
    return Spline<Q, P>(rails, row);
  };
  const Spline<Q, P> c1 = rail();
  const Spline<Q, P> c2 = rail();
  const Mapping<Q> fine = snapped(sigma, rails, rails).sigma;
  const RuledSpline<Q, P> surface = quasi_surface(c1, c2, fine);
  EXPECT_EQ(surface.knots.degree(), 6);
  EXPECT_EQ(surface.c.size(), 55U);
  for (int k : surface.knots.proper_pieces()) {
    for (int i = 0; i <= 6; ++i) {
      const Q t =
          surface.knots.piece_begin(k) + ratio<Q>(i, 6) * (surface.knots.piece_end(k) - surface.knots.piece_begin(k));
      const Q value = mapping_value(fine, t);
      EXPECT_EQ((curve_point<Q, P>(surface.knots, surface.d_row(), k, t)),
                (curve_point<Q, P>(rails, c2.points(), piece_at(rails, value), value)));
    }
  }
}

}  // namespace
}  // namespace torse
