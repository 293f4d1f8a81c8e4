// Folds: strips whose normals are known by hand, and witnesses against normals from points and derivatives.
#include "torse/exact/quasi/folds.hpp"

#include <gtest/gtest.h>

#include "../spline/splines.hpp"
#include "torse/algebra/determinant.hpp"
#include "torse/spline/blossom.hpp"

namespace torse::test {
namespace {

using Point = Vec<Q, 3>;
using Row = std::vector<Point>;

Point point(int x, int y, int z) { return Point(Q(x), Q(y), Q(z)); }

std::optional<RulingPlace> fold(const KnotList<Q>& u, const Row& c, const Row& d) { return find_fold<3>(u, c, d); }

/// m . n by derivatives at one parameter.
Q product(const KnotList<Q>& u, const Row& c, const Row& d, const RulingPlace& at) {
  const auto derivative = [&](const Row& row) { return curve_derivative<Q, Point>(u, row, at.piece, at.parameter); };
  const auto value = [&](const Row& row) { return curve_point<Q, Point>(u, row, at.piece, at.parameter); };
  const Point w = difference(value(d), value(c));
  return dot(cross(derivative(c), w), cross(derivative(d), w));
}

TEST(Folds, AParallelStripHasNone) {
  const KnotList<Q> u = bezier_knots<Q>(2);
  EXPECT_FALSE(
      fold(u, {point(0, 0, 0), point(1, 2, 0), point(2, 0, 0)}, {point(0, 0, 1), point(1, 2, 1), point(2, 0, 1)}));
}

/// Rails that run in opposite directions: every ruling meets the lines' crossing.
TEST(Folds, RailsAgainstEachOtherFold) {
  const KnotList<Q> u = bezier_knots<Q>(1);
  EXPECT_TRUE(fold(u, {point(0, 0, 0), point(2, 0, 0)}, {point(2, 1, 0), point(0, 1, 0)}));
}

/// A plane strip whose second rail turns back: d' = (1 - 2t, 0, 0) against c' = (1, 0, 0), and w = (., 1, 0), so
/// m . n = 1 - 2t.
TEST(Folds, TheFirstNegativePieceIsTheWitness) {
  const KnotList<Q> u = bezier_knots<Q>(2);
  const Row c{point(0, 0, 0), Point(ratio<Q>(1, 2), Q(0), Q(0)), point(1, 0, 0)};
  const Row d{point(0, 1, 0), Point(ratio<Q>(1, 2), Q(1), Q(0)), point(0, 1, 0)};
  const auto found = fold(u, c, d);
  ASSERT_TRUE(found);
  EXPECT_LT(product(u, c, d, *found), Q(0));
  EXPECT_GT(found->parameter, ratio<Q>(1, 2));
}

/// The same up to t = 1/2, where a normal vanishes at the end of the strip only.
TEST(Folds, ANormalThatVanishesAtTheEndIsNone) {
  const KnotList<Q> u = bezier_knots<Q>(2);
  const Row c{point(0, 0, 0), Point(ratio<Q>(1, 2), Q(0), Q(0)), point(1, 0, 0)};
  const Row d{point(0, 1, 0), point(1, 1, 0), point(1, 1, 0)};
  EXPECT_FALSE(fold(u, c, d));
}

/// d' = (2t - 1)^2 / 4 (1, 0, 0) and (3t - 1)^2 (1, 0, 0): m . n has a double zero inside, at a dyadic parameter that
/// halving meets, and at another one.
TEST(Folds, ADoubleZeroIsNone) {
  const KnotList<Q> u = bezier_knots<Q>(3);
  const auto on = [](std::int64_t n, std::int64_t den, int y) { return Point(ratio<Q>(n, den), Q(y), Q(0)); };
  const Row c{on(0, 1, 0), on(1, 3, 0), on(2, 3, 0), on(1, 1, 0)};
  const Row d{on(0, 1, 1), on(1, 3, 1), on(0, 1, 1), on(1, 3, 1)};
  EXPECT_EQ(product(u, c, d, {1, ratio<Q>(1, 2)}), Q(0));
  EXPECT_FALSE(fold(u, c, d));
  const Row thirds{on(0, 1, 1), on(1, 3, 1), on(-1, 3, 1), on(1, 1, 1)};
  EXPECT_EQ(product(u, c, thirds, {1, ratio<Q>(1, 3)}), Q(0));
  EXPECT_FALSE(fold(u, c, thirds));
}

TEST(Folds, WitnessesOfDrawnStrips) {
  int folded = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const KnotList<Q> u(3, {Q(0), Q(0), Q(0), ratio<Q>(1, 3), Q(4), Q(4), Q(4)});
    Row c, d;
    for (const Point2& p : points(u, seed)) c.push_back(Point(p[0], p[1], Q(0)));
    // Every other strip is nearly a cylinder.
    const Q noise = seed % 2 == 0 ? Q(1) : ratio<Q>(1, 1000);
    for (std::size_t i = 0; const Point2& p : points(u, seed + 100)) {
      const Point& base = c[i++];
      d.push_back(Point(base[0] + noise * p[0], base[1] + noise * p[1], Q(5)));
    }
    if (const auto found = fold(u, c, d)) {
      ++folded;
      EXPECT_LT(product(u, c, d, *found), Q(0));
      continue;
    }
    for (int i = 0; i < 20; ++i) {
      EXPECT_GE(product(u, c, d, {1, ratio<Q>(i, 60)}), Q(0));
      EXPECT_GE(product(u, c, d, {2, Q(4) - ratio<Q>(11 * i, 60)}), Q(0));
    }
  }
  EXPECT_GT(folded, 10);
  EXPECT_LT(folded, 60);
}

}  // namespace
}  // namespace torse::test
