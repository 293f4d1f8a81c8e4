// The class of surfaces whose class is known from how they were made: points put on a plane, along a direction, through
// a vertex, on tangents; and degenerate nets. The expected vertices and directions are inputs, not results of library
// code.
#include "torse/developable/classify.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "torse/developable/condition.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/spline/curve.hpp"

namespace torse {
namespace {

using Q = Rational;
using Point3 = Vec<Q, 3>;

Point3 point(int x, int y, int z) { return Point3(Q(x), Q(y), Q(z)); }

/// A surface by its affine rows and weights.
struct Net {
  KnotList<Q> knots;
  WeightedPoints<Q, 3> c;
  WeightedPoints<Q, 3> d;

  Classification<Q> classified() const { return classify<Q>(knots, homogeneous(c), homogeneous(d)); }
  bool developable() const { return !find_witness<Q, 4>(knots, homogeneous(c), homogeneous(d)); }
};

Net net(std::vector<Point3> c, std::vector<Point3> d) {
  const int n = static_cast<int>(c.size()) - 1;
  const std::vector<Q> ones(c.size(), Q(1));
  return {bezier_knots<Q>(n), {std::move(c), ones}, {std::move(d), ones}};
}

const KnotList<Q> two_pieces(2, {Q(0), Q(0), Q(1), Q(1), Q(2), Q(2)});

const std::vector<Point3> cubic{point(0, 0, 0), point(1, 3, 0), point(2, 1, 5), point(7, 2, 1)};

TEST(Classify, PlaneWhateverTheRulings) {
  // z = x + 2y - 1, with weights
  const auto on_plane = [](int x, int y) { return point(x, y, x + 2 * y - 1); };
  Net plane = net({on_plane(0, 0), on_plane(5, 1), on_plane(-2, 3)}, {on_plane(1, 8), on_plane(2, 2), on_plane(9, -4)});
  plane.d.weights = {Q(3), Q(-1), Q(2)};
  EXPECT_TRUE(plane.developable());
  EXPECT_EQ(plane.classified().kind, SurfaceClass::plane);
}

TEST(Classify, CylinderWithRulingsOfAnyLengths) {
  std::vector<Point3> d = cubic;
  const int lengths[] = {1, 0, -4, 3};
  for (std::size_t i = 0; i < 4; ++i) add_scaled(d[i], Q(lengths[i]), point(2, -6, 4));
  const Classification<Q> found = net(cubic, d).classified();
  EXPECT_EQ(found.kind, SurfaceClass::cylinder);
  ASSERT_TRUE(found.direction.has_value());
  EXPECT_TRUE(*found.direction == point(1, -3, 2));
  EXPECT_FALSE(found.vertex.has_value());
}

TEST(Classify, CylinderAlongAnAxis) {
  std::vector<Point3> d = cubic;
  for (Point3& x : d) add(x, point(0, 0, -5));
  const Classification<Q> found = net(cubic, d).classified();
  EXPECT_EQ(found.kind, SurfaceClass::cylinder);
  EXPECT_TRUE(found.direction.value() == point(0, 0, 1));
}

/// Degree 2, `pieces` pieces between double knots; d_i = v_i + r_i (c_i - v_i).
template <class Vertex, class Ratio>
Net seen_from(int pieces, Vertex vertex, Ratio ratio) {
  std::vector<Q> knots;
  for (int i = 0; i <= pieces; ++i) knots.insert(knots.end(), 2, Q(i));
  std::vector<Point3> c, d;
  for (int i = 0; i <= 2 * pieces; ++i) {
    c.push_back(point(i, (i * i * 7) % 11 - 3, (i * 5) % 13 + 1));
    const Point3 v = vertex(i, c.back());
    Point3 x = v;
    add_scaled(x, Q(ratio(i)), difference(c.back(), v));
    d.push_back(x);
  }
  const std::vector<Q> ones(c.size(), Q(1));
  return {KnotList<Q>(2, knots), {c, ones}, {d, ones}};
}

TEST(Classify, ConesOfManyPieces) {
  const Point3 vertex = point(3, -20, 7);
  const auto same = [&](int, const Point3&) { return vertex; };
  const Classification<Q> found = seen_from(9, same, [](int) { return 3; }).classified();
  EXPECT_EQ(found.kind, SurfaceClass::cone);
  EXPECT_TRUE(found.vertex.value() == vertex);
}

/// The boundary curves pass through the vertex between two pieces, where the ratio may change.
TEST(Classify, ConesWhoseRatioChanges) {
  const Point3 vertex = point(8, 5, 2);  // c_8
  const auto same = [&](int, const Point3&) { return vertex; };
  const Net cone = seen_from(9, same, [](int i) { return i < 8 ? 3 : -2; });
  EXPECT_TRUE(cone.c.points[8] == vertex);
  EXPECT_TRUE(cone.developable());
  EXPECT_EQ(cone.classified().kind, SurfaceClass::cone);
  EXPECT_TRUE(cone.classified().vertex.value() == vertex);
}

TEST(Classify, TwoConesAreATangentSurface) {
  const Point3 first = point(3, -20, 7), shared = point(8, 5, 2);
  Point3 second = first;  // 2 (c - first) + first = 3 (c - second) + second for c = shared
  add(second, shared);
  divide(second, Q(2));
  const Net cones = seen_from(
      9, [&](int i, const Point3&) { return i <= 8 ? first : second; }, [](int i) { return i <= 8 ? 2 : 3; });
  EXPECT_TRUE(cones.c.points[8] == shared);
  EXPECT_TRUE(cones.developable());
  EXPECT_EQ(cones.classified().kind, SurfaceClass::tangent);
}

TEST(Classify, ConeByItsVertexAlsoBetweenDifferentWeights) {
  const Point3 vertex = point(3, -2, 11);
  Net cone = net(cubic, {});
  cone.c.weights = {Q(1), Q(2), Q(5), Q(-3)};
  // Rows q_i = p_i + k_i (1, vertex) put every q(t) on the line of p(t) and the vertex.
  const int multiples[] = {1, 4, -2, 1};
  std::vector<Vec<Q, 4>> q = homogeneous(cone.c);
  for (std::size_t i = 0; i < 4; ++i) {
    add_scaled(q[i], Q(multiples[i]), Vec<Q, 4>(Q(1), vertex[0], vertex[1], vertex[2]));
  }
  cone.d = dehomogenize<Q, 4>(q);
  EXPECT_TRUE(cone.developable());
  const Classification<Q> found = cone.classified();
  EXPECT_EQ(found.kind, SurfaceClass::cone);
  EXPECT_TRUE(found.vertex.value() == vertex);
}

TEST(Classify, ConeWhoseSecondRowIsItsVertex) {
  const Classification<Q> found = net(cubic, std::vector<Point3>(4, point(1, 1, 1))).classified();
  EXPECT_EQ(found.kind, SurfaceClass::cone);
  EXPECT_TRUE(found.vertex.value() == point(1, 1, 1));
}

TEST(Classify, TangentSurfaceOfTheTwistedCubic) {
  // c = (t, t^2, t^3), d = c + c': Bezier points by hand.
  const Q third = ratio<Q>(1, 3);
  const std::vector<Point3> c{point(0, 0, 0), Point3(third, Q(0), Q(0)), Point3(third + third, third, Q(0)),
                              point(1, 1, 1)};
  const std::vector<Point3> d{point(1, 0, 0), Point3(Q(1) + third, third + third, Q(0)),
                              Point3(Q(1) + third + third, Q(1) + third + third, Q(1)), point(2, 3, 4)};
  const Net tangent = net(c, d);
  EXPECT_TRUE(tangent.developable());
  EXPECT_EQ(tangent.classified().kind, SurfaceClass::tangent);
}

TEST(Classify, PiecesThatAgreeAndPiecesThatDoNot) {
  const std::vector<Point3> c{point(0, 0, 0), point(1, 2, 0), point(2, 2, 1), point(3, 1, 4), point(5, 5, 5)};
  std::vector<Point3> same(5), other(5);
  for (std::size_t i = 0; i < 5; ++i) same[i] = sum(c[i], point(1, 0, 3));
  const std::vector<Q> ones(5, Q(1));
  EXPECT_EQ((Net{two_pieces, {c, ones}, {same, ones}}.classified().kind), SurfaceClass::cylinder);

  // The first piece a cone over v, the second a cone over w, joined along the ruling through v and w.
  const Point3 v = point(0, 0, 8), w = combine(Q(3), v, Q(-2), c[2]);
  for (std::size_t i = 0; i < 5; ++i) other[i] = combine(Q(2), c[i], Q(-1), v);
  for (std::size_t i = 3; i < 5; ++i) {
    other[i] = other[2];
    add_scaled(other[i], Q(2), difference(c[i], c[2]));
  }
  const Net same_ratio{two_pieces, {c, ones}, {other, ones}};
  EXPECT_EQ(same_ratio.classified().kind, SurfaceClass::cone);
  // other[2] = 2 c_2 - v = c_2 + (c_2 - v); with ratio alpha about w: w + alpha (c_2 - w) = other[2] for alpha = 4/3.
  for (std::size_t i = 3; i < 5; ++i) {
    other[i] = other[2];
    add_scaled(other[i], ratio<Q>(4, 3), difference(c[i], c[2]));
  }
  const Net two_cones{two_pieces, {c, ones}, {other, ones}};
  EXPECT_TRUE(two_cones.developable());
  EXPECT_EQ(two_cones.classified().kind, SurfaceClass::tangent);
}

/// A cone over the origin, then a part of the plane x = 0 through its last ruling. Seen from the origin along the third
/// axis the points of both rows are proportional everywhere; the rulings of the plane do not meet the origin.
TEST(Classify, AConeThatGoesOnAsAPlane) {
  const std::vector<Point3> c{point(5, 1, 2), point(3, 2, -1), point(0, 2, 1), point(0, 3, 4), point(0, 5, 3)};
  std::vector<Point3> d;
  for (const Point3& x : c) d.push_back(scaled(Q(2), x));
  const std::vector<Q> ones(5, Q(1));
  EXPECT_EQ((Net{two_pieces, {c, ones}, {d, ones}}.classified().kind), SurfaceClass::cone);
  d[3] = sum(d[3], point(0, 0, 1));
  d[4] = sum(d[4], point(0, 0, -2));
  const Net changed{two_pieces, {c, ones}, {d, ones}};
  EXPECT_TRUE(changed.developable());
  EXPECT_EQ(changed.classified().kind, SurfaceClass::tangent);
}

/// A piece of a cone and one in a plane through its vertex 0, whose rulings from (1, t, 0) to (2 - t, 2t, 0) leave it
/// behind: t^2 times the plane's normal tells, only the last coefficient of the three.
TEST(Classify, AConeThatGoesOnInAPlaneThroughItsVertexOnly) {
  const KnotList<Q> u(1, {Q(0), Q(1), Q(2)});
  const std::vector<Q> ones(3, Q(1));
  const auto kind = [&](const Point3& c, const Point3& d) {
    const Net folded{u, {{point(1, 1, 1), point(1, 0, 0), c}, ones}, {{point(2, 2, 2), point(2, 0, 0), d}, ones}};
    EXPECT_TRUE(folded.developable());
    return folded.classified().kind;
  };
  EXPECT_EQ(kind(point(1, 1, 0), point(2, 2, 0)), SurfaceClass::cone);
  EXPECT_EQ(kind(point(1, 1, 0), point(1, 2, 0)), SurfaceClass::tangent);
}

TEST(Classify, PointsThatActOnNoPieceDoNotCount) {
  // The domain begins at the double knot 1, so that c_0 and d_0 do not act on it.
  const KnotList<Q> u(2, {Q(0), Q(1), Q(1), Q(2), Q(2)});
  const std::vector<Q> ones(4, Q(1));
  const Net plane{u,
                  {{point(5, 6, 7), point(0, 0, 0), point(1, 5, 0), point(2, 0, 0)}, ones},
                  {{point(9, 9, 1), point(0, 1, 0), point(3, 3, 0), point(4, 1, 0)}, ones}};
  EXPECT_TRUE(plane.developable());
  EXPECT_EQ(plane.classified().kind, SurfaceClass::plane);
}

TEST(Classify, DegenerateNets) {
  const std::vector<Point3> planar{point(0, 0, 0), point(1, 3, 0), point(2, 1, 0), point(7, 2, 0)};
  const Net curve = net(cubic, cubic);
  EXPECT_TRUE(curve.developable());
  EXPECT_EQ(curve.classified().kind, SurfaceClass::cylinder);
  EXPECT_FALSE(curve.classified().direction.has_value());
  EXPECT_EQ(net(planar, planar).classified().kind, SurfaceClass::plane);

  const std::vector<Point3> one(4, point(1, 2, 3));
  EXPECT_EQ(net(one, one).classified().kind, SurfaceClass::plane);
  EXPECT_EQ(net(one, std::vector<Point3>(4, point(0, 2, 3))).classified().kind, SurfaceClass::plane);
  EXPECT_EQ(net({point(0, 0, 0), point(1, 1, 1)}, {point(2, 2, 2), point(5, 5, 5)}).classified().kind,
            SurfaceClass::plane);
}

TEST(Classify, RulingsOnOneLineAndACurveAreACylinderAlongTheLineHoweverTheAxesAreNamed) {
  std::array<int, 3> axis{0, 1, 2};
  do {
    const auto named = [&](int x, int y, int z) {
      Point3 renamed;
      renamed[axis[0]] = Q(x);
      renamed[axis[1]] = Q(y);
      renamed[axis[2]] = Q(z);
      return renamed;
    };
    const std::vector<Point3> curve{named(4, 1, 1), named(2, 1, 0), named(3, 0, 1)};
    const std::vector<Q> ones(5, Q(1));
    const Net joined{two_pieces,
                     {{named(0, 1, 1), named(1, 1, 1), curve[0], curve[1], curve[2]}, ones},
                     {{named(1, 1, 1), named(3, 1, 1), curve[0], curve[1], curve[2]}, ones}};
    EXPECT_TRUE(joined.developable());
    const Classification<Q> found = joined.classified();
    EXPECT_EQ(found.kind, SurfaceClass::cylinder);
    ASSERT_TRUE(found.direction.has_value());
    EXPECT_TRUE(*found.direction == named(1, 0, 0));
  } while (std::next_permutation(axis.begin(), axis.end()));
}

// The last ruling alone misses the vertex of all others; its piece is planar.
TEST(Classify, OneRulingBesideTheVertexIsNoCone) {
  const std::vector<Q> ones(5, Q(1));
  Net surface{two_pieces,
              {{point(1, 0, 0), point(0, 1, 0), point(0, 0, 1), point(0, 1, 1), point(0, 2, 1)}, ones},
              {{point(2, 0, 0), point(0, 2, 0), point(0, 0, 2), point(0, 2, 2), point(0, 4, 2)}, ones}};
  EXPECT_EQ(surface.classified().kind, SurfaceClass::cone);
  surface.d.points[4] = point(0, 5, 2);
  EXPECT_TRUE(surface.developable());
  EXPECT_EQ(surface.classified().kind, SurfaceClass::tangent);
}

/// A cone about (0, 0, 1) that goes on as one about another point; both have the ruling on the line of their vertices.
/// All rows have this weight.
SurfaceClass about_another_vertex(const Point3& other, const Q& weight) {
  const Point3 vertex = point(0, 0, 1);
  const auto on_line = [&](int t) { return Point3(combine(Q(1 - t), vertex, Q(t), other)); };
  const auto seen_from = [](const Point3& centre, const Q& ratio, const Point3& x) {
    return Point3(combine(Q(1) - ratio, centre, ratio, x));
  };
  // The ratio of the common ruling is 2 about the one and 5/2 about the other vertex.
  std::vector<Point3> c{point(1, 2, 0), point(3, 1, 5), on_line(3), point(4, -2, 3), point(-1, 7, 2)};
  std::vector<Point3> d;
  for (std::size_t i = 0; i < c.size(); ++i) {
    d.push_back(i <= 2 ? seen_from(vertex, Q(2), c[i]) : seen_from(other, ratio<Q>(5, 2), c[i]));
  }
  const std::vector<Q> weights(c.size(), weight);
  const Net made{two_pieces, {std::move(c), weights}, {std::move(d), weights}};
  EXPECT_TRUE(made.developable());
  return made.classified().kind;
}

/// The rows of the second piece are proportional seen from points that are easily mistaken for the vertex: its mirror
/// image, the one further along all axes, the one by the weight nearer to the origin.
TEST(Classify, ASecondVertexIsNotTheFirst) {
  EXPECT_EQ(about_another_vertex(point(0, 0, -1), Q(1)), SurfaceClass::tangent);
  EXPECT_EQ(about_another_vertex(point(1, 1, 2), Q(1)), SurfaceClass::tangent);
  EXPECT_EQ(about_another_vertex(Point3(Q(0), Q(0), ratio<Q>(1, 2)), Q(2)), SurfaceClass::tangent);
}

/// A cone about (0, 0, 1) by the ratio 2 that goes on in the plane y = 0, with rows that keep the ratio in z alone.
TEST(Classify, EveryCoordinateOfTheRowsHasTheRatio) {
  const std::vector<Point3> c{point(1, 2, 0), point(3, 1, 5), point(1, 0, 2), point(4, 0, 3), point(5, 0, 7)};
  std::vector<Point3> d;
  for (const Point3& x : c) d.push_back(Point3(Q(2) * x[0], Q(2) * x[1], Q(2) * x[2] - Q(1)));
  d[3][0] += Q(1);
  d[4][0] -= Q(4);
  const std::vector<Q> ones(c.size(), Q(1));
  const Net made{two_pieces, {c, ones}, {d, ones}};
  EXPECT_TRUE(made.developable());
  EXPECT_EQ(made.classified().kind, SurfaceClass::tangent);
}

/// Degree 1, every cell in a plane through the vertex: the rulings pass through it while one ratio lasts, and again
/// behind the cell in which it changes, but not there.
TEST(Classify, ARatioThatChangesAtDegreeOne) {
  const std::vector<Point3> c{point(1, 0, 0),  point(0, 2, 1),  point(-1, 1, 3),
                              point(2, -1, 1), point(3, 3, -2), point(5, 1, 1)};
  const Point3 vertex = point(1, 1, 1);
  const auto kind = [&](const std::vector<int>& ratios) {
    std::vector<Point3> d;
    for (std::size_t i = 0; i < c.size(); ++i) {
      d.push_back(vertex);
      add_scaled(d.back(), Q(ratios[i]), c[i]);
      add_scaled(d.back(), Q(-ratios[i]), vertex);
    }
    const std::vector<Q> ones(c.size(), Q(1));
    const Net made{KnotList<Q>(1, {Q(0), Q(1), Q(2), Q(3), Q(4), Q(5)}), {c, ones}, {d, ones}};
    EXPECT_TRUE(made.developable());
    return made.classified().kind;
  };
  EXPECT_EQ(kind({2, 2, 2, 2, 2, 2}), SurfaceClass::cone);
  for (std::size_t change = 1; change < c.size(); ++change) {
    std::vector<int> ratios(c.size(), 2);
    for (std::size_t i = change; i < ratios.size(); ++i) ratios[i] = 3;
    EXPECT_EQ(kind(ratios), SurfaceClass::tangent) << change;
  }
}

TEST(Classify, EveryClassHasItsWord) {
  EXPECT_EQ(name_of(SurfaceClass::plane), "plane");
  EXPECT_EQ(name_of(SurfaceClass::cylinder), "cylinder");
  EXPECT_EQ(name_of(SurfaceClass::cone), "cone");
  EXPECT_EQ(name_of(SurfaceClass::tangent), "tangent");
  EXPECT_EQ(name_of(SurfaceClass::none), "none");
}

}  // namespace
}  // namespace torse
