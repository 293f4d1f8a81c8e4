// Cylinders, cones, the tangent net and the restriction along rulings.
#include "torse/developable/special.hpp"

#include <gtest/gtest.h>

#include "nets.hpp"
#include "torse/developable/linear_net.hpp"

namespace torse::test {
namespace {

TEST(CylinderNet, RulingsAndErrors) {
  const KnotList<Q> u = knots(2, {0, 1, 1, 2, 3});
  const std::vector<Point3> c = points(4);
  const std::vector<Q> lengths{Q(1), Q(0), Q(-4), Q(3)};
  const std::vector<Point3> d = cylinder_net<Q, Point3>(c, point(2, -6, 4), lengths);
  EXPECT_EQ(difference(d[2], c[2]), point(-8, 24, -16));
  EXPECT_TRUE(developable(u, c, d));
  EXPECT_EQ(place_of([&] { return cylinder_net<Q, Point3>(c, c[0], std::span(lengths).first(3)); }), "lengths");
}

// Rulings that vanish may turn: w' is parallel to w everywhere, the surface is developable, and yet no cylinder.
TEST(CylinderNet, ParallelDerivativesDoNotMakeACylinder) {
  const KnotList<Q> u = knots(2, {-1, -1, 0, 1, 1});
  const std::vector<Point3> c = points(4);
  std::vector<Point3> d = c;  // w = max(-t,0)^2 e_x + max(t,0)^2 e_y
  d[0][0] += Q(1);
  d[3][1] += Q(1);
  for (int k : {1, 2}) {
    const Q t = Q(2 * k - 3) / Q(2);
    const Point3 w = difference(curve_point<Q, Point3>(u, d, k, t), curve_point<Q, Point3>(u, c, k, t));
    const Point3 dw = difference(curve_derivative<Q, Point3>(u, d, k, t), curve_derivative<Q, Point3>(u, c, k, t));
    EXPECT_EQ(w, (k == 1 ? Point3(Q(1) / Q(4), Q(0), Q(0)) : Point3(Q(0), Q(1) / Q(4), Q(0))));
    EXPECT_EQ(cross(w, dw), point(0, 0, 0));
  }
  EXPECT_TRUE(developable(u, c, d));
}

TEST(ConeNet, VertexAndErrors) {
  const KnotList<Q> u = knots(2, {0, 1, 1, 2, 3});
  const Point3 vertex = point(1, 2, 3);
  const std::vector<Point3> c = points(4);
  const Point3 d0 = combine(Q(-3), vertex, Q(4), c[0]);  // a + 4 (c_0 - a)
  const std::vector<Point3> d = cone_net<Q, Point3>(c, Q(4), d0);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(d[i], combine(Q(-3), vertex, Q(4), c[i]));
  EXPECT_EQ((cone_vertex<Q, Point3>(c[0], d0, Q(4))), vertex);
  EXPECT_TRUE(developable(u, c, d));
  EXPECT_EQ(place_of([&] { return cone_vertex<Q, Point3>(c[0], d0, Q(1)); }), "alpha");
}

TEST(TangentNet, ByHand) {
  // c = (t, t^2, t^3), c + c' = (t+1, t^2+2t, t^3+3t^2)
  const Q third = Q(1) / Q(3);
  const std::vector<Point3> c{point(0, 0, 0), Point3(third, Q(0), Q(0)), Point3(Q(2) * third, third, Q(0)),
                              point(1, 1, 1)};
  const std::vector<Point3> d = tangent_net<Q, Point3>(c);
  EXPECT_EQ(d[0], point(1, 0, 0));
  EXPECT_EQ(d[1], Point3(Q(4) * third, Q(2) * third, Q(0)));
  EXPECT_EQ(d[2], Point3(Q(5) * third, Q(5) * third, Q(1)));
  EXPECT_EQ(d[3], point(2, 3, 4));
  EXPECT_TRUE(developable(bezier_knots<Q>(3), c, d));
}

TEST(RestrictRulings, KeepsM) {
  for (const KnotList<Q>& u : knot_lists()) {
    const std::vector<Point3> c = points(u.last() + 1);
    const Q lambda = Q(11) / Q(4);
    const std::vector<Point3> d = linear_net<Q, Point3>(u, c, lambda, Q(-1), point(3, 5, -7));
    for (const Q& beta : {Q(0), Q(1) / Q(3), Q(1), Q(-5)}) {
      const std::vector<Point3> part = restrict_rulings<Q, Point3>(c, d, beta);
      EXPECT_EQ(part, (linear_net<Q, Point3>(u, c, restricted_lambda(lambda, Q(-1), beta), Q(-1), part[0])));
    }
  }
  EXPECT_EQ(restricted_lambda(Q(5), Q(2), Q(3)), Q(11));
}

}  // namespace
}  // namespace torse::test
