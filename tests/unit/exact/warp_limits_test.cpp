// The certified warp angle where a search has its limits: budgets that run out, rulings and normals that vanish.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "torse/developable/warp.hpp"
#include "unit/exact/warp_nets.hpp"

namespace torse::test {
namespace {

TEST(Warp, SaysSoWhenTheBudgetRunsOut) {
  const Net net = hyperbolic(Q(1), Q(-3), Q(2));
  const WarpEnclosure good = warp_of(net);
  const WarpEnclosure warp = warp_of(net, {.intervals = 1});
  EXPECT_FALSE(warp.complete);
  EXPECT_LE(warp.lower, good.upper);
  EXPECT_GE(warp.upper, good.lower);
  EXPECT_GT(warp.upper - warp.lower, 1e-3 * warp.upper);
  EXPECT_EQ(at_most(net, Q::from_double((good.lower + good.upper) / 2), {.intervals = 1}), Truth::unknown);
}

/// Cylinders that are bent by 1e-12, of two pieces: a budget of no step in balls leaves them open, and what the doubles
/// know is more than nothing. Degree 17 has no quotient in doubles, and then the balls are asked.
TEST(Warp, KeepsTheBestBoundOfPiecesThatStayOpen) {
  for (const int n : {3, 12, 17}) {
    SCOPED_TRACE(n);
    Net net = random_net(n, 2, 3, 7);
    for (std::size_t i = 0; i < net.c.size(); ++i) {
      net.d[i] = Point3(net.c[i][0], net.c[i][1] + Q(5), net.c[i][2] + power(10, -12) * (net.d[i][2] - net.c[i][2]));
    }
    const WarpEnclosure good = warp_of(net);
    const WarpEnclosure warp = warp_of(net, {.intervals = n == 3 ? 400 : 2500});
    EXPECT_FALSE(warp.complete);
    EXPECT_LT(warp.upper, n == 17 ? 1e-6 : 1e-3);
    EXPECT_GE(warp.upper, good.lower);
    EXPECT_LE(warp.lower, good.upper);
  }
}

/// Two cylinders over arcs that nearly have a cusp, bent by 1e-12: the coefficients of the denominator have both signs
/// over a whole piece, so that bounds are known of its parts alone.
TEST(Warp, HalvesPiecesThatStayOpen) {
  Net net{KnotList<Q>(3, {Q(0), Q(0), Q(0), Q(1), Q(1), Q(1), Q(2), Q(2), Q(2)}), {}, {}};
  const std::vector<std::array<int, 2>> corners{{0, 0}, {3, 3}, {1, 3}, {4, 0}, {7, 3}, {5, 3}, {8, 0}};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Q x(corners[i][0]), y(corners[i][1]);
    net.c.push_back(Point3(x, y, Q(0)));
    net.d.push_back(Point3(x + power(10, -12) * Q(static_cast<int>(i % 3)), y, Q(5)));
  }
  const WarpEnclosure good = warp_of(net);
  const WarpEnclosure warp = warp_of(net, {.intervals = 400});
  EXPECT_FALSE(warp.complete);
  EXPECT_LT(warp.upper, 1e-3);
  EXPECT_GE(warp.upper, good.lower);
  EXPECT_LE(warp.lower, good.upper);
}

/// c = (t, 0, 0) and d = c + z(t) (0, 1, t): the rulings vanish with z, and so do both normals.
TEST(Warp, VanishingRulingsAreExcludedAndTheirLimitCounts) {
  // z = t - 1/2: sin^2 = (1/2 - t)^2 / ((1/2 - t)^2 + t^2 + 1), 1/5 at t = 0.
  const Q half = Q(1) / Q(2), zero(0);
  const Row3 c{Point3(zero, zero, zero), Point3(half, zero, zero), Point3(Q(1), zero, zero)};
  const Net net{
      bezier_knots<Q>(2), c, {Point3(zero, -half, zero), Point3(half, zero, -half * half), Point3(Q(1), half, half)}};
  const WarpEnclosure warp = warp_of(net);
  expect_narrow(warp);
  expect_contains(warp, std::asin(std::sqrt(0.2)) / degree);
  EXPECT_EQ(warp.stage, WarpStage::exact);
  ASSERT_EQ(warp.exclusions.size(), 1U);
  EXPECT_EQ(warp.exclusions[0].piece, 1);
  EXPECT_EQ(warp.exclusions[0].lower, half);
  EXPECT_EQ(warp.exclusions[0].upper, half);
}

TEST(Warp, StationaryBoundaryCurvesAreExcluded) {
  // c = (t^2, t^3, 0) has a cusp at 0, d = (t, 2t, 1 + t^2).
  const Q third = Q(1) / Q(3), zero(0);
  const Net net{
      bezier_knots<Q>(3),
      {Point3(zero, zero, zero), Point3(zero, zero, zero), Point3(third, zero, zero), Point3(Q(1), Q(1), zero)},
      {Point3(zero, zero, Q(1)), Point3(third, Q(2) * third, Q(1)), Point3(Q(2) * third, Q(4) * third, Q(4) * third),
       Point3(Q(1), Q(2), Q(2))}};
  const WarpEnclosure warp = warp_of(net);
  expect_narrow(warp);
  ASSERT_EQ(warp.exclusions.size(), 1U);
  EXPECT_EQ(warp.exclusions[0].lower, zero);
  EXPECT_EQ(warp.exclusions[0].upper, zero);
  double most = 0;
  for (int i = 1; i <= 400; ++i) {
    const Q sine2 = pointwise_sine_squared<Q>(net.u, net.c, net.d, 1, Q(i) / Q(400));
    most = std::max(most, std::asin(std::sqrt(sine2.to_double())) / degree);
  }
  EXPECT_LE(most, warp.upper);
  EXPECT_GE(most, warp.lower * 0.98);
}

TEST(Warp, DevelopablePiecesCountAsZero) {
  // A plane piece that collapses, then a twisted one.
  const Q zero(0);
  const KnotList<Q> u(1, {Q(0), Q(1), Q(2)});
  const Net net{u,
                {Point3(zero, zero, zero), Point3(zero, zero, zero), Point3(Q(1), zero, zero)},
                {Point3(zero, Q(1), zero), Point3(zero, Q(1), zero), Point3(Q(1), Q(1), Q(1))}};
  const WarpEnclosure warp = warp_of(net);
  expect_narrow(warp);
  expect_contains(warp, 45);
  EXPECT_EQ(warp.piece, 2);
  EXPECT_TRUE(warp.exclusions.empty());
  const Net flat{u, net.c, net.c};
  EXPECT_EQ(warp_of(flat).upper, 0);
  EXPECT_EQ(warp_of(flat).piece, 0);
}

/// More pieces without a normal than the budgets of balls and rationals cover: they are developable, and that is exact.
TEST(Warp, ManyCollapsedPiecesDoNotUseUpTheBudget) {
  constexpr int pieces = 4000;
  std::vector<Q> knots;
  Net net{bezier_knots<Q>(1), {}, {}};
  for (int i = 0; i <= pieces; ++i) {
    knots.emplace_back(i);
    net.c.push_back(Point3(Q(i == pieces ? 1 : 0), Q(0), Q(0)));
    net.d.push_back(Point3(Q(i == pieces ? 1 : 0), Q(1), Q(i % 2)));
  }
  net.d[pieces - 1][2] = Q(0);
  net.d[pieces][2] = Q(1);
  net.u = KnotList<Q>(1, knots);
  const WarpEnclosure warp = warp_of(net);
  expect_narrow(warp);
  expect_contains(warp, 45);
  EXPECT_EQ(warp.piece, pieces);
}

/// Vanishing rulings in more pieces than the budgets of balls and rationals cover: the bounds hold and say so.
TEST(Warp, TooManyVanishingRulingsEndTheSearch) {
  constexpr int pieces = 4000;
  const Q half = Q(1) / Q(2);
  std::vector<Q> knots;
  Net net{bezier_knots<Q>(2), {}, {}};
  for (int i = 0; i <= pieces; ++i) knots.insert(knots.end(), 2, Q(i));
  for (int i = 0; i <= 2 * pieces;
       ++i) {  // d - c = (t - 1/2) (0, 1, t) on even pieces, turned by half a turn on odd ones
    const Q x = Q(i) / Q(2);
    net.c.push_back(Point3(x, Q(0), Q(0)));
    const int corner = i % 4;
    const Q y = corner == 0 ? -half : corner == 2 ? half : Q(0);
    const Q z = corner == 1 ? -half * half : corner == 2 ? half : corner == 3 ? half * half : Q(0);
    net.d.push_back(Point3(x, y, z));
  }
  net.u = KnotList<Q>(2, knots);
  const WarpEnclosure warp = warp_of(net);
  EXPECT_FALSE(warp.complete);
  EXPECT_EQ(warp.upper, 90);
  EXPECT_GT(warp.lower, 1);
  EXPECT_EQ(at_most(net, Q(89)), Truth::unknown);
  EXPECT_EQ(at_most(net, Q(1)), Truth::no);
}

}  // namespace
}  // namespace torse::test
