// The forms of the warp angle of a rational surface against derivatives and differences of its points.
#include "torse/developable/warp.hpp"

#include <gtest/gtest.h>

#include "rational_rows.hpp"

namespace torse {
namespace {

using namespace test;
using Point3 = Vec<Q, 3>;
using Rows = std::vector<Row>;

Point3 at_parameter(const FormVector<Q>& f, const Q& t) {
  const Q s = Q(1) - t;
  return {f[0](s, t), f[1](s, t), f[2](s, t)};
}

Point3 affine(const Row& x) { return {x[1] / x[0], x[2] / x[0], x[3] / x[0]}; }

/// The derivative of the point of a row, by the rule for quotients.
Point3 velocity(const Row& x, const Row& dx) {
  Point3 v;
  for (int j = 0; j < 3; ++j) v[j] = (dx[j + 1] * x[0] - x[j + 1] * dx[0]) / (x[0] * x[0]);
  return v;
}

/// Whether y is a multiple of x, which is not zero.
bool along(const Point3& x, const Point3& y) {
  return dot(x, x).sign() > 0 && dot(y, y).sign() > 0 && dot(cross(x, y), cross(x, y)).sign() == 0;
}

/// Two rows with different weights at every parameter.
const Rows first{row(1, 0, 0, 1), row(2, 3, 1, 0), row(1, 4, -1, 2), row(3, 1, 5, 1)};
const Rows second{row(3, 1, 2, 9), row(1, 3, 4, 5), row(2, 1, 1, 7), row(1, 2, 6, 4)};

TEST(RulingForms, OfRationalRowsAreAlongSpeedsAndRulings) {
  const RulingForms<Q> f = ruling_forms<Q>(bezier_knots<Q>(3), first, second, 1);
  for (int i = 0; i <= 4; ++i) {
    const Q t = q(i, 4);
    const Row p = value(first, t), x = value(second, t);
    EXPECT_TRUE(along(at_parameter(f.a, t), velocity(p, derivative(first, t))));
    EXPECT_TRUE(along(at_parameter(f.b, t), velocity(x, derivative(second, t))));
    EXPECT_TRUE(along(at_parameter(f.w, t), difference(affine(x), affine(p))));
  }
}

/// sin^2 of the angle between the normals, by both quotients.
TEST(SineForms, OfRationalRowsAreThoseOfTheirNormals) {
  const RulingForms<Q> f = ruling_forms<Q>(bezier_knots<Q>(3), first, second, 1);
  const SineForms<Q> direct = sine_forms(f);
  const auto normals = normal_forms(f);
  const SineForms<Q> by_normals = sine_forms(normals[0], normals[1]);
  for (int i = 0; i <= 4; ++i) {
    const Q t = q(i, 4), s = Q(1) - t;
    const Row p = value(first, t), x = value(second, t);
    const Point3 ruling = difference(affine(x), affine(p));
    const Point3 m = cross(velocity(p, derivative(first, t)), ruling);
    const Point3 n = cross(velocity(x, derivative(second, t)), ruling);
    const Point3 across = cross(m, n);
    const Q sine2 = dot(across, across) / (dot(m, m) * dot(n, n));
    EXPECT_EQ(direct.numerator(s, t) / direct.denominator(s, t), sine2);
    EXPECT_EQ(by_normals.numerator(s, t) / by_normals.denominator(s, t), sine2);
  }
}

}  // namespace
}  // namespace torse
