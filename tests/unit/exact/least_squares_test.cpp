// Least squares fits in doubles: surfaces of the space come back, and the costs of knots are jumps computed by hand.
#include "torse/exact/quasi/least_squares.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace torse::quasi {
namespace {

DoubleSurface drawn_surface(const KnotList<double>& u, std::uint64_t seed) {
  std::mt19937_64 rng(seed);
  const auto row = [&] {
    std::vector<DoublePoint> points;
    for (int i = 0; i <= u.last(); ++i) {
      DoublePoint x;
      for (int j = 0; j < 3; ++j) x[j] = static_cast<double>(rng() % 2001) / 1000 - 1;
      points.push_back(x);
    }
    return points;
  };
  std::vector<DoublePoint> c = row();
  return DoubleSurface(u, std::move(c), row());
}

void expect_near(const DoubleSurface& found, const DoubleSurface& expected) {
  ASSERT_EQ(found.c.size(), expected.c.size());
  for (std::size_t i = 0; i < found.c.size(); ++i) {
    EXPECT_LT((found.c[i] - expected.c[i]).norm(), 1e-12) << i;
    EXPECT_LT((found.d[i] - expected.d[i]).norm(), 1e-12) << i;
  }
}

TEST(FittedSurface, ThatOfTheSpaceComesBack) {
  for (int degree = 1; degree <= 4; ++degree) {
    for (const auto& inside : {std::vector<Breakpoint>{}, {{0.25, 1}}, {{0.25, 1}, {0.5, degree}, {0.875, 1}}}) {
      const KnotList<double> u = knots_with(degree, -1, 2, inside);
      const DoubleSurface surface = drawn_surface(u, 3);
      // Only the ends of the other surface are looked at.
      DoubleSurface like = drawn_surface(u, 4);
      like.c.front() = surface.c.front();
      like.c.back() = surface.c.back();
      like.d.front() = surface.d.front();
      like.d.back() = surface.d.back();
      const auto found = fitted_surface(u, sampled(surface, degree + 2), like);
      ASSERT_TRUE(found);
      expect_near(*found, surface);
    }
  }
}

/// One piece of degree 1 has no point of its own: both ends are given, whatever the samples are.
TEST(FittedSurface, OfEndsAlone) {
  const KnotList<double> u = bezier_knots<double>(1);
  const DoubleSurface like(u, {{0, 0, 0}, {1, 2, 3}}, {{4, 0, 0}, {5, 6, 7}});
  for (const std::vector<SurfaceSample>& samples :
       {std::vector<SurfaceSample>{}, std::vector<SurfaceSample>{{0.5, {9, 9, 9}, {-9, 9, 9}}}}) {
    const auto found = fitted_surface(u, samples, like);
    ASSERT_TRUE(found);
    expect_near(*found, like);
  }
}

TEST(Sampled, AsManyInEachPiece) {
  const KnotList<double> u = knots_with(2, -1, 2, {{0, 1}});
  const DoubleSurface surface = drawn_surface(u, 5);
  const std::vector<SurfaceSample> samples = sampled(surface, 4);
  const std::vector<double> expected{-0.875, -0.625, -0.375, -0.125, 0.25, 0.75, 1.25, 1.75};
  ASSERT_EQ(samples.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_DOUBLE_EQ(samples[i].t, expected[i]);
}

/// On [-2, 0] and [0, 1], in Bezier points or, with a simple knot, in blossoms.
TEST(RemovalCosts, AreJumpsOfTheFirstFreeDerivative) {
  const KnotList<double> twice = knots_with(2, -2, 1, {{0, 2}});
  // t^2 - t and t^2 + 3 t in the row c: the slope jumps by 4 at 0; the row d is straight.
  const std::vector<DoublePoint> c{{-2, 6, 0}, {-1, 1, 0}, {0, 0, 0}, {0.5, 1.5, 0}, {1, 4, 0}};
  const std::vector<DoublePoint> straight{{-2, 0, 1}, {-1, 0, 1}, {0, 0, 1}, {0.5, 0, 1}, {1, 0, 1}};
  for (const DoubleSurface& surface : {DoubleSurface(twice, c, straight), DoubleSurface(twice, straight, c)}) {
    const std::vector<double> costs = removal_costs(surface, {{0, 2}});
    ASSERT_EQ(costs.size(), 1U);
    EXPECT_NEAR(costs[0], 4 * 1.5, 1e-12);
  }

  // t^2 and 3 t^2 with a knot of multiplicity 1: the blossoms at (-2,-2), (-2,0), (0,1), (1,1) are 4, 0, 0, 3.
  const KnotList<double> once = knots_with(2, -2, 1, {{0, 1}});
  const std::vector<DoublePoint> bent{{-2, 4, 0}, {-1, 0, 0}, {0.5, 0, 0}, {1, 3, 0}};
  const std::vector<DoublePoint> flat{{-2, 0, 1}, {-1, 0, 1}, {0.5, 0, 1}, {1, 0, 1}};
  for (const DoubleSurface& surface : {DoubleSurface(once, bent, flat), DoubleSurface(once, flat, bent)}) {
    const std::vector<double> costs = removal_costs(surface, {{0, 1}});
    ASSERT_EQ(costs.size(), 1U);
    EXPECT_NEAR(costs[0], 2 * 1.5 * 1.5, 1e-12);
  }

  // Two breakpoints, of which the second is superfluous.
  const KnotList<double> both = knots_with(1, 0, 7, {{1, 1}, {3, 1}});
  const std::vector<DoublePoint> corner{{0, 0, 0}, {1, 0, 0}, {3, 2, 0}, {7, 6, 0}};
  const std::vector<double> costs = removal_costs(DoubleSurface(both, corner, corner), {{1, 1}, {3, 1}});
  ASSERT_EQ(costs.size(), 2U);
  EXPECT_NEAR(costs[0], 1.5, 1e-12);
  EXPECT_NEAR(costs[1], 0, 1e-12);
}

}  // namespace
}  // namespace torse::quasi
