// Crossings that are looked for near two given rulings, where it is known by hand whether there are any; points of a
// strip and their derivatives against those of the circle.
#include "torse/exact/quasi/strip_crossing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace torse::test {
namespace {

using Q = Rational;
using Point = Vec<Q, 3>;
using Row = std::vector<Point>;

Point point(int x, int y, int z) { return Point(Q(x), Q(y), Q(z)); }

Row raised(Row row) {
  for (Point& x : row) x[2] += Q(1);
  return row;
}

std::optional<RulingCrossing> near(const KnotList<Q>& u, const Row& c, const Row& d, double s, double t) {
  return CrossingFinder(u, std::span<const Point>(c), std::span<const Point>(d)).near(s, t);
}

const KnotList<Q> four(1, {Q(0), Q(1), Q(2), Q(3), Q(4)});
const Row square{point(0, 0, 0), point(1, 0, 0), point(1, 1, 0), point(0, 1, 0), point(0, 0, 0)};

TEST(CrossingFinder, ARulingDoesNotCrossItself) {
  for (const double s : {0.0, 0.25, 1.0, 1.5, 4.0}) EXPECT_FALSE(near(four, square, raised(square), s, s)) << s;
}

/// The last ruling of a closed strip is its first one.
TEST(CrossingFinder, ASeamIsOneRuling) {
  EXPECT_FALSE(near(four, square, raised(square), 0, 4));
  EXPECT_FALSE(near(four, square, raised(square), 4, 0));
}

TEST(CrossingFinder, RulingsOfAConeShareItsVertex) {
  const Row tip(2, point(0, 0, 0));
  const Row arc{point(1, 0, 3), point(0, 1, 5)};
  EXPECT_FALSE(near(bezier_knots<Q>(1), tip, arc, 0.125, 0.75));
  EXPECT_FALSE(near(bezier_knots<Q>(1), arc, tip, 0.125, 0.75));
}

/// From (t, 0) to (2t, 1): the straight lines meet at (0, -1), not between the rails.
TEST(CrossingFinder, WhatIsBeyondTheRailsDoesNotCount) {
  const Row c{point(0, 0, 0), point(1, 0, 0)};
  EXPECT_FALSE(near(bezier_knots<Q>(1), c, {point(0, 1, 0), point(2, 1, 0)}, 0.25, 0.75));
  // To (1 - t, 1) they meet at (1/2, 1/2).
  const std::optional<RulingCrossing> found = near(bezier_knots<Q>(1), c, {point(1, 1, 0), point(0, 1, 0)}, 0.25, 0.75);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->first_share, 0.5);
  EXPECT_EQ(found->second_share, 0.5);
}

/// Rails x = t, y = 0 and x = 3 - 4t, y = 1 in each plane of two axes, and along each diagonal of the third: rulings
/// with s + v (3 - 5s) = t + v (3 - 5t) meet at v = 1/5. All do, so that Newton's method does not settle on two of
/// them.
TEST(CrossingFinder, InEveryPlane) {
  for (const std::array<int, 3>& axes : {std::array{0, 1, 2}, {1, 2, 0}, {2, 0, 1}}) {
    for (const int tilt : {0, 1, -3}) {
      const auto placed = [&](int x, int y) {
        Point place;
        place[axes[0]] = Q(x);
        place[axes[1]] = Q(y);
        place[axes[2]] = Q(tilt * (x + y));
        return place;
      };
      const auto found =
          near(bezier_knots<Q>(1), {placed(0, 0), placed(1, 0)}, {placed(3, 1), placed(-1, 1)}, 0.1, 0.7);
      ASSERT_TRUE(found) << axes[0] << tilt;
      EXPECT_NEAR(found->first_share, 0.2, 1e-7);
      EXPECT_NEAR(found->second_share, 0.2, 1e-7);
    }
  }
}

/// The parameters are those of the knots: walls that cross in the middle of [10, 12] and a third into [13, 16].
TEST(CrossingFinder, NamesParametersOfTheKnots) {
  const KnotList<Q> u(1, {Q(10), Q(12), Q(13), Q(16)});
  const Row base{point(0, 0, 0), point(4, 0, 0), point(2, 2, 0), point(2, -4, 0)};
  const auto found = near(u, base, raised(base), 0.25, 2.75);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->first, 11, 1e-13);
  EXPECT_NEAR(found->second, 14, 1e-13);
  EXPECT_LT(found->distance, 1e-14);
}

/// c: the quarter of the unit circle ((1 - t^2) / (1 + t^2), 2t / (1 + t^2)); d: (2, 3t, 5).
TEST(StripPoints, HaveTheDerivativesOfTheirFormulas) {
  StripPoints<Q> strip;
  const auto row = [](int w, int x, int y, int z) { return Vec<Q, 4>(Q(w), Q(x), Q(y), Q(z)); };
  strip.push({row(1, 1, 0, 0), row(1, 1, 1, 0), row(2, 0, 2, 0)},
             {row(1, 2, 0, 5), Vec<Q, 4>(Q(1), Q(2), ratio<Q>(3, 2), Q(5)), row(1, 2, 3, 5)});
  ASSERT_EQ(strip.pieces(), 1U);
  const Q t = ratio<Q>(1, 3), v = ratio<Q>(1, 4), rest = ratio<Q>(3, 4);
  const Q n = Q(1) + t * t;
  const Point c((Q(1) - t * t) / n, Q(2) * t / n, Q(0));
  const Point by_t(Q(-4) * t / (n * n), Q(2) * (Q(1) - t * t) / (n * n), Q(0));
  const Point d(Q(2), Q(3) * t, Q(5));
  const StripPoint<Q> found = strip.at(0, t, v);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(found.point[k], rest * c[k] + v * d[k]) << k;
    EXPECT_EQ(found.by_share[k], rest * by_t[k] + v * Q(k == 1 ? 3 : 0)) << k;
    EXPECT_EQ(found.by_v[k], d[k] - c[k]) << k;
  }
}

}  // namespace
}  // namespace torse::test
