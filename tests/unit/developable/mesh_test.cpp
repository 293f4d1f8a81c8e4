// Normals of a mesh where a strip lacks some: of the other rail, of the other ruling, of the quadrangle.
#include "torse/developable/mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace torse {
namespace {

constexpr MeshVector x_axis{1, 0, 0};
constexpr MeshVector y_axis{0, 1, 0};
constexpr MeshVector z_axis{0, 0, 1};

/// A unit square in the plane z = 0, of two rulings along y.
MeshStrip square() { return {.c = {{{0, 0, 0}, {1, 0, 0}}}, .d = {{{0, 1, 0}, {1, 1, 0}}}}; }

TriangleMesh mesh_of(const MeshStrip& strip) { return mesh_of_strips({{RuledPiece{}}, 0}, {strip}); }

/// The normal at a point of the mesh, which all triangles there have.
MeshVector normal_at(const TriangleMesh& mesh, const MeshVector& place) {
  std::optional<MeshVector> found;
  for (const auto& triangle : mesh.triangles) {
    for (const MeshCorner& corner : triangle) {
      if (mesh.points[corner.point] != place) continue;
      EXPECT_TRUE(!found || *found == mesh.normals[corner.normal]);
      found = mesh.normals[corner.normal];
    }
  }
  EXPECT_TRUE(found);
  return found.value_or(MeshVector{});
}

TEST(MeshNormals, AreThoseOfTheCorners) {
  MeshStrip strip = square();
  strip.c_normal = {x_axis, y_axis};
  strip.d_normal = {z_axis, x_axis};
  const TriangleMesh mesh = mesh_of(strip);
  EXPECT_EQ(normal_at(mesh, strip.c[0]), x_axis);
  EXPECT_EQ(normal_at(mesh, strip.c[1]), y_axis);
  EXPECT_EQ(normal_at(mesh, strip.d[0]), z_axis);
  EXPECT_EQ(normal_at(mesh, strip.d[1]), x_axis);
}

TEST(MeshNormals, TheOtherEndOfTheRulingStandsIn) {
  MeshStrip strip = square();
  strip.c_normal = {x_axis, std::nullopt};
  strip.d_normal = {std::nullopt, y_axis};
  const TriangleMesh mesh = mesh_of(strip);
  for (const MeshVector& place : {strip.c[0], strip.d[0]}) EXPECT_EQ(normal_at(mesh, place), x_axis);
  for (const MeshVector& place : {strip.c[1], strip.d[1]}) EXPECT_EQ(normal_at(mesh, place), y_axis);
}

TEST(MeshNormals, TheOtherRulingStandsIn) {
  for (const std::size_t end : {0U, 1U}) {
    for (const bool on_c : {true, false}) {
      MeshStrip strip = square();
      (on_c ? strip.c_normal : strip.d_normal)[end] = x_axis;
      const TriangleMesh mesh = mesh_of(strip);
      for (const MeshVector& place : {strip.c[0], strip.c[1], strip.d[0], strip.d[1]}) {
        EXPECT_EQ(normal_at(mesh, place), x_axis);
      }
    }
  }
  MeshStrip both = square();
  both.c_normal[0] = y_axis;
  both.d_normal[0] = z_axis;
  EXPECT_EQ(normal_at(mesh_of(both), both.c[1]), y_axis) << "that of the first rail before that of the second";
}

/// Squares across all axes, and one across (2, 3, 6)/7: c = 0, (3, -6, 2), d = (6, 2, -3), c + d.
TEST(MeshNormals, TheQuadrangleStandsIn) {
  const auto facet = [](const MeshVector& along, const MeshVector& across) {
    MeshStrip strip;
    for (std::size_t j = 0; j < 3; ++j) {
      strip.c[1][j] = along[j];
      strip.d[0][j] = across[j];
      strip.d[1][j] = along[j] + across[j];
    }
    return normal_at(mesh_of(strip), strip.c[1]);
  };
  EXPECT_EQ(facet(x_axis, y_axis), z_axis);
  EXPECT_EQ(facet(y_axis, z_axis), x_axis);
  EXPECT_EQ(facet(z_axis, x_axis), y_axis);
  const MeshVector tilted = facet({3, -6, 2}, {6, 2, -3});
  const MeshVector expected{2.0 / 7, 3.0 / 7, 6.0 / 7};
  for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(tilted[j], expected[j], 1e-15);
}

/// Diagonals (1, 2, 2) and (2, 1, -2): across both is (-6, 6, -3).
TEST(MeshNormals, TheQuadranglesDiagonalsCount) {
  const MeshStrip strip{.c = {{{1, 1, 1}, {1, 2, 4}}}, .d = {{{3, 3, 2}, {2, 3, 3}}}};
  const MeshVector found = normal_at(mesh_of(strip), strip.c[0]);
  const MeshVector expected{-2.0 / 3, 2.0 / 3, -1.0 / 3};
  for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(found[j], expected[j], 1e-15);
  const MeshStrip line{.c = {{{0, 0, 0}, {1, 1, 1}}}, .d = {{{2, 2, 2}, {3, 3, 3}}}};
  EXPECT_EQ(normal_at(mesh_of(line), line.c[0]), z_axis) << "any where they are parallel";
}

/// Two squares, the second with other normals: those of the first go on, unless a kink is between them.
TEST(MeshNormals, AreTwoAtAKink) {
  MeshStrip first = square();
  first.c_normal = first.d_normal = {y_axis, z_axis};
  MeshStrip second{.piece = 1, .c = {{{1, 0, 0}, {2, 0, 0}}}, .d = {{{1, 1, 0}, {2, 1, 0}}}};
  second.c_normal = second.d_normal = {x_axis, y_axis};
  const auto second_normal = [&](bool kink) {
    RuledPiece piece;
    piece.kink_before = kink;
    const TriangleMesh mesh = mesh_of_strips({{RuledPiece{}, piece}, 0}, {first, second});
    return mesh.normals[mesh.triangles[2][0].normal];
  };
  EXPECT_EQ(second_normal(false), z_axis);
  EXPECT_EQ(second_normal(true), x_axis);
  first.piece = 1;
  EXPECT_EQ(second_normal(true), z_axis) << "the kink is before both";
}

/// A strip has two triangles, one where two of its corners are one point, none where it is a line.
TEST(MeshTriangles, HaveThreePoints) {
  const MeshVector a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0}, d{1, 1, 0};
  const auto triangles = [](const MeshVector& c0, const MeshVector& c1, const MeshVector& d0, const MeshVector& d1) {
    return mesh_of({.c = {c0, c1}, .d = {d0, d1}}).triangles.size();
  };
  EXPECT_EQ(triangles(a, b, c, d), 2U);
  EXPECT_EQ(triangles(a, a, c, d), 1U);
  EXPECT_EQ(triangles(a, b, c, c), 1U);
  EXPECT_EQ(triangles(a, b, a, d), 1U);
  EXPECT_EQ(triangles(a, b, c, b), 1U);
  EXPECT_EQ(triangles(a, b, a, b), 0U);
  EXPECT_EQ(triangles(a, a, c, c), 0U);
}

/// A triangle that ends at (1, 0, 0), a line along y and one to (4, 4, 0), where another triangle begins: the first
/// line is 3 from the triangle before it, the second one sqrt(10) from the one behind it.
TEST(MeshTriangles, WhatHasNoneIsAsFarAsItIsFromThem) {
  const auto line = [](const MeshVector& from, const MeshVector& to) {
    return MeshStrip{.piece = 1, .c = {from, to}, .d = {from, to}};
  };
  const MeshStrip before{.piece = 0, .c = {{{0, 0, 0}, {1, 0, 0}}}, .d = {{{0, 1, 0}, {1, 0, 0}}}, .deviation = 0.5};
  const MeshStrip behind{.piece = 2, .c = {{{4, 4, 0}, {5, 4, 0}}}, .d = {{{4, 4, 0}, {4, 5, 0}}}};
  MeshStrip first = line({1, 0, 0}, {1, 3, 0});
  const MeshStrip second = line({1, 3, 0}, {4, 4, 0});
  for (const int exponent : {0, 7}) {
    const RuledArcs arcs{{RuledPiece{}, RuledPiece{}, RuledPiece{}}, exponent};
    const auto expect = [&](const std::vector<MeshStrip>& strips, double deviation, std::size_t piece) {
      const TriangleMesh mesh = mesh_of_strips(arcs, strips);
      EXPECT_NEAR(mesh.deviation, deviation, 1e-12);
      EXPECT_GE(mesh.deviation, deviation);
      EXPECT_EQ(mesh.worst_piece, piece);
    };
    expect({before, first, second, behind}, std::sqrt(10), 1);
    expect({before, first, second}, 5, 1);
    expect({first, second, behind}, 5, 1);
    expect({before, first}, 3, 1);
    expect({before, line({1, 0, 0}, {1, 0.25, 0})}, 0.5, 0);
    first.deviation = 0.25;
    expect({before, first}, 3.25, 1);
    first.deviation = 0;
    EXPECT_TRUE(std::isinf(mesh_of_strips(arcs, {first}).deviation));
  }
}

/// A triangle between rails of which one is its other one's beginning: c from (0, 0, 0) over (1, 2, 2) to (3, 2, 2), d
/// at (0, 0, 0). The first strip is the first ruling of the second one, on it from end to end.
TEST(MeshTriangles, AStripAlongARulingIsWithIt) {
  const MeshVector o{0, 0, 0}, a{1, 2, 2}, b{3, 2, 2};
  const MeshStrip first{.piece = 0, .c = {o, a}, .d = {o, o}, .deviation = 0.25};
  const MeshStrip second{.piece = 0, .c = {a, b}, .d = {o, o}, .deviation = 0.125};
  const RuledArcs arcs{{RuledPiece{}}, 0};
  EXPECT_EQ(mesh_of_strips(arcs, {first, second}).deviation, 0.25);
  const MeshStrip last{.piece = 0, .c = {o, o}, .d = {a, o}, .deviation = 0.25};
  EXPECT_EQ(mesh_of_strips(arcs, {{.piece = 0, .c = {o, o}, .d = {b, a}}, last}).deviation, 0.25);
}

/// Lines from the ruling between (4, 0, 0) and (0, 0, 0): 2 from it above its inside, 5 beyond either end.
TEST(MeshTriangles, TheDistanceIsThatFromTheRuling) {
  const MeshVector o{0, 0, 0}, a{4, 0, 0};
  const MeshStrip before{.piece = 0, .c = {{{4, 4, 0}, a}}, .d = {o, o}};
  for (const auto& [to, distance] : {std::pair{MeshVector{1, 2, 0}, 2.0}, {{8, 3, 0}, 5.0}, {{-3, 0, 4}, 5.0}}) {
    const MeshStrip line{.piece = 1, .c = {a, to}, .d = {a, to}};
    const double found = mesh_of_strips({{RuledPiece{}, RuledPiece{}}, 3}, {before, line}).deviation;
    EXPECT_NEAR(found, distance, 1e-12);
    EXPECT_GE(found, distance);
  }
}

/// A strip that is a ruling is one of its neighbour.
TEST(MeshTriangles, ARulingIsWithItsNeighbour) {
  const MeshStrip ruling{.piece = 1, .c = {{{1, 0, 0}, {1, 0, 0}}}, .d = {{{1, 1, 0}, {1, 1, 0}}}};
  EXPECT_EQ(mesh_of_strips({{RuledPiece{}, RuledPiece{}}, 0}, {square(), ruling}).deviation, 0);
}

}  // namespace
}  // namespace torse
