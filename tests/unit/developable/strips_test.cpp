// Bounds of strips and the normals of a mesh against values by hand.
#include "torse/developable/strips.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "torse/developable/mesh.hpp"

namespace torse {
namespace {

Vec<Interval, 3> point(double x, double y, double z) {
  return {Interval::point(x), Interval::point(y), Interval::point(z)};
}

/// One piece by points with weight 1.
RuledPiece piece(const ArcPoints& c, const ArcPoints& d) {
  const auto row = [](const ArcPoints& points) {
    ArcRow rows;
    for (const auto& x : points) rows.emplace_back(Interval(1), x[0], x[1], x[2]);
    return rows;
  };
  return {row(c), row(d), {c.front(), c.back()}, {d.front(), d.back()}};
}

/// The quotients of all numbers in the intervals. A weight of exactly 1 leaves the others as they are.
TEST(ArcPoints, AreDividedByTheirWeights) {
  const auto expect_x = [](const Interval& weight, const Interval& x, double lower, double upper) {
    const std::optional<ArcPoints> points = arc_points({{weight, x, Interval(0), Interval(0)}});
    ASSERT_TRUE(points);
    EXPECT_EQ(points->front()[0].lower(), lower);
    EXPECT_EQ(points->front()[0].upper(), upper);
  };
  expect_x(Interval(1), Interval::hull(2, 3), 2, 3);
  expect_x(Interval::hull(1, 2), Interval(1), 0.5, 1);
  expect_x(Interval::hull(0.5, 1), Interval(1), 1, 2);
  expect_x(Interval::hull(-2, -1), Interval(1), -1, -0.5);
  EXPECT_FALSE(arc_points({{Interval::hull(0, 1), Interval(1), Interval(1), Interval(1)}}));
  EXPECT_FALSE(arc_points({{Interval::hull(-1, 0), Interval(1), Interval(1), Interval(1)}}));
}

/// x = 6t - 5t^2 goes on to 9/5 at t = 3/5 before it comes back to 1, all along the chord [0, 1].
TEST(RailDeviation, SeesACurveThatRunsBeyondItsChord) {
  EXPECT_GE(rail_deviation({point(0, 0, 0), point(3, 0, 0), point(1, 0, 0)}), 0.8);
  EXPECT_GE(rail_deviation({point(0, 0, 0), point(-2, 0, 0), point(1, 0, 0)}), 0.8);
  EXPECT_EQ(rail_deviation({point(0, 0, 0), point(0.5, 0, 0), point(1, 0, 0)}), 0);
}

/// A unit square with one corner lifted by z. The middle of the diagonal to that corner is over the other diagonal by
/// z/2, z/(2 sqrt(1 + 2z^2)) away from the nearer triangle, through (1, 0, 0), (1, 1, z) and (0, 1, 0).
TEST(QuadDeviation, ReachesTheMiddleOfTheLongerDiagonal) {
  for (const double z : {1e-3, 0.1, 0.5}) {
    const double bound = quad_deviation(point(0, 0, 0), point(1, 0, 0), point(0, 1, 0), point(1, 1, z));
    EXPECT_GE(bound, z / 2 / std::sqrt(1 + 2 * z * z));
    EXPECT_LE(bound, z / 2 * (1 + 1e-12));
  }
}

/// A flat quadrangle with a corner that points inwards, which is any of the four: (3/2, 3/2), on a triangle of one of
/// the diagonals, is 1.5 / sqrt(5) away from all segments.
TEST(QuadDeviation, OfAQuadrangleWithACornerThatPointsInwards) {
  std::array around{point(0, 0, 0), point(3, 0, 0), point(1, 1, 0), point(0, 3, 0)};
  for (int turn = 0; turn < 4; ++turn) {
    EXPECT_GE(quad_deviation(around[0], around[1], around[3], around[2]), 1.5 / std::sqrt(5.0)) << turn;
    std::rotate(around.begin(), around.begin() + 1, around.end());
  }
}

/// The bound is as large as the quadrangle, whatever it looks like: lifted, seen convex or not, folded, flat.
TEST(QuadDeviation, ScalesWithTheQuadrangle) {
  std::mt19937 random(5);
  const auto coordinate = [&] { return static_cast<int>(random() % 19) - 9; };
  for (int trial = 0; trial < 200; ++trial) {
    std::array<Vec<Interval, 3>, 4> corners;
    for (auto& x : corners) {
      const int a = coordinate();
      const int b = coordinate();
      x = point(a, b, trial % 3 == 0 ? 0 : coordinate());
    }
    const auto bound = [&](double size) {
      std::array<Vec<Interval, 3>, 4> x;
      for (std::size_t i = 0; i < 4; ++i) {
        for (int k = 0; k < 3; ++k) x[i][k] = Interval::point(size) * corners[i][k];
      }
      return quad_deviation(x[0], x[1], x[2], x[3]);
    };
    for (const double size : {0x1p-20, 0x1p20}) {
      EXPECT_NEAR(bound(size) / size, bound(1), 1e-12 * bound(1)) << trial;
    }
  }
}

/// The corners of a plane rectangle are rounded to single precision, and nothing else is off.
TEST(CutStrips, RoundingIsPartOfTheDeviation) {
  const Interval third = Interval(1) / Interval(3);
  const auto at = [&](int x, int y) { return Vec<Interval, 3>(third * Interval(x), third * Interval(y), Interval()); };
  const RuledArcs arcs{{piece({at(1, 1), at(7, 1)}, {at(1, 5), at(7, 5)})}, 0};
  const auto strips = cut_strips(arcs, 1e-3, MeshPrecision::single_float);
  ASSERT_EQ(strips.size(), 1U);
  const double off = std::abs(static_cast<double>(static_cast<float>(7.0 / 3)) - 7.0 / 3);
  EXPECT_GE(strips[0].deviation, off);
  EXPECT_LE(strips[0].deviation, 10 * off);
}

/// The cylinder over y = t^2 with rulings along z: the normals (2t, -1, 0), longer than 1, at both ends of both rails.
TEST(CutStrips, NormalsAtBothEndsOfBothRails) {
  const RuledArcs arcs{
      {piece({point(0, 0, 0), point(0.5, 0, 0), point(1, 1, 0)}, {point(0, 0, 1), point(0.5, 0, 1), point(1, 1, 1)})},
      0};
  const auto strips = cut_strips(arcs, 1, MeshPrecision::double_float);
  ASSERT_EQ(strips.size(), 1U);
  const double root = std::sqrt(5.0);
  for (const auto& normals : {strips[0].c_normal, strips[0].d_normal}) {
    ASSERT_TRUE(normals[0] && normals[1]);
    EXPECT_EQ(*normals[0], (MeshVector{0, -1, 0}));
    EXPECT_DOUBLE_EQ((*normals[1])[0], 2 / root);
    EXPECT_DOUBLE_EQ((*normals[1])[1], -1 / root);
  }
  // The corners of the mesh have the normals of their points.
  const TriangleMesh mesh = mesh_of_strips(arcs, strips);
  ASSERT_EQ(mesh.triangles.size(), 2U);
  for (const auto& triangle : mesh.triangles) {
    for (const MeshCorner& corner : triangle) {
      const double x = mesh.points[corner.point][0];
      EXPECT_NEAR(mesh.normals[corner.normal][0], 2 * x / std::sqrt(1 + 4 * x * x), 1e-15);
    }
  }
}

/// Squares with the rails along each axis.
TEST(CutStrips, NormalsOfRailsAlongAnAxis) {
  for (std::size_t along = 0; along < 3; ++along) {
    const auto at = [&](int rail, int ruling) {
      std::array<int, 3> x{};
      x[along] = rail;
      x[(along + 1) % 3] = ruling;
      return point(x[0], x[1], x[2]);
    };
    const RuledArcs arcs{{piece({at(0, 0), at(1, 0)}, {at(0, 1), at(1, 1)})}, 0};
    const auto strips = cut_strips(arcs, 1, MeshPrecision::double_float);
    ASSERT_EQ(strips.size(), 1U);
    MeshVector normal{};
    normal[(along + 2) % 3] = 1;
    for (const auto& normals : {strips[0].c_normal, strips[0].d_normal}) {
      ASSERT_TRUE(normals[0] && normals[1]) << along;
      EXPECT_EQ(*normals[0], normal);
      EXPECT_EQ(*normals[1], normal);
    }
  }
}

/// The parabola (0, 0), (1, 1), (2, 0) and the same 1 higher, by weights 1, r, r^2: it runs through its parameter in
/// the last r of [0, 1], and all before is near its begin. For r = 2^-30 that takes some 30 halvings, of the right half
/// every time.
std::vector<MeshStrip> late_parabola(int exponent, bool backwards = false) {
  const double r = std::ldexp(1, exponent);
  const auto rail = [&](double z) {
    ArcRow rows;
    for (const auto& [w, x, y] : {std::array{1.0, 0.0, 0.0}, {r, 1.0, 1.0}, {r * r, 2.0, 0.0}}) {
      rows.push_back({Interval::point(w), Interval::point(w * x), Interval::point(w * y), Interval::point(w * z)});
    }
    if (backwards) std::ranges::reverse(rows);
    return rows;
  };
  const RuledPiece piece{rail(0),
                         rail(1),
                         {point(backwards ? 2 : 0, 0, 0), point(backwards ? 0 : 2, 0, 0)},
                         {point(backwards ? 2 : 0, 0, 1), point(backwards ? 0 : 2, 0, 1)}};
  return cut_strips({{piece}, 0}, 0.01, MeshPrecision::double_float);
}

/// Each strip begins where the one before ended, up to the end, and the corners are on y = x - x^2 / 2.
TEST(CutStrips, GoFromEndToEndHoweverFastTheRails) {
  for (const auto& [exponent, backwards] : {std::pair{0, false}, {-30, false}, {-30, true}}) {
    SCOPED_TRACE(exponent);
    const std::vector<MeshStrip> strips = late_parabola(exponent, backwards);
    double end = 0;
    for (const MeshStrip& strip : strips) {
      EXPECT_EQ(strip.from, end);
      end = strip.to;
      EXPECT_LT(strip.from, end);
      EXPECT_TRUE(exponent != 0 || strip.c[1][0] == 2 * end);
      for (const MeshVector& x : strip.c) EXPECT_NEAR(x[1], x[0] - x[0] * x[0] / 2, 1e-9);
    }
    EXPECT_EQ(end, 1);
    EXPECT_EQ(strips.back().c[1], (MeshVector{backwards ? 0.0 : 2.0, 0, 0}));
    EXPECT_LT(strips.size(), 60U);
  }
}

/// Parameters have 48 bits, which do not part what happens within 2^-60.
TEST(CutStrips, DoNotEndWithoutAnEnd) {
  EXPECT_THROW(late_parabola(-60), InvalidInput);
  EXPECT_THROW(late_parabola(-60, true), InvalidInput);
}

}  // namespace
}  // namespace torse
