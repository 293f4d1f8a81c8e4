// Descents on functions of which all is known: where they end, after how many steps, and what is kept fixed.
#include "torse/exact/repair/descent.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace torse::repair {
namespace {

Real real(long p, long q = 1) { return Real::from_rational(Rational(p) / Rational(q)); }

Projection<3> projection(const Real& squared, std::vector<Real> slope, const std::vector<Real>& diagonal) {
  Projection<3> result{squared, {}, std::move(slope), zero_matrix(diagonal.size())};
  for (std::size_t m = 0; m < diagonal.size(); ++m) result.curvature[m][m] = diagonal[m];
  return result;
}

/// (y - 3/10)^2 + 1 for the constants (x, y), with a slope along x, which is 1 throughout and so has to stay as it is.
std::optional<Projection<3>> valley(const std::vector<Real>& theta) {
  const Real e = theta[1] - real(3, 10);
  return projection(e * e + real(1), {real(5), e}, {real(1), real(1)});
}

TEST(Descent, TheLargestConstantOfAGroupStaysFixed) {
  const auto descent = descend<3>(valley, {real(2), real(1)}, 2, real(1));
  ASSERT_TRUE(descent);
  EXPECT_TRUE(descent->converged);
  EXPECT_EQ(descent->theta[0], real(1));
  EXPECT_LT(magnitude(descent->theta[1] - real(3, 10)), real(1, 1000));
  EXPECT_EQ(descent->fixed, (std::vector<std::size_t>{0}));
}

/// The constants are known up to a factor of each group.
TEST(Descent, EveryGroupIsDividedByItsLargest) {
  const auto flat = [](const std::vector<Real>& theta) {
    return std::optional(projection(real(0), std::vector<Real>(theta.size()), std::vector<Real>(theta.size())));
  };
  const auto descent = descend<3>(flat, {real(1), real(-4), real(3), real(2)}, 2, real(1));
  ASSERT_TRUE(descent);
  EXPECT_TRUE(descent->converged);
  EXPECT_EQ(descent->fixed, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(descent->theta, (std::vector<Real>{real(-1, 4), real(1), real(1), real(2, 3)}));
}

/// One whose curvature is zero does not keep the others from their minimum.
TEST(Descent, AConstantWithoutInfluenceDoesNotMatter) {
  const auto partly = [](const std::vector<Real>& theta) {
    const Real e = theta[1] - real(1, 4);
    return std::optional(projection(e * e + real(1), {real(0), e, real(0)}, {real(1), real(1), real(0)}));
  };
  const auto descent = descend<3>(partly, {real(1), real(1, 2), real(1, 2)}, 3, real(1));
  ASSERT_TRUE(descent);
  EXPECT_TRUE(descent->converged);
  EXPECT_LT(magnitude(descent->theta[1] - real(1, 4)), real(1, 1000));
}

/// A slope that promises what no step holds: the damping grows until it is of no use, which is no convergence although
/// the promise gets small.
TEST(Descent, NoConvergenceByDampingAlone) {
  int calls = 0;
  const auto uphill = [&](const std::vector<Real>&) {
    ++calls;
    return std::optional(projection(real(calls), {real(0), real(1)}, {real(1), real(1)}));
  };
  const auto descent = descend<3>(uphill, {real(1), real(1, 2)}, 2, real(1));
  ASSERT_TRUE(descent);
  EXPECT_FALSE(descent->converged);
  EXPECT_EQ(descent->nearest.squared, real(1));
  EXPECT_EQ(calls, 23);  // at the start, and with damping 2^-20, 2^-16, ..., 2^64
}

/// Each step gains a thousandth: with a rival far below the search ends after 10 steps, without one after 100.
TEST(Descent, ARivalFarBelowEndsIt) {
  for (const auto& [rival, steps] : {std::pair(real(1, 1L << 30), 10), std::pair(real(1), 100)}) {
    int calls = 0;
    const auto slow = [&](const std::vector<Real>&) {
      Real squared = real(1);
      for (int i = 0; i < calls; ++i) squared *= real(999, 1000);
      ++calls;
      return std::optional(projection(squared, {real(1), real(1)}, {real(1), real(1)}));
    };
    const auto descent = descend<3>(slow, {real(1), real(1, 2)}, 2, rival);
    ASSERT_TRUE(descent);
    EXPECT_EQ(calls, steps + 1);
    EXPECT_FALSE(descent->converged);
  }
}

TEST(Descent, ADistanceOfRoundingErrorsIsZero) {
  EXPECT_EQ(negligible_distance(), Real::from_rational(power_of_two(20 - 2 * Real::precision)));
  int calls = 0;
  const auto near = [&](const std::vector<Real>&) {
    ++calls;
    return std::optional(projection(negligible_distance(), {real(0), real(1)}, {real(1), real(1)}));
  };
  const auto descent = descend<3>(near, {real(1), real(1, 2)}, 2, real(1));
  ASSERT_TRUE(descent);
  EXPECT_TRUE(descent->converged);
  EXPECT_EQ(calls, 2);
}

}  // namespace
}  // namespace torse::repair
