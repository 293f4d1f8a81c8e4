// The steps of snapping: a short parameter before each value, and coefficients that make it the value's own.
#include "torse/exact/quasi/crossing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "support/knots.hpp"
#include "torse/exact/repair/real.hpp"

namespace torse::quasi {
namespace {

using Q = Rational;
using repair::power_of_two;

Q q(int num, int den = 1) { return ratio<Q>(num, den); }

/// Knots 0 and 1 d-fold, and those inside.
KnotList<Q> clamped(int degree, const std::vector<Q>& inside) {
  std::vector<Q> list(static_cast<std::size_t>(degree), Q(0));
  list.insert(list.end(), inside.begin(), inside.end());
  list.insert(list.end(), static_cast<std::size_t>(degree), Q(1));
  return KnotList<Q>(degree, list);
}

TEST(Exponent, IsThatOfAPowerOfTwoLessThanAFactorOfTwoAway) {
  for (int num = 1; num <= 40; ++num) {
    for (int den = 1; den <= 40; ++den) {
      const long e = exponent_of(q(num, den));
      EXPECT_LT(power_of_two(e - 1), q(num, den));
      EXPECT_LT(q(num, den), power_of_two(e + 1));
    }
  }
  EXPECT_EQ(exponent_of(Q(1)), 0);
  EXPECT_EQ(exponent_of(q(8)), 3);
  EXPECT_EQ(exponent_of(q(1, 4)), -2);
}

/// t is a multiple of the power or the begin of the piece, sigma(t) is not above the value, but sigma is at the next
/// multiple and at the end of the piece.
TEST(LastBelow, IsTheLastMultiple) {
  const KnotList<Q> u = clamped(2, {q(1, 3), q(1, 2)});
  for (const std::vector<Q>& beta :
       {std::vector<Q>{q(0), q(1, 9), q(1, 3), q(1, 2), q(1)}, std::vector<Q>{q(0), q(0), q(0), q(0), q(1)},
        std::vector<Q>{q(0), q(1), q(1), q(1), q(1)}, std::vector<Q>{q(-7), q(1), q(1), q(4), q(9)}}) {
    const Mapping<Q> sigma = mapping_of(u, beta);
    for (int i = 0; i < 40; ++i) {
      const Q value = beta.front() + q(i, 40) * (beta.back() - beta.front());
      for (const Q& share : {q(1, 8), q(1, 1000), power_of_two(-50)}) {
        const Q t = last_below(sigma, value, share);
        const int k = piece_at(u, t);
        const long exponent = exponent_of((u.piece_end(k) - u.piece_begin(k)) * share);
        EXPECT_TRUE(t == u.piece_begin(k) || repair::rounded(t, exponent) == t);
        EXPECT_FALSE(value < mapping_value(sigma, t));
        const Q next = repair::rounded(t + power_of_two(exponent - 1), exponent);
        EXPECT_LT(t, next);
        EXPECT_LT(value, mapping_value(sigma, std::min(next, u.piece_end(k)))) << i;
      }
    }
  }
}

/// The last parameter of a level part, and of the part up to a knot.
TEST(LastBelow, KnownPlaces) {
  const Mapping<Q> steps = mapping_of(clamped(1, {q(1, 4), q(3, 4)}), {q(0), q(1, 2), q(1, 2), q(1)});
  EXPECT_EQ(last_below(steps, q(1, 2), q(1, 16)), q(3, 4)) << "the level ends there";
  EXPECT_EQ(last_below(steps, q(1, 4), q(1, 16)), q(1, 8));
  EXPECT_EQ(last_below(steps, q(0), q(1, 16)), q(0));
  EXPECT_EQ(last_below(steps, q(5, 8), q(1, 16)), q(13, 16));
  // t^2 = 1/2 at 0.70710..., 724.08 / 1024.
  EXPECT_EQ(last_below(mapping_of(clamped(2, {}), {q(0), q(0), q(1)}), q(1, 2), q(1, 1024)), q(724, 1024));
  // All multiples of 1/16 in the second piece [0.51, 1] are at 0.5625 or later, where sigma is 0.5625.
  const Mapping<Q> straight = mapping_of(clamped(1, {q(51, 100)}), {q(0), q(51, 100), q(1)});
  EXPECT_EQ(last_below(straight, q(53, 100), q(1, 8)), q(51, 100)) << "no multiple, but the begin of the piece";
}

TEST(WeightsAt, AreTheBasisFunctions) {
  // A quadratic over 0, 1/4, 1: at 1/4 the weights of beta_1 and beta_2 are (1 - 1/4) / 1 and (1/4 - 0) / 1.
  const KnotList<Q> u = clamped(2, {q(1, 4)});
  const Form<Q> weights = weights_at(u, q(1, 4));
  EXPECT_EQ(weights.coefficient(0), q(0));
  EXPECT_EQ(weights.coefficient(1), q(3, 4));
  EXPECT_EQ(weights.coefficient(2), q(1, 4));
  EXPECT_EQ(weights.coefficient(3), q(0));
}

std::vector<Q> fitted(const KnotList<Q>& u, const std::vector<Q>& beta, const std::vector<Crossing>& crossings) {
  Mapping<Q> sigma = mapping_of(u, beta);
  fit_coefficients(sigma, crossings);
  for (const Crossing& crossing : crossings) EXPECT_EQ(mapping_value(sigma, crossing.t), crossing.value);
  return coefficients(sigma);
}

/// The column that changes for one crossing.
int changed(const KnotList<Q>& u, const std::vector<Q>& beta, const Crossing& crossing) {
  const std::vector<Q> after = fitted(u, beta, {crossing});
  const auto [old_place, place] = std::ranges::mismatch(beta, after);
  EXPECT_TRUE(std::equal(old_place + 1, beta.end(), place + 1)) << "only one";
  return static_cast<int>(place - after.begin());
}

/// At the knot 1/4 of a cubic the coefficients 1, 2, 3 have the weights 9/16, 6/16 and 1/16.
TEST(FitCoefficients, RoomAndWeightDecide) {
  const KnotList<Q> u = clamped(3, {q(1, 4)});
  const auto column = [&](int sign, std::vector<Q> inner) {
    std::vector<Q> beta{q(0)};
    beta.insert(beta.end(), inner.begin(), inner.end());
    beta.push_back(q(16));
    const Q value = mapping_value(mapping_of(u, beta), q(1, 4)) + q(sign) * power_of_two(-70);
    return changed(u, beta, {q(1, 4), value});
  };
  for (const int sign : {-1, 1}) {
    EXPECT_EQ(column(sign, {q(4), q(8), q(12)}), 1) << "room 4 for all";
    EXPECT_EQ(column(sign, {q(1), q(8), q(12)}), 2) << "room 1, 4, 4";
    EXPECT_EQ(column(sign, {q(31, 4), q(8), q(12)}), 3) << "room 1/4, 1/4, 4";
    EXPECT_EQ(column(sign, {q(4), q(8), q(16)}), 1) << "room 4, 4 and none";
    EXPECT_EQ(column(sign, {q(8), q(4), q(12)}), 1) << "falling coefficients are not level";
    EXPECT_EQ(column(sign, {power_of_two(-60), q(4), q(4)}), 1) << "little room, but on both sides";
  }
  EXPECT_EQ(column(1, {q(0), q(4), q(4)}), 1) << "4 and 12 above the first and the last";
  EXPECT_EQ(column(1, {q(0), q(1, 2), q(1, 2)}), 3) << "1/2 and 31/2 above the first and the last";
  EXPECT_EQ(column(-1, {q(0), q(4), q(4)}), 2) << "the others may not fall";
  EXPECT_EQ(column(-1, {q(0), q(1, 2), q(1, 2)}), 2);
}

/// The largest sum of exponents of weight and room over increasing columns, tried one by one. Weights are differences
/// of values.
struct BestColumns {
  const Mapping<Q>& sigma;
  const std::vector<Crossing>& crossings;

  Q weight(std::size_t i, std::size_t j) const {
    Mapping<Q> more = sigma;
    more.control[j][0] += Q(1);
    return mapping_value(more, crossings[i].t) - mapping_value(sigma, crossings[i].t);
  }

  long exponent(std::size_t i, std::size_t j) const {
    const std::vector<Q> beta = coefficients(sigma);
    return exponent_of(weight(i, j) * std::min(beta[j + 1] - beta[j], beta[j] - beta[j - 1]));
  }

  long sum(std::size_t i, std::size_t first) const {
    if (i == crossings.size()) return 0;
    long best = -1000000;
    for (std::size_t j = first; j + 1 < sigma.control.size(); ++j) {
      if (weight(i, j).sign() != 0) best = std::max(best, exponent(i, j) + sum(i + 1, j + 1));
    }
    return best;
  }
};

TEST(FitCoefficients, TheProductIsAsLargeAsItMayBe) {
  std::mt19937_64 rng(1);
  for (int trial = 0; trial < 60; ++trial) {
    const KnotList<Q> u = clamped(2 + trial % 3, {q(1, 9), q(1, 8), q(1, 2), q(4, 7)});
    std::vector<Q> beta{Q(0)};
    while (static_cast<int>(beta.size()) <= u.last()) {
      beta.push_back(beta.back() + power_of_two(static_cast<long>(rng() % 12)));
    }
    const Mapping<Q> sigma = mapping_of(u, beta);
    std::vector<Crossing> crossings;
    for (const Q& t : {q(1, 9), q(1, 8), q(1, 2), q(4, 7)}) {
      if (rng() % 4 > 0)
        crossings.push_back({t, mapping_value(sigma, t) + power_of_two(-70 + static_cast<long>(rng() % 9))});
    }
    if (crossings.empty()) continue;
    const std::vector<Q> after = fitted(u, beta, crossings);
    const BestColumns best{sigma, crossings};
    long reached = 0;
    std::size_t i = 0;
    for (std::size_t j = 0; j < beta.size(); ++j) {
      if (after[j] == beta[j]) continue;
      ASSERT_LT(i, crossings.size());
      reached += best.exponent(i++, j);
    }
    ASSERT_EQ(i, crossings.size());
    EXPECT_EQ(reached, best.sum(0, 1)) << trial;
  }
}

}  // namespace
}  // namespace torse::quasi
