// The rates of the development, in doubles from exact polynomials, against vector algebra and the classical formulas.
#include "torse/developable/unroll.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "torse/exact/rational/rational.hpp"
#include "torse/scalar/builtin.hpp"
#include "torse/spline/curve.hpp"
#include "torse/spline/piece_polynomials.hpp"

namespace torse::testing {
namespace {

using Q = Rational;
using Rows = std::vector<Vec<Q, 4>>;
using Point = std::array<double, 3>;

Rows polynomial_rows(const std::vector<std::array<int, 3>>& points, int denominator = 1) {
  Rows rows;
  for (const auto& x : points) {
    rows.push_back({Q(1), ratio<Q>(x[0], denominator), ratio<Q>(x[1], denominator), ratio<Q>(x[2], denominator)});
  }
  return rows;
}

/// r + k r' for the twisted cubic r = (t, t^2, t^3), in cubic Bezier form.
Rows tangent_row(int k) {
  return polynomial_rows(
      {{3 * k, 0, 0}, {3 * k + 1, 2 * k, 0}, {3 * k + 2, 4 * k + 1, 3 * k}, {3 * k + 3, 6 * k + 3, 9 * k + 3}}, 3);
}

Strip<double> values(const StripForms<Q>& forms, const Q& tau) {
  return oriented(forms, tau).terms.transformed([&](const Polynomial<Q>& f) { return f(tau).to_double(); });
}

StripForms<Q> one_piece(const Rows& p, const Rows& q) {
  return strip_forms<Q>(bezier_knots<Q>(static_cast<int>(p.size()) - 1), p, q, 1);
}

/// d = r + (t - 1/2) r' crosses the edge r of the surface, and its speed across the rulings goes through zero.
TEST(StripRates, FactorsArePositiveOnEitherSideOfTheirZeros) {
  const auto polynomial = [](std::initializer_list<Q> list) { return Polynomial<Q>(std::vector<Q>(list)); };
  const PolynomialRow<Q, 4> d{polynomial({Q(1)}), polynomial({ratio<Q>(-1, 2), Q(2)}), polynomial({Q(0), Q(-1), Q(3)}),
                              polynomial({Q(0), Q(0), ratio<Q>(-3, 2), Q(4)})};
  const Rows crossing = bezier_rows(d, 3, Q(0), Q(1));
  for (const bool swapped : {false, true}) {
    const StripForms<Q> forms = swapped ? one_piece(crossing, tangent_row(2)) : one_piece(tangent_row(2), crossing);
    for (const Q& tau : {ratio<Q>(1, 4), ratio<Q>(3, 4)}) {
      const Strip<double> at = values(forms, tau);
      for (const double x : {at.speed_c, at.speed_d, at.across_c, at.across_d}) EXPECT_GT(x, 0) << tau.text();
    }
  }
}

/// The edge of regression of a tangent surface keeps its curvature in the plane, so the rulings turn by the curvature
/// times the speed of the edge, |r' x r''| / |r'|^2.
TEST(StripRates, TangentSurfaceTurnsWithTheCurvatureOfItsEdge) {
  const StripForms<Q> forms = one_piece(tangent_row(1), tangent_row(2));
  for (int i = 0; i <= 8; ++i) {
    const double t = i / 8.0;
    const StripRates<double> rates = strip_rates(values(forms, ratio<Q>(i, 8)));
    const double speed2 = 1 + 4 * t * t + 9 * t * t * t * t;
    const double turned = std::sqrt(36 * t * t * t * t + 36 * t * t + 4);
    EXPECT_NEAR(rates.turn, turned / speed2, 1e-13);
    // x = k r'' x e across the ruling e = r'/|r'|, and C' = r' + k r''.
    EXPECT_NEAR(rates.across_c, turned / std::sqrt(speed2), 1e-12);
    EXPECT_NEAR(rates.across_d, 2 * turned / std::sqrt(speed2), 1e-12);
    const double dot = 4 * t + 18 * t * t * t;
    EXPECT_NEAR(rates.along, std::sqrt(speed2) + dot / std::sqrt(speed2), 1e-12);
    EXPECT_NEAR(ruling_length(values(forms, ratio<Q>(i, 8))), std::sqrt(speed2), 1e-13);
  }
}

/// Numbers without any special position, weights included: everything from points and differences of them.
TEST(StripRates, AgreeWithVectorAlgebra) {
  const Rows p{{Q(1), Q(0), Q(0), Q(0)}, {Q(2), Q(3), Q(1), Q(1)}, {Q(1), Q(2), Q(3), Q(1)}};
  const Rows q{{Q(3), Q(1), Q(2), Q(9)}, {Q(1), Q(2), Q(2), Q(3)}, {Q(2), Q(5), Q(8), Q(7)}};
  const StripForms<Q> forms = one_piece(p, q);
  const auto point = [](const Rows& row, double t) {
    std::array<double, 4> x{};
    const std::array<double, 3> basis{(1 - t) * (1 - t), 2 * t * (1 - t), t * t};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 4; ++j) x[j] += basis[i] * row[i][static_cast<int>(j)].to_double();
    }
    return Point{x[1] / x[0], x[2] / x[0], x[3] / x[0]};
  };
  const auto minus = [](const Point& a, const Point& b) { return Point{a[0] - b[0], a[1] - b[1], a[2] - b[2]}; };
  const auto dot = [](const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  const auto across = [&](const Point& a, const Point& e) { return std::sqrt(dot(a, a) - dot(a, e) * dot(a, e)); };
  for (int i = 1; i < 8; ++i) {
    const double t = i / 8.0;
    const double h = 1e-5;
    const auto slope = [&](const Rows& row) {
      Point d = minus(point(row, t + h), point(row, t - h));
      for (double& x : d) x /= 2 * h;
      return d;
    };
    Point e = minus(point(q, t), point(p, t));
    const double length = std::sqrt(dot(e, e));
    for (double& x : e) x /= length;
    const Point c = slope(p);
    const Point d = slope(q);
    const Strip<double> f = values(forms, ratio<Q>(i, 8));
    const StripRates<double> rates = strip_rates(f);
    EXPECT_NEAR(ruling_length(f), length, 1e-9);
    EXPECT_NEAR(rates.speed_c, std::sqrt(dot(c, c)), 1e-6);
    EXPECT_NEAR(rates.speed_d, std::sqrt(dot(d, d)), 1e-6);
    EXPECT_NEAR(rates.along, dot(c, e), 1e-6);
    EXPECT_NEAR(rates.across_c, across(c, e), 1e-6);
    EXPECT_NEAR(rates.across_d, across(d, e), 1e-6);
    EXPECT_NEAR(rates.turn, (across(d, e) - across(c, e)) / length, 1e-6);
    EXPECT_NEAR(planar_density(f), length * (across(c, e) + across(d, e)) / 2, 1e-5);
  }
}

/// Both rails stand still at t = 0 as fast as t does, and the ruling has length zero there: the rates have limits.
TEST(StripRates, CommonZerosAreTakenOut) {
  // The plane triangle with its tip at the origin, between y = 0 and y = x, with x = t^2.
  const Rows p = polynomial_rows({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}});
  const Rows q = polynomial_rows({{0, 0, 0}, {0, 0, 0}, {1, 1, 0}});
  const StripForms<Q> forms = one_piece(p, q);
  EXPECT_EQ(forms.terms.gap, Polynomial<Q>(std::vector<Q>{Q(0), Q(0), Q(1)}));
  const StripRates<double> rates = strip_rates(
      oriented(forms, ratio<Q>(1, 2)).terms.transformed([&](const Polynomial<Q>& f) { return f(Q(0)).to_double(); }));
  EXPECT_EQ(rates.turn, 0);
  EXPECT_EQ(rates.speed_c, 0);
}

/// Seen from the normal C' x (D - C): the same for a surface with its rails exchanged and its direction turned round.
TEST(StripForms, OrientedAlongTheNormal) {
  const Rows p = polynomial_rows({{0, 0, 0}, {5, 0, 1}, {9, 0, 0}});
  const Rows q = polynomial_rows({{0, 4, 0}, {5, 4, 1}, {9, 4, 0}});
  const auto upward = [](const Rows& a, const Rows& b) {
    return oriented(one_piece(a, b), ratio<Q>(1, 2)).normal[2](ratio<Q>(1, 2)).sign();
  };
  EXPECT_EQ(upward(p, q), 1);
  EXPECT_EQ(upward(q, p), -1);
  EXPECT_EQ(upward(Rows(q.rbegin(), q.rend()), Rows(p.rbegin(), p.rend())), 1);
  Rows negative = q;
  for (auto& row : negative) scale(row, Q(-2));
  EXPECT_EQ(upward(p, negative), 1);
}

/// A point that moves along a rational segment, and its velocity.
std::array<Point, 2> moving(const Rows& rows, double t) {
  std::array<double, 4> at{}, by{};
  for (std::size_t j = 0; j < 4; ++j) {
    const double from = rows[0][static_cast<int>(j)].to_double(), to = rows[1][static_cast<int>(j)].to_double();
    at[j] = from + t * (to - from);
    by[j] = to - from;
  }
  std::array<Point, 2> result;
  for (std::size_t j = 0; j < 3; ++j) {
    result[0][j] = at[j + 1] / at[0];
    result[1][j] = (by[j + 1] - result[0][j] * by[0]) / at[0];
  }
  return result;
}

/// On a warped rational strip: that of the middle of the ruling, (C' + D') x (D - C).
TEST(StripForms, TheNormalIsThatOfTheMiddleOfTheRuling) {
  const Rows p{{Q(1), Q(0), Q(0), Q(0)}, {Q(2), Q(6), Q(1), Q(0)}};
  const Rows q{{Q(3), Q(1), Q(9), Q(2)}, {Q(1), Q(4), Q(3), Q(5)}};
  const StripForms<Q> forms = one_piece(p, q);
  for (int i = 0; i <= 4; ++i) {
    const auto [c, c_speed] = moving(p, i / 4.0);
    const auto [d, d_speed] = moving(q, i / 4.0);
    Point across, speed, normal;
    for (std::size_t j = 0; j < 3; ++j) {
      across[j] = d[j] - c[j];
      speed[j] = c_speed[j] + d_speed[j];
      normal[j] = forms.normal[j](ratio<Q>(i, 4)).to_double();
    }
    const double size = std::hypot(normal[0], normal[1], normal[2]);
    EXPECT_GT(size, 1);
    for (const Point& tangent : {across, speed}) {
      EXPECT_NEAR((normal[0] * tangent[0] + normal[1] * tangent[1] + normal[2] * tangent[2]) / size, 0, 1e-13);
    }
  }
}

TEST(StripForms, WhereThereIsNoSurface) {
  const Rows p = polynomial_rows({{0, 0, 0}, {1, 0, 0}});
  const Rows q = polynomial_rows({{2, 0, 0}, {5, 0, 0}});
  EXPECT_TRUE(one_piece(p, p).terms.gap.zero());
  EXPECT_TRUE(one_piece(p, q).terms.across.zero());
}

}  // namespace
}  // namespace torse::testing
