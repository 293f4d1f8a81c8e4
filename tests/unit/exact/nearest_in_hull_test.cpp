// The nearest point of a hull against that of all its triangles, edges and corners.
#include "torse/exact/quasi/nearest_in_hull.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace torse::test {
namespace {

using Point = Vec<double, 3>;

Point nearest(const std::vector<Point>& points, double good) {
  const auto lowest = [&](const Point& e) {
    return *std::ranges::min_element(points, {}, [&](const Point& x) { return e.dot(x); });
  };
  return nearest_in_hull(lowest, good);
}

/// On the segment: the foot of 0 on its line if it is between the ends.
Point nearest_on_edge(const Point& p, const Point& q) {
  const Point way = q - p;
  return p + std::clamp(-p.dot(way) / way.squaredNorm(), 0.0, 1.0) * way;
}

/// On the triangle: the foot of 0 on its plane if it is on the inner side of each edge, or on one of these.
Point nearest_on_triangle(const Point& p, const Point& q, const Point& r) {
  const Point normal = (q - p).cross(r - p);
  const Point foot = p.dot(normal) / normal.squaredNorm() * normal;
  const auto inside = [&](const Point& a, const Point& b) { return (b - a).cross(foot - a).dot(normal) >= 0; };
  if (inside(p, q) && inside(q, r) && inside(r, p)) return foot;
  const auto nearer = [](const Point& x, const Point& y) { return x.norm() < y.norm(); };
  return std::min({nearest_on_edge(p, q), nearest_on_edge(q, r), nearest_on_edge(r, p)}, nearer);
}

/// Of a hull that does not contain 0.
double distance(const std::vector<Point>& points) {
  double least = points[0].norm();
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        least = std::min(least, nearest_on_triangle(points[i], points[j], points[k]).norm());
      }
    }
  }
  return least;
}

std::vector<Point> drawn(int count, std::uint64_t seed, const Point& away) {
  std::uint64_t state = seed * 0x9E3779B97F4A7C15U + 1;
  const auto number = [&] {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(state >> 40) * 0x1p-23 - 1;
  };
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) points.push_back(away + Point(number(), number(), number()));
  return points;
}

TEST(NearestInHull, IsThatOfAllTriangles) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    // Boxes beside 0, some of them by little.
    const Point away(1 + 0.25 * static_cast<double>(seed % 3), 0.3, -0.2);
    const std::vector<Point> points = drawn(4 + static_cast<int>(seed % 12), seed, away);
    EXPECT_NEAR(nearest(points, 1 - 1e-12).norm(), distance(points), 1e-9) << seed;
  }
}

TEST(NearestInHull, IsACornerAnEdgeOrATriangle) {
  const auto expect_at = [](const std::vector<Point>& points, const Point& expected) {
    EXPECT_LT((nearest(points, 1 - 1e-12) - expected).norm(), 1e-15);
  };
  expect_at({Point(2, 1, 0)}, Point(2, 1, 0));
  expect_at({Point(2, 1, 0), Point(1, 0, 0), Point(3, 0, 5)}, Point(1, 0, 0));
  expect_at({Point(1, 1, 0), Point(1, -1, 0), Point(2, 0, 3), Point(2, 0, -3)}, Point(1, 0, 0));
  expect_at({Point(1, 3, 3), Point(1, -3, 3), Point(1, 0, -3), Point(4, 0, 0)}, Point(1, 0, 0));
  // The same point twice, and all on one line.
  expect_at({Point(1, 1, 0), Point(1, 1, 0), Point(1, -1, 0), Point(1, 5, 0)}, Point(1, 0, 0));
}

TEST(NearestInHull, IsZeroInTheHull) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    std::vector<Point> points = drawn(6, seed, Point(0, 0, 0));
    Point sum(0, 0, 0);
    for (const Point& x : points) sum += x;
    points.push_back(-sum);
    EXPECT_LT(nearest(points, 0.5).norm(), 1e-14) << seed;
  }
  EXPECT_EQ(nearest({Point(1, 0, 0), Point(-1, 0, 0)}, 0.5).norm(), 0);
}

/// A direction that is good enough sees all points; a better one is not looked for.
TEST(NearestInHull, IsAsGoodAsAsked) {
  int rough = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const std::vector<Point> points = drawn(9, seed, Point(1.1, 0, 0));
    const Point x = nearest(points, 0.25);
    for (const Point& y : points) EXPECT_GT(x.dot(y), 0.25 * x.squaredNorm()) << seed;
    if (x.norm() > 1.001 * distance(points)) ++rough;
  }
  EXPECT_GT(rough, 30);
}

TEST(NearestInHull, EndsWhereNumbersAreNone) {
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double x : {infinite, -infinite, infinite - infinite, 1e200, 1e-200}) {
    nearest({Point(x, 1, 0), Point(1, x, 0), Point(-x, 2, 1), Point(1, 1, 1)}, 0.5);
  }
}

}  // namespace
}  // namespace torse::test
