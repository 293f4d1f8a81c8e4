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

/// What is found near two rulings, whichever of them is named first.
std::optional<RulingCrossing> near_both(const KnotList<Q>& u, const Row& c, const Row& d, double s, double t) {
  const std::optional<RulingCrossing> found = near(u, c, d, s, t);
  const std::optional<RulingCrossing> other = near(u, c, d, t, s);
  EXPECT_EQ(found.has_value(), other.has_value());
  if (found && other) {
    EXPECT_EQ(found->first, other->second);
    EXPECT_EQ(found->first_share, other->second_share);
    EXPECT_EQ(found->second, other->first);
    EXPECT_EQ(found->second_share, other->first_share);
  }
  return found;
}

const KnotList<Q> three(1, {Q(0), Q(1), Q(2), Q(3)});

/// A floor and, over the middle of it, a wall between two heights: it goes through the floor where these have different
/// signs. Where one of them is 0 a rail lies on the floor, and points of rails are left out.
TEST(CrossingFinder, AWallThroughTheFloor) {
  for (int low = -3; low <= 3; ++low) {
    for (int high = -3; high <= 3; ++high) {
      if (low == high) continue;
      const Row c{point(0, 0, 0), point(4, 0, 0), point(3, 2, low), point(1, 2, low)};
      const Row d{point(0, 4, 0), point(4, 4, 0), point(3, 2, high), point(1, 2, high)};
      const auto found = near_both(three, c, d, 0.5, 2.5);
      EXPECT_EQ(found.has_value(), low * high < 0) << low << " " << high;
      if (found) {
        EXPECT_DOUBLE_EQ(found->first_share, 0.5);
        EXPECT_DOUBLE_EQ(found->second_share, low / static_cast<double>(low - high));
      }
    }
  }
}

/// The last wall comes from (1, 6) down to (1, y), the first one goes from (0, 0) to (2, 0). For y = 0 they have the
/// ruling in common that is the end of the one and the middle of the other.
TEST(CrossingFinder, WallsThatEndBeforeAnotherOneDoNotCrossIt) {
  for (const int y : {-2, -1, 0, 1, 2}) {
    Row base{point(0, 0, 0), point(2, 0, 0), point(1, 6, 0), point(1, y, 0)};
    const auto found = near_both(three, base, raised(base), 0.5, 2.5);
    EXPECT_EQ(found.has_value(), y <= 0) << y;
    if (found) {
      EXPECT_DOUBLE_EQ(found->first, 0.5);
      EXPECT_DOUBLE_EQ(found->second, 2 + 6.0 / (6 - y));
    }
    std::ranges::reverse(base);
    EXPECT_EQ(near_both(three, base, raised(base), 0.5, 2.5).has_value(), y <= 0) << y;
  }
}

/// Two sheets in one plane, out of which the strip goes between them: rulings along y from 0 to 4 and from 1 to 5, at
/// places x that come again. What is equal are the points at 5/8 and 3/8 of the ways.
TEST(CrossingFinder, SheetsUponEachOtherArePairedExactly) {
  const Row c{point(0, 0, 0), point(4, 0, 0), point(4, 1, 4), point(4, 1, 0), point(0, 1, 0)};
  const Row d{point(0, 4, 0), point(4, 4, 0), point(4, 5, 4), point(4, 5, 0), point(0, 5, 0)};
  const auto found = near_both(four, c, d, 0.25, 3.75);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->first, 0.25);
  EXPECT_EQ(found->first_share, 0.625);
  EXPECT_EQ(found->second, 3.75);
  EXPECT_EQ(found->second_share, 0.375);
}

/// The same with homogeneous rows of which those of the first sheet vanish at its middle, times 1 - 2t: a point that
/// the numbers of the rows do not have is not said to be anywhere.
TEST(CrossingFinder, ARowThatVanishesIsNoPoint) {
  const KnotList<Q> u(2, {Q(0), Q(0), Q(1), Q(1), Q(2), Q(2), Q(3), Q(3), Q(4), Q(4)});
  const auto rows = [](int y) {
    const auto row = [](int w, int x, int height, int z) { return Vec<Q, 4>(Q(w), Q(x), Q(height), Q(z)); };
    return std::vector<Vec<Q, 4>>{row(1, 0, y, 0),        row(0, 2, 0, 0),         row(-1, -4, -y, 0),
                                  row(-1, -4, -y, -2),    row(-1, -4, -y - 1, -4), row(-1, -4, -y - 1, -2),
                                  row(-1, -4, -y - 1, 0), row(-1, -2, -y - 1, 0),  row(-1, 0, -y - 1, 0)};
  };
  const std::vector<Vec<Q, 4>> c = rows(0);
  const std::vector<Vec<Q, 4>> d = rows(4);
  const CrossingFinder finder(u, std::span<const Vec<Q, 4>>(c), std::span<const Vec<Q, 4>>(d));
  EXPECT_TRUE(finder.near(0.25, 3.75));
  EXPECT_FALSE(finder.near(0.5 + 0x1p-33, 3.5 - 0x1p-33));
  EXPECT_FALSE(finder.near(3.5 - 0x1p-33, 0.5 + 0x1p-33));
}

/// Points are rows of weight 1, in every number that is found.
TEST(CrossingFinder, PointsAreHomogeneousRows) {
  const Row base{point(0, 0, 0), point(5, 1, 0), point(2, 7, 0), point(3, -4, 0)};
  const Row top = raised(base);
  const auto rows = [](const Row& points) {
    std::vector<Vec<Q, 4>> result;
    for (const Point& x : points) result.push_back(Vec<Q, 4>(Q(1), x[0], x[1], x[2]));
    return result;
  };
  const std::vector<Vec<Q, 4>> c = rows(base), d = rows(top);
  const CrossingFinder finder(three, std::span<const Vec<Q, 4>>(c), std::span<const Vec<Q, 4>>(d));
  double farthest = 0;
  for (int i = 0; i < 10; ++i) {
    const auto found = near(three, base, top, 0.1 * i, 2.25);
    const auto other = finder.near(0.1 * i, 2.25);
    ASSERT_TRUE(found && other) << i;
    EXPECT_EQ(found->first, other->first);
    EXPECT_EQ(found->second, other->second);
    EXPECT_EQ(found->distance, other->distance);
    farthest = std::max(farthest, found->distance);
  }
  EXPECT_GT(farthest, 0);
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

std::optional<RulingCrossing> within(const Row& c, const Row& d) {
  return CrossingFinder(bezier_knots<Q>(2), std::span<const Point>(c), std::span<const Point>(d)).within(0);
}

/// Along the line of (1, 2, 2): from t to 3 + t, where every two rulings overlap, and to 5t, where those of s < t do if
/// t < 5s.
TEST(CrossingFinder, RulingsThatSlideOverlap) {
  const auto row = [](int begin, int middle, int end) {
    Row points;
    for (const int x : {begin, middle, end}) points.push_back(point(x, 2 * x, 2 * x));
    return points;
  };
  const auto expect_found = [&](const Row& c, const Row& d, const auto& from, const auto& to) {
    const std::optional<RulingCrossing> found = within(c, d);
    ASSERT_TRUE(found);
    EXPECT_LT(found->first, found->second);
    for (const double way : {found->first_share, found->second_share}) {
      EXPECT_GT(way, 0);
      EXPECT_LT(way, 1);
    }
    const auto at = [&](double t, double way) { return (1 - way) * from(t) + way * to(t); };
    EXPECT_NEAR(at(found->first, found->first_share), at(found->second, found->second_share), 1e-14);
  };
  const auto share = [](double t) { return 2 * t; };
  expect_found(row(0, 1, 2), row(6, 7, 8), share, [](double t) { return 6 + 2 * t; });
  expect_found(row(0, 1, 2), row(0, 5, 10), share, [](double t) { return 10 * t; });
  expect_found(
      row(0, 0, 100), row(1, 1, 101), [](double t) { return 100 * t * t; }, [](double t) { return 100 * t * t + 1; });
  // The ruling of 1/2 is a point: from 2t to 2t + (1 - 2t)^2.
  expect_found(row(0, 1, 2), row(1, 0, 3), share, [](double t) { return 2 * t + (1 - 2 * t) * (1 - 2 * t); });
  // No rulings, and no line.
  EXPECT_FALSE(within(row(0, 1, 2), row(0, 1, 2)));
  EXPECT_FALSE(within(row(0, 1, 2), {point(6, 12, 12), point(7, 14, 14), point(8, 16, 17)}));
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
