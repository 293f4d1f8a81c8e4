// Outlines that cross themselves, against exact arithmetic on all pairs of edges.
#include "torse/exact/unroll/overlap.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "torse/exact/rational/rational.hpp"

namespace torse {
namespace {

Outline outline(const std::vector<PlatePoint>& points, double slack) {
  return {points, std::vector<double>(points.size(), slack)};
}

/// A band of `turns` turns around the origin between the radii 1 and 2, slightly spiral by `pitch` a turn.
Outline band(double turns, double pitch, double slack) {
  constexpr int steps = 400;
  std::vector<PlatePoint> points;
  const auto add = [&](double radius, int i) {
    const double angle = 2 * std::numbers::pi * turns * i / steps;
    const double r = radius + pitch * turns * i / steps;
    points.push_back({r * std::cos(angle), r * std::sin(angle)});
  };
  for (int i = 0; i <= steps; ++i) add(1, i);
  for (int i = steps; i >= 0; --i) add(2, i);
  return outline(points, slack);
}

/// Points in the middle of the band.
std::vector<PlatePoint> middles(double turns) {
  std::vector<PlatePoint> points;
  for (int i = 0; i < 20; ++i) {
    const double angle = 2 * std::numbers::pi * turns * (i + 0.5) / 20;
    points.push_back({1.5 * std::cos(angle), 1.5 * std::sin(angle)});
  }
  return points;
}

TEST(Overlap, SimpleOutlines) {
  EXPECT_EQ(find_overlap(outline({{0, 0}, {4, 0}, {4, 3}, {0, 3}}, 1e-3), {}).verdict, Truth::no);
  EXPECT_EQ(find_overlap(outline({{0, 0}, {4, 0}, {4, 3}}, 0), {}).verdict, Truth::no);
  // The same point twice: a ruling of length zero.
  EXPECT_EQ(find_overlap(outline({{0, 0}, {4, 0}, {4, 3}, {0, 0}}, 0), {}).verdict, Truth::no);
  EXPECT_EQ(find_overlap(band(0.99, 0, 1e-6), middles(0.99)).verdict, Truth::no);
  EXPECT_EQ(find_overlap(band(3, 1.1, 1e-6), middles(3)).verdict, Truth::no);
  EXPECT_TRUE(find_overlap(band(3, 1.1, 1e-6), middles(3)).meetings.empty());
}

TEST(Overlap, ABowTieAndWhereItCrosses) {
  const Overlap overlap = find_overlap(outline({{0, 0}, {4, 4}, {4, 0}, {0, 4}}, 1e-3), {});
  EXPECT_EQ(overlap.verdict, Truth::yes);
  ASSERT_EQ(overlap.meetings.size(), 1U);
  EXPECT_EQ(overlap.meetings[0].first, 0U);
  EXPECT_EQ(overlap.meetings[0].second, 2U);
  EXPECT_EQ(overlap.meetings[0].at, (PlatePoint{2, 2}));
  EXPECT_TRUE(overlap.meetings[0].certain);
}

/// (1, 2) + s (6, 3) = (6, -1) + t (-4, 10) for s = 19/36 and t = 11/24.
TEST(Overlap, TheCrossingIsWhereTheEdgesMeet) {
  std::vector<PlatePoint> points{{1, 2}, {7, 5}, {6, -1}, {2, 9}};
  for (int turn = 0; turn < 4; ++turn) {
    const Overlap overlap = find_overlap(outline(points, 1e-6), {});
    ASSERT_EQ(overlap.meetings.size(), 1U);
    EXPECT_NEAR(overlap.meetings[0].at.x, 25.0 / 6, 1e-14);
    EXPECT_NEAR(overlap.meetings[0].at.y, 43.0 / 12, 1e-14);
    std::rotate(points.begin(), points.begin() + 1, points.end());
  }
}

TEST(Overlap, MoreThanATurn) {
  EXPECT_EQ(find_overlap(band(1.5, 0.3, 1e-6), middles(1.5)).verdict, Truth::yes);
  // Exactly on itself twice: no edge crosses another, but points are covered twice.
  EXPECT_EQ(find_overlap(band(2, 0, 1e-6), middles(2)).verdict, Truth::yes);
  EXPECT_EQ(find_overlap(band(2, 0, 1e-6), {}).verdict, Truth::unknown);
  EXPECT_EQ(find_overlap(band(2, 0, 1e-6), {}).meetings.size(), most_meetings);
}

/// From (-3/2, 0) straight to the right and to the left are corners of the outline, at exactly this height.
TEST(Overlap, CornersAtTheHeightOfAPointCountOnce) {
  Outline twice = band(2, 0, 1e-6);
  for (const double side : {1.0, -1.0}) {
    for (int sense = 0; sense < 2; ++sense) {
      for (int upside = 0; upside < 2; ++upside) {
        EXPECT_EQ(find_overlap(twice, {{-1.5 * side, 0}}).verdict, Truth::yes);
        for (PlatePoint& x : twice.points) x.y = -x.y;
      }
      std::ranges::reverse(twice.points);
    }
    for (PlatePoint& x : twice.points) x.x = -x.x;
  }
}

TEST(Overlap, TheSenseOfTheOutlineDoesNotMatter) {
  Outline clockwise = band(2, 0, 1e-6);
  std::ranges::reverse(clockwise.points);
  EXPECT_EQ(find_overlap(clockwise, middles(2)).verdict, Truth::yes);
}

TEST(Overlap, PointsOutsideAreCoveredByNothing) {
  const std::vector<PlatePoint> outside{{-3, 0.5}, {3, 0.5}, {0.25, 0.25}, {-3, -0.5}};
  EXPECT_EQ(find_overlap(band(2, 0, 1e-6), outside).verdict, Truth::unknown);
}

TEST(Overlap, ATouchIsNotDecided) {
  EXPECT_EQ(find_overlap(band(1, 0, 1e-9), middles(1)).verdict, Truth::unknown);
  const std::vector<PlatePoint> notch{{0, 0}, {4, 0}, {4, 4}, {2, 1e-4}, {0, 4}};
  EXPECT_EQ(find_overlap(outline(notch, 1e-5), {}).verdict, Truth::no);
  EXPECT_EQ(find_overlap(outline(notch, 1e-3), {}).verdict, Truth::unknown);
}

/// A tip over the middle of an edge of this length: half the edge away from its ends, whatever it is from the edge.
TEST(Overlap, ATipOverTheMiddleOfAnEdgeIsNear) {
  for (const double length : {0.5, 1.0, 2.0}) {
    const auto verdict = [&](double height) {
      return find_overlap(outline({{0, 0}, {length, 0}, {length, 2}, {length / 2, height}, {0, 2}}, 0.01), {}).verdict;
    };
    EXPECT_EQ(verdict(0.015), Truth::unknown) << length;
    EXPECT_EQ(verdict(0.03), Truth::no) << length;
  }
}

/// A tip above the middle of a short edge, and an edge from there to below it. Where the square of the short edge's
/// length is no double, nothing is known of what is near it.
TEST(Overlap, AnEdgeOfNoMeasurableLengthIsNotDecided) {
  const auto verdict = [](double length) {
    return find_overlap(outline({{0, 0}, {length, 0}, {0, -3}, {4, -1}, {length / 2, 1}, {-4, 0.5}}, 0), {}).verdict;
  };
  EXPECT_EQ(verdict(0x1p-100), Truth::no);
  EXPECT_EQ(verdict(0x1p-500), Truth::no);
  EXPECT_EQ(verdict(0x1p-600), Truth::unknown);
}

/// Two uprights with a gap between them that is smaller than both errors together and larger than either.
TEST(Overlap, BothEdgesMayBeOff) {
  constexpr double gap = 1.5e-3;
  const std::vector<PlatePoint> slot{{-4, 0},  {0, 0},   {0, 3}, {-1, 4}, {2, 4},
                                     {gap, 3}, {gap, 0}, {4, 0}, {4, 5},  {-4, 5}};
  EXPECT_EQ(find_overlap(outline(slot, 1e-3), {}).verdict, Truth::unknown);
  EXPECT_EQ(find_overlap(outline(slot, 0.7e-3), {}).verdict, Truth::no);
}

/// The same with a gap of 1 that both errors together reach exactly: upright, and lying with the edge that begins first
/// below and above.
TEST(Overlap, WhatErrorsReachExactlyIsNotDecided) {
  const std::vector<PlatePoint> upright{{-40, 0}, {0, 0}, {0, 30}, {-10, 40}, {20, 40},
                                        {1, 30},  {1, 0}, {41, 0}, {41, 60},  {-40, 60}};
  const std::vector<PlatePoint> lying{{0, 0},  {100, 0}, {110, -10}, {120, 30},  {100, 30}, {90, 1},
                                      {30, 1}, {30, 40}, {130, 40},  {130, -40}, {0, -40}};
  for (const std::vector<PlatePoint>& slot : {upright, lying}) {
    for (const double mirror : {1.0, -1.0}) {
      std::vector<PlatePoint> points = slot;
      for (PlatePoint& x : points) x.y *= mirror;
      EXPECT_EQ(find_overlap(outline(points, 0.5), {}).verdict, Truth::unknown);
      EXPECT_EQ(find_overlap(outline(points, 0.4375), {}).verdict, Truth::no);
    }
  }
}

/// A corner beyond the end of an edge, almost in line with it, whose own edge goes back above it.
TEST(Overlap, ACornerBeyondAnEdgeIsApart) {
  const std::vector<PlatePoint> hook{{0, 0}, {4, 0}, {4, -1}, {6, -1}, {6, 0.05}, {4.6, 0.05}, {2, 3}, {0, 3}};
  for (const double scale : {1.0, 0.125, -1.0, -0.125}) {
    std::vector<PlatePoint> scaled;
    for (const PlatePoint& x : hook) scaled.push_back({scale * x.x, std::abs(scale) * x.y});
    EXPECT_EQ(find_overlap(outline(scaled, 0.05 * std::abs(scale)), {}).verdict, Truth::no) << scale;
    std::ranges::reverse(scaled);
    EXPECT_EQ(find_overlap(outline(scaled, 0.05 * std::abs(scale)), {}).verdict, Truth::no) << scale;
  }
}

/// Which side of the line from a to b c is on, exactly.
int exact_side(const PlatePoint& a, const PlatePoint& b, const PlatePoint& c) {
  const auto q = [](double x) { return Rational::from_double(x); };
  return ((q(b.x) - q(a.x)) * (q(c.y) - q(a.y)) - (q(b.y) - q(a.y)) * (q(c.x) - q(a.x))).sign();
}

bool exactly_cross(const PlatePoint& a, const PlatePoint& b, const PlatePoint& c, const PlatePoint& d) {
  return exact_side(a, b, c) * exact_side(a, b, d) < 0 && exact_side(c, d, a) * exact_side(c, d, b) < 0;
}

/// Two edges over each other, on one line but for rounding, the others far away: what crosses is not said not to.
TEST(Overlap, EdgesOverEachOtherOnOneLine) {
  std::mt19937_64 rng(1);
  int crossings = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const double slope = static_cast<double>(rng() % 1000) / 999;
    const double up = trial % 2 == 0 ? 1 : -1;
    const auto at = [&](double x) {
      return PlatePoint{x, up * (slope * x + (static_cast<double>(rng() % 9) - 4) * 0x1p-54)};
    };
    const double share = static_cast<double>(rng() % 4096) / 4096;
    const PlatePoint a = at(0), b = at(1), c = at(-1 - share), d = at(share);
    if (!exactly_cross(a, b, c, d)) continue;
    ++crossings;
    const std::vector<PlatePoint> points{a, b, {4, 20 * up}, {-4, 20 * up}, c, d, {1, -20 * up}};
    EXPECT_NE(find_overlap(outline(points, 0), {}).verdict, Truth::no) << trial;
  }
  EXPECT_GT(crossings, 100);
}

/// Two edges behind each other, on one line but for rounding, further apart than both errors: they are not said to
/// cross.
TEST(Overlap, EdgesBehindEachOtherOnOneLine) {
  std::mt19937_64 rng(1);
  for (int trial = 0; trial < 1000; ++trial) {
    const double slope = 0.75 + static_cast<double>(rng() % 1000) / 4000;
    const auto at = [&](double x) { return PlatePoint{x, slope * x + (static_cast<double>(rng() % 9) - 4) * 0x1p-54}; };
    const PlatePoint a = at(0), b = at(1), c = at(1.125), d = at(2 + static_cast<double>(rng() % 4096) / 4096);
    const std::vector<PlatePoint> points{a, b, {b.x, -9}, {d.x, -8}, d, c, {c.x, 8}, {a.x, 9}};
    EXPECT_NE(find_overlap(outline(points, 0.07), {}).verdict, Truth::yes) << trial;
  }
}

/// Small integers: crossings by signs of integers.
RC_GTEST_PROP(Overlap, AgreesWithIntegers, ()) {
  const auto n = *rc::gen::inRange<std::size_t>(4, 9);
  std::vector<std::array<long, 2>> v;
  for (std::size_t i = 0; i < n; ++i) v.push_back({*rc::gen::inRange<long>(-20, 21), *rc::gen::inRange<long>(-20, 21)});
  const auto side = [](const auto& a, const auto& b, const auto& c) {
    const long x = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    return (x > 0) - (x < 0);
  };
  bool crosses = false;
  bool touches = false;
  for (std::size_t i = 0; i < n; ++i) {
    RC_PRE(v[i] != v[(i + 1) % n]);
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j + 1 == n) continue;
      const auto& a = v[i];
      const auto& b = v[i + 1];
      const auto& c = v[j];
      const auto& d = v[(j + 1) % n];
      const int s = side(a, b, c) * side(a, b, d);
      const int t = side(c, d, a) * side(c, d, b);
      crosses = crosses || (s < 0 && t < 0);
      touches = touches || (s == 0 || t == 0);
    }
  }
  std::vector<PlatePoint> points;
  for (const auto& x : v) points.push_back({static_cast<double>(x[0]), static_cast<double>(x[1])});
  const Truth verdict = find_overlap(outline(points, 0), {}).verdict;
  if (crosses) RC_ASSERT(verdict == Truth::yes);
  if (!crosses && !touches) RC_ASSERT(verdict == Truth::no);
}

}  // namespace
}  // namespace torse
