// Meshes against the exact surface: Cox-de Boor in rationals, distances from triangles, topology by edges.
#include "torse/cli/mesh.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "torse/spline/basis.hpp"
#include "unit/developable/nets.hpp"

namespace torse::cli {
namespace {

using test::knots;
using test::Q;
using D3 = Vec<double, 3>;

constexpr auto doubles = MeshPrecision::double_float;

RuledFile<Q> surface_of(KnotList<Q> u, const std::vector<Vec<Q, 3>>& c, const std::vector<Vec<Q, 3>>& d,
                        std::vector<Q> c_weights = {}, std::vector<Q> d_weights = {}) {
  c_weights.resize(c.size(), Q(1));
  d_weights.resize(d.size(), Q(1));
  return {std::move(u), {c, std::move(c_weights)}, {d, std::move(d_weights)}};
}

/// A cubic with two pieces and weights, c and d unrelated.
RuledFile<Q> rational_cubic() {
  return surface_of(knots(3, {0, 0, 0, 2, 3, 3, 3}), test::points(5, 3), test::points(5, 4),
                    {Q(1), Q(2), Q(1), Q(3), Q(1)}, {Q(1), Q(1) / Q(2), Q(1), Q(1), Q(4)});
}

/// A developable one: a cone over a spline curve, d - O = (c - O) / 2 with O = (1, 2, 50).
RuledFile<Q> cone(bool to_the_vertex) {
  const Vec<Q, 3> vertex = test::point(1, 2, 50);
  const std::vector<Vec<Q, 3>> c{test::point(0, 0, 0), test::point(3, 8, 1), test::point(9, 9, 0),
                                 test::point(12, 1, -2)};
  std::vector<Vec<Q, 3>> d;
  const Q ratio = to_the_vertex ? Q(0) : Q(1) / Q(2);
  for (const Vec<Q, 3>& x : c) d.push_back(combine(Q(1) - ratio, vertex, ratio, x));
  return surface_of(knots(2, {0, 0, 1, 4, 4}), c, d);
}

/// The exact points of both rails at t of the i-th piece of positive length, by the basis functions.
std::pair<Vec<Q, 3>, Vec<Q, 3>> exact_ends(const RuledFile<Q>& surface, std::size_t i, double t) {
  const int k = surface.knots.proper_pieces()[i];
  const std::vector<BinaryForm<Q>> basis = basis_forms(surface.knots, k);
  const auto at = [&](const WeightedPoints<Q, 3>& net) {
    const std::vector<Vec<Q, 4>> rows = homogeneous(net);
    const auto forms = piece_forms<Q, 4>(basis, rows, k);
    const Q r = Q::from_double(t);
    const Q s = Q(1) - r;
    const Q w = forms[0](s, r);
    return Vec<Q, 3>(forms[1](s, r) / w, forms[2](s, r) / w, forms[3](s, r) / w);
  };
  return {at(surface.c), at(surface.d)};
}

D3 to_double(const Vec<Q, 3>& x) { return {x[0].to_double(), x[1].to_double(), x[2].to_double()}; }
D3 vec(const MeshVector& x) { return {x[0], x[1], x[2]}; }

double segment(const D3& p, const D3& a, const D3& b) {
  const double length2 = (b - a).squaredNorm();
  const double t = length2 == 0 ? 0 : std::clamp((p - a).dot(b - a) / length2, 0.0, 1.0);
  return (p - a - t * (b - a)).norm();
}

/// The distance of a point from a triangle: from the plane if the foot is inside, else from the nearest edge.
double triangle_distance(const D3& p, const D3& a, const D3& b, const D3& c) {
  const D3 n = (b - a).cross(c - a);
  const auto inside = [&](const D3& x, const D3& y) { return (y - x).cross(p - x).dot(n) >= 0; };
  if (n.norm() > 0 && inside(a, b) && inside(b, c) && inside(c, a)) return std::abs((p - a).dot(n)) / n.norm();
  return std::min({segment(p, a, b), segment(p, b, c), segment(p, c, a)});
}

double strip_distance(const D3& p, const MeshStrip& s) {
  const D3 c0 = vec(s.c[0]), c1 = vec(s.c[1]), d0 = vec(s.d[0]), d1 = vec(s.d[1]);
  if ((c0 - d1).norm() < (c1 - d0).norm()) {
    return std::min(triangle_distance(p, c0, c1, d1), triangle_distance(p, c0, d1, d0));
  }
  return std::min(triangle_distance(p, c0, c1, d0), triangle_distance(p, c1, d1, d0));
}

/// The largest distance of 17 times 9 points of a strip from its triangles.
double sampled_deviation(const RuledFile<Q>& surface, const MeshStrip& s) {
  double most = 0;
  for (int i = 0; i <= 16; ++i) {
    const auto [c, d] = exact_ends(surface, s.piece, s.from + (s.to - s.from) * i / 16);
    for (int j = 0; j <= 8; ++j) {
      most = std::max(most, strip_distance(to_double(combine(Q(8 - j) / Q(8), c, Q(j) / Q(8), d)), s));
    }
  }
  return most;
}

struct Shape {
  const char* name;
  RuledFile<Q> surface;
};

std::vector<Shape> shapes() {
  std::vector<Shape> list{
      {"rational cubic", rational_cubic()}, {"cone", cone(false)}, {"cone to its vertex", cone(true)}};
  for (const KnotList<Q>& u : test::knot_lists()) {
    list.push_back({"spline", surface_of(u, test::points(u.last() + 1, 5), test::points(u.last() + 1, 6))});
  }
  return list;
}

TEST(Mesh, CornersAreOnTheExactSurface) {
  for (const Shape& shape : shapes()) {
    SCOPED_TRACE(shape.name);
    const RuledArcs arcs = arcs_of(shape.surface);
    for (const MeshStrip& s : cut_strips(arcs, 10 * default_tolerance(arcs), doubles)) {
      for (std::size_t end : {0U, 1U}) {
        const auto [c, d] = exact_ends(shape.surface, s.piece, end == 0 ? s.from : s.to);
        EXPECT_LE((to_double(c) - vec(s.c[end])).norm(), std::ldexp(1 + to_double(c).norm(), -47));
        EXPECT_LE((to_double(d) - vec(s.d[end])).norm(), std::ldexp(1 + to_double(d).norm(), -47));
      }
    }
  }
}

TEST(Mesh, TheBoundHoldsAndIsNotVacuous) {
  for (const Shape& shape : shapes()) {
    SCOPED_TRACE(shape.name);
    const RuledArcs arcs = arcs_of(shape.surface);
    const double tolerance = 20 * default_tolerance(arcs);
    double bound = 0;
    double sampled = 0;
    for (const MeshStrip& s : cut_strips(arcs, tolerance, doubles)) {
      const double found = sampled_deviation(shape.surface, s);
      ASSERT_LE(found, s.deviation * (1 + 1e-9));
      bound = std::max(bound, s.deviation);
      sampled = std::max(sampled, found);
    }
    EXPECT_LE(bound, tolerance);
    EXPECT_GE(sampled, bound / 12);
  }
}

TEST(Mesh, EveryPointOfATriangleIsNearTheSurface) {
  const RuledFile<Q> surface = rational_cubic();
  const RuledArcs arcs = arcs_of(surface);
  std::vector<MeshStrip> strips = cut_strips(arcs, 30 * default_tolerance(arcs), doubles);
  strips.resize(6);
  for (const MeshStrip& s : strips) {
    std::vector<std::pair<D3, D3>> rulings;
    for (int i = 0; i <= 64; ++i) {
      const auto [c, d] = exact_ends(surface, s.piece, s.from + (s.to - s.from) * i / 64);
      rulings.emplace_back(to_double(c), to_double(d));
    }
    double spacing = 0;
    for (std::size_t i = 1; i < rulings.size(); ++i) {
      spacing = std::max({spacing, (rulings[i].first - rulings[i - 1].first).norm(),
                          (rulings[i].second - rulings[i - 1].second).norm()});
    }
    const bool first_diagonal = (vec(s.c[0]) - vec(s.d[1])).norm() < (vec(s.c[1]) - vec(s.d[0])).norm();
    const D3 middle = first_diagonal ? (vec(s.c[0]) + vec(s.d[1])) / 2 : (vec(s.c[1]) + vec(s.d[0])) / 2;
    for (const MeshVector& corner : {s.c[0], s.c[1], s.d[0], s.d[1]}) {
      const D3 p = (middle + vec(corner)) / 2;
      double nearest = spacing + s.deviation + 1;
      for (const auto& [c, d] : rulings) nearest = std::min(nearest, segment(p, c, d));
      EXPECT_LE(nearest, s.deviation + spacing);
    }
  }
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// How often each directed edge is used.
std::map<Edge, int> edges_of(const TriangleMesh& mesh) {
  std::map<Edge, int> edges;
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++edges[{t[i].point, t[(i + 1) % 3].point}];
  }
  return edges;
}

/// Each edge once in a direction; V - E + F; the number of edges without a neighbour.
struct Topology {
  bool oriented = true;
  long euler = 0;
  long boundary = 0;
};

Topology topology_of(const TriangleMesh& mesh) {
  Topology topology;
  std::set<Edge> undirected;
  const std::map<Edge, int> edges = edges_of(mesh);
  for (const auto& [edge, count] : edges) {
    topology.oriented &= count == 1;
    undirected.insert(std::minmax(edge.first, edge.second));
    if (!edges.contains({edge.second, edge.first})) ++topology.boundary;
  }
  topology.euler = static_cast<long>(mesh.points.size()) - static_cast<long>(undirected.size()) +
                   static_cast<long>(mesh.triangles.size());
  return topology;
}

TEST(Mesh, IsADisk) {
  for (const Shape& shape : shapes()) {
    SCOPED_TRACE(shape.name);
    const RuledArcs arcs = arcs_of(shape.surface);
    const std::vector<MeshStrip> strips = cut_strips(arcs, 10 * default_tolerance(arcs), doubles);
    const TriangleMesh mesh = mesh_of_strips(arcs, strips);
    const Topology topology = topology_of(mesh);
    EXPECT_TRUE(topology.oriented);
    EXPECT_EQ(topology.euler, 1);
    const bool tip = std::string(shape.name) == "cone to its vertex";
    EXPECT_EQ(mesh.triangles.size(), (tip ? 1 : 2) * strips.size());
    EXPECT_EQ(topology.boundary, static_cast<long>(tip ? strips.size() + 2 : 2 * strips.size() + 2));
  }
}

TEST(Mesh, AClosedCylinderHasNoSeam) {
  const auto at = [](int x, int y, int z) { return test::point(x, y, z); };
  // The unit circle in three arcs would need roots; this closed curve is one through rational points.
  const std::vector<Vec<Q, 3>> c{at(1, 0, 0), at(1, 1, 0), at(-1, 1, 0), at(-1, -1, 0), at(1, -1, 0), at(1, 0, 0)};
  std::vector<Vec<Q, 3>> d = c;
  for (Vec<Q, 3>& x : d) x[2] += Q(3);
  const RuledArcs arcs = arcs_of(surface_of(knots(2, {0, 0, 1, 2, 3, 4, 4}), c, d));
  const std::vector<MeshStrip> strips = cut_strips(arcs, 1e-3, doubles);
  const Topology topology = topology_of(mesh_of_strips(arcs, strips));
  EXPECT_TRUE(topology.oriented);
  EXPECT_EQ(topology.euler, 0);
  EXPECT_EQ(topology.boundary, static_cast<long>(2 * strips.size()));
}

TEST(Mesh, DevelopableSurfacesNeedFewStrips) {
  const RuledArcs arcs = arcs_of(cone(false));
  const std::size_t coarse = cut_strips(arcs, 1e-2, doubles).size();
  const std::size_t fine = cut_strips(arcs, 1e-6, doubles).size();
  EXPECT_LE(fine, 200 * coarse);  // the root of 1e4 times, and what halving overshoots
}

TEST(Mesh, KinksStayAndHaveTwoNormals) {
  const std::vector<Vec<Q, 3>> c{test::point(0, 0, 0), test::point(1, 0, 0), test::point(1, 1, 0)};
  std::vector<Vec<Q, 3>> d = c;
  for (Vec<Q, 3>& x : d) x[2] += Q(2);
  const RuledArcs arcs = arcs_of(surface_of(knots(1, {0, 1, 3}), c, d));
  const TriangleMesh mesh = mesh_surface(arcs, 1e-6, doubles);
  EXPECT_EQ(mesh.triangles.size(), 4U);
  EXPECT_EQ(mesh.points, (std::vector<MeshVector>{{0, 0, 0}, {1, 0, 0}, {0, 0, 2}, {1, 0, 2}, {1, 1, 0}, {1, 1, 2}}));
  EXPECT_EQ(mesh.normals, (std::vector<MeshVector>{{0, -1, 0}, {1, 0, 0}}));
  for (std::size_t t = 0; t < 4; ++t) {
    for (const MeshCorner& corner : mesh.triangles[t]) EXPECT_EQ(corner.normal, t / 2) << t;
  }
}

TEST(Mesh, NormalsAreAcrossRulingsAndRails) {
  const RuledFile<Q> surface = rational_cubic();
  const RuledArcs arcs = arcs_of(surface);
  for (const MeshStrip& s : cut_strips(arcs, 20 * default_tolerance(arcs), doubles)) {
    const double h = (s.to - s.from) * std::ldexp(1, -20);
    const auto [c, d] = exact_ends(surface, s.piece, s.from);
    const auto [c_next, d_next] = exact_ends(surface, s.piece, s.from + h);
    const D3 ruling = to_double(difference(d, c)).normalized();
    const D3 tangent = to_double(difference(c_next, c)).normalized();
    ASSERT_TRUE(s.c_normal[0]);
    const D3 n = vec(*s.c_normal[0]);
    EXPECT_NEAR(n.norm(), 1, 1e-12);
    EXPECT_NEAR(n.dot(ruling), 0, 1e-12);
    EXPECT_NEAR(n.dot(tangent), 0, 1e-4);
    EXPECT_GT(n.dot(tangent.cross(ruling)), 0);
  }
}

TEST(Mesh, SinglePrecisionIsCounted) {
  RuledFile<Q> surface = cone(false);
  const RuledArcs near = arcs_of(surface);
  for (const MeshStrip& s : cut_strips(near, 1e-2, MeshPrecision::single_float)) {
    for (const MeshVector& x : {s.c[0], s.c[1], s.d[0], s.d[1]}) {
      for (double v : x) EXPECT_EQ(static_cast<double>(static_cast<float>(v)), v);
    }
    EXPECT_LE(sampled_deviation(surface, s), s.deviation);
  }
  for (WeightedPoints<Q, 3>* row : {&surface.c, &surface.d}) {
    for (Vec<Q, 3>& x : row->points) x[0] += Q(10'000'000);
  }
  const RuledArcs far = arcs_of(surface);
  EXPECT_EQ(test::place_of([&] { return cut_strips(far, 1e-2, MeshPrecision::single_float); }), "tolerance");
  EXPECT_EQ(test::place_of([&] { return cut_strips(far, 1e-2, doubles); }), "");
}

TEST(Mesh, AnySizeIsTheSameMesh) {
  const RuledFile<Q> surface = rational_cubic();
  const RuledArcs arcs = arcs_of(surface);
  const std::vector<MeshStrip> strips = cut_strips(arcs, 1, doubles);
  for (int exponent : {-900, 900}) {
    RuledFile<Q> scaled = surface;
    const Q factor = Q::from_double(std::ldexp(1, exponent));
    for (WeightedPoints<Q, 3>* row : {&scaled.c, &scaled.d}) {
      for (Vec<Q, 3>& x : row->points) scale(x, factor);
    }
    const std::vector<MeshStrip> same = cut_strips(arcs_of(scaled), std::ldexp(1, exponent), doubles);
    ASSERT_EQ(same.size(), strips.size());
    for (std::size_t i = 0; i < same.size(); ++i) EXPECT_EQ(same[i].c[0][1], std::ldexp(strips[i].c[0][1], exponent));
  }
}

TEST(Mesh, WhatHasNoMesh) {
  const auto place = [](const RuledFile<Q>& surface, double tolerance) {
    return test::place_of([&] { return cut_strips(arcs_of(surface), tolerance, doubles); });
  };
  RuledFile<Q> pole = rational_cubic();
  pole.c.weights[1] = Q(-5);
  EXPECT_EQ(place(pole, 1), "weights");
  RuledFile<Q> pole_of_d = rational_cubic();
  pole_of_d.d.weights[1] = Q(-5);
  EXPECT_EQ(place(pole_of_d, 1), "weights");
  const RuledFile<Q> pole_at_a_knot =
      surface_of(knots(2, {0, 0, 1, 2, 2}), test::points(4, 3), test::points(4, 4), {Q(1), Q(1), Q(-1), Q(-1)});
  EXPECT_EQ(place(pole_at_a_knot, 1), "weights");
  EXPECT_EQ(place(rational_cubic(), 1e-30), "tolerance");
  const RuledFile<Q> twisted = surface_of(bezier_knots<Q>(1), {test::point(0, 0, 0), test::point(1, 0, 0)},
                                          {test::point(0, 1, 0), test::point(1, 1, 1)});
  EXPECT_EQ(place(twisted, 1e-3), "");
  EXPECT_EQ(place(twisted, 1e-6), "tolerance");
  const std::vector<Vec<Q, 3>> one(2, test::point(1, 2, 3));
  EXPECT_EQ(place(surface_of(bezier_knots<Q>(1), one, one), 1), "points");
  const std::vector<Vec<Q, 3>> line{test::point(0, 0, 0), test::point(1, 0, 0)};
  const RuledArcs same = arcs_of(surface_of(bezier_knots<Q>(1), line, line));
  EXPECT_EQ(test::place_of([&] { return mesh_surface(same, 1, doubles); }), "points");
  RuledFile<Q> negative = rational_cubic();
  for (Q& w : negative.d.weights) w = -w;
  EXPECT_EQ(place(negative, 1), "");
}

/// A triangle that ends in a point, and from there both rails on one segment of length sqrt(5^2 + 12^2) = 13, which no
/// triangle covers: it is as long as that, and beyond any smaller tolerance.
TEST(Mesh, APieceThatSweepsNoSurfaceIsNotLeftOutInSilence) {
  const std::vector<Vec<Q, 3>> c{test::point(-2, -3, 0), test::point(0, 0, 0), test::point(5, 12, 0)};
  const std::vector<Vec<Q, 3>> d{test::point(-2, -5, 4), test::point(0, 0, 0), test::point(5, 12, 0)};
  const RuledArcs arcs = arcs_of(surface_of(knots(1, {0, 2, 3}), c, d));
  EXPECT_EQ(test::place_of([&] { return mesh_surface(arcs, 12.999, doubles); }), "points");
  const TriangleMesh mesh = mesh_surface(arcs, 13.001, doubles);
  EXPECT_EQ(mesh.triangles.size(), 1U);
  EXPECT_NEAR(mesh.deviation, 13, 1e-6);
  EXPECT_GE(mesh.deviation, 13);
}

}  // namespace
}  // namespace torse::cli
