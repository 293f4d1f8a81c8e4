// Mappings: the derivative by its own B-spline against blossoms, Greville abscissae, and what coefficients tell of
// monotony against values.
#include "torse/quasi/mapping.hpp"

#include <gtest/gtest.h>

#include <random>

#include "../spline/splines.hpp"

namespace torse::test {
namespace {

Mapping<Q> drawn(const KnotList<Q>& u, std::uint64_t seed) {
  std::vector<Q> beta;
  for (const Point2& p : points(u, seed)) beta.push_back(p[0]);
  return mapping_of(u, beta);
}

Mapping<Q> with(const KnotList<Q>& u, const std::vector<int>& beta) {
  std::vector<Q> list;
  for (int b : beta) list.push_back(Q(b));
  return mapping_of(u, list);
}

TEST(Mapping, StepsAreSquaredAndSummed) {
  const std::vector<Q> steps{Q(1), Q(-2), Q(0), ratio<Q>(1, 2)};
  EXPECT_EQ(coefficients_from_steps<Q>(steps), (std::vector<Q>{Q(1), Q(5), Q(5), ratio<Q>(21, 4)}));
}

TEST(Mapping, TheIdentityOverAnyKnots) {
  for (const KnotList<Q>& u : knot_lists()) {
    const Mapping<Q> sigma = identity_mapping(u);
    for (const Q& t : parameters(u)) {
      EXPECT_EQ(mapping_value(sigma, t), t);
      EXPECT_EQ(mapping_slope(sigma, t), Q(1));
    }
    EXPECT_EQ(monotone(sigma), Truth::yes);
    EXPECT_EQ(strictly_monotone(sigma), Truth::yes);
  }
}

TEST(Mapping, TheDerivativeByItsOwnBasisIsThatOfTheBlossom) {
  for (const KnotList<Q>& u : knot_lists()) {
    const Mapping<Q> sigma = drawn(u, 7);
    for (int k : u.proper_pieces()) {
      for (int i = 0; i <= 4; ++i) {
        const Q t = u.piece_begin(k) + ratio<Q>(i, 4) * (u.piece_end(k) - u.piece_begin(k));
        EXPECT_EQ((derivative_sum<Q, Vec<Q, 1>>(u, sigma.points(), k, t)[0]),
                  (curve_derivative<Q, Vec<Q, 1>>(u, sigma.points(), k, t)[0]));
      }
    }
  }
}

TEST(Mapping, PiecesAndEnds) {
  const KnotList<Q> u = knots(2, {0, 0, 1, 1, 2, 2});
  EXPECT_EQ(piece_at(u, Q(0)), 1);
  EXPECT_EQ(piece_at(u, Q(1)), 3);
  EXPECT_EQ(piece_at(u, Q(2)), 3);
  EXPECT_THROW(piece_at(u, Q(3)), InvalidInput);
  const Mapping<Q> corner = with(u, {0, 1, 4, 5, 6});
  EXPECT_EQ(mapping_value(corner, Q(1)), Q(4));
  EXPECT_EQ(mapping_slope(corner, Q(1)), Q(2));
  EXPECT_EQ(coefficients(corner), (std::vector<Q>{Q(0), Q(1), Q(4), Q(5), Q(6)}));
}

TEST(Mapping, QuadraticCoefficientsDecideMonotony) {
  int falls = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    for (const KnotList<Q>& u : {knots(2, {0, 0, 1, 2, 2}), knots(2, {0, 1, 1, 2, 3}), knots(1, {0, 1, 3, 4})}) {
      std::mt19937_64 rng(seed);
      std::vector<Q> beta{Q(0)};
      for (int i = 1; i <= u.last(); ++i) beta.push_back(beta.back() + Q(static_cast<int>(rng() % 8) - 1));
      const Mapping<Q> sigma = mapping_of(u, beta);
      bool rises = true;  // the slope of a piece is linear: its ends tell
      for (int k : u.proper_pieces()) {
        for (const Q& t : {u.piece_begin(k), u.piece_end(k)}) {
          rises = rises && curve_derivative<Q, Vec<Q, 1>>(u, sigma.points(), k, t)[0].sign() >= 0;
        }
      }
      EXPECT_EQ(monotone(sigma), truth(rises));
      falls += rises ? 0 : 1;
    }
  }
  EXPECT_GT(falls, 10);
}

TEST(Mapping, OneFallingCoefficientLeavesACubicOpen) {
  const KnotList<Q> u = bezier_knots<Q>(3);
  const Mapping<Q> rising = with(u, {0, 5, 4, 9});  // slope 3 (5, -1, 5): at the middle 3 (5/4 - 1/2 + 5/4)
  EXPECT_EQ(monotone(rising), Truth::unknown);
  EXPECT_EQ(monotone(with(u, {0, 1, 1, 2})), Truth::yes);
}

TEST(Mapping, ConstantPiecesAreNotStrict) {
  const KnotList<Q> u = knots(2, {0, 0, 1, 2, 3, 3});
  EXPECT_EQ(strictly_monotone(with(u, {0, 1, 1, 1, 2})), Truth::no);  // constant on the second piece
  EXPECT_EQ(strictly_monotone(with(u, {0, 1, 1, 2, 2})), Truth::yes);
  EXPECT_EQ(monotone(with(u, {0, 1, 1, 1, 2})), Truth::yes);
  EXPECT_EQ(strictly_monotone(with(u, {0, 2, 1, 1, 2})), Truth::no);
  for (const std::vector<int>& level : {std::vector<int>{0, 1, 1, 1}, {0, 0, 1, 1}, {0, 0, 0, 1}}) {
    EXPECT_EQ(strictly_monotone(with(bezier_knots<Q>(3), level)), Truth::yes);
  }
  EXPECT_EQ(strictly_monotone(with(bezier_knots<Q>(3), {1, 1, 1, 1})), Truth::no);
}

TEST(Mapping, NumbersOfCoefficientsMustFit) { EXPECT_THROW(with(knots(2, {0, 0, 1, 1}), {0, 1}), InvalidInput); }

}  // namespace
}  // namespace torse::test
