// Rails against exact arithmetic: numerators and weights by basis functions of Cox and de Boor, quotients by division
// of power series, and what is known of a circle.
#include "torse/quasi/rail.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>

#include "../spline/splines.hpp"
#include "rails.hpp"

namespace torse::quasi {
namespace {

using test::ExactCurve;
using test::Q;

/// c, c', c'', c''' of the curve over [0, 1] at t of the proper piece k.
std::array<Vec<Q, 3>, 4> exact_jet(const ExactCurve& curve, int k, const Q& t) {
  const KnotList<Q>& u = curve.knots;
  const Q length = u.domain_end() - u.domain_begin();
  const Q piece = u.piece_end(k) - u.piece_begin(k);
  const Q s = (u.domain_begin() + t * length - u.piece_begin(k)) / piece;
  auto forms = piece_forms<Q, 4>(basis_forms(u, k), curve.control, k);
  std::array<std::array<Q, 4>, 4> series;  // by coordinate: r^(i) / i!
  for (std::size_t j = 0; j < 4; ++j) {
    Q factor(1);
    for (std::size_t i = 0; i < 4; ++i) {
      series[j][i] = factor * forms[j](Q(1) - s, s);
      factor *= length / piece / Q(static_cast<int>(i) + 1);
      const bool constant = forms[j].degree() == 0;
      forms[j] = constant ? BinaryForm<Q>(0) : forms[j].derivative_t() - forms[j].derivative_s();
    }
  }
  std::array<Vec<Q, 3>, 4> jet;
  const std::array<Q, 4> factorial{Q(1), Q(1), Q(2), Q(6)};
  for (std::size_t j = 1; j < 4; ++j) {
    std::array<Q, 4> quotient;
    for (std::size_t i = 0; i < 4; ++i) {
      Q rest = series[j][i];
      for (std::size_t l = 1; l <= i; ++l) rest -= series[0][l] * quotient[i - l];
      quotient[i] = rest / series[0][0];
      jet[i][static_cast<int>(j) - 1] = factorial[i] * quotient[i];
    }
  }
  return jet;
}

/// Values agree up to rounding errors: each of the 4 n operations of de Casteljau's algorithm errs by at most u times
/// the size of its operands. Those of the k-th derivative are below (2 n / piece)^k times those of the curve, within a
/// factor of 16 for quotients by weights in [1/2, 3/2].
void expect_jet(const RailJet& found, const std::array<Vec<Q, 3>, 4>& exact, int degree, double piece, double reach) {
  double bound = 16 * 4 * degree * std::numeric_limits<double>::epsilon() * reach;
  const std::array<Vector, 4> values{found.point, found.first, found.second, found.third};
  for (std::size_t i = 0; i < 4; ++i) {
    for (int j = 0; j < 3; ++j) {
      EXPECT_NEAR(values[i][j], exact[i][j].to_double(), bound) << "derivative " << i << ", coordinate " << j;
    }
    bound *= 4 * 2 * degree / piece;
  }
}

void expect_jets(const ExactCurve& curve) {
  const Rail rail = test::in_doubles(curve);
  const KnotList<Q>& u = curve.knots;
  const Q length = u.domain_end() - u.domain_begin();
  for (const int k : u.proper_pieces()) {
    const Q begin = (u.piece_begin(k) - u.domain_begin()) / length;
    const Q piece = (u.piece_end(k) - u.piece_begin(k)) / length;
    for (int i = 0; i < 8; ++i) {
      const Q t = begin + ratio<Q>(i, 8) * piece;
      expect_jet(rail(t.to_double()), exact_jet(curve, k, t), u.degree(), piece.to_double(), 1);
    }
  }
  const int last = u.proper_pieces().back();
  expect_jet(rail(1), exact_jet(curve, last, Q(1)), u.degree(),
             ((u.piece_end(last) - u.piece_begin(last)) / length).to_double(), 1);
}

TEST(Rail, BezierCurvesOfEachDegree) {
  for (int degree = 1; degree <= 20; ++degree) {
    for (const bool rational : {false, true}) {
      SCOPED_TRACE(degree);
      expect_jets(test::drawn_curve(bezier_knots<Q>(degree), rational, static_cast<std::uint64_t>(degree)));
    }
  }
}

TEST(Rail, PiecesAndDomains) {
  for (const auto& u : {test::knots(2, {0, 0, 1, 3, 4, 8, 8}), test::knots(3, {-5, -4, -3, -2, 1, 1, 5, 5, 5}),
                        test::knots(3, {-16, -16, -16, 0, 0, 0, 16, 16, 16}), test::knots(1, {2, 3, 6}),
                        test::knots(5, {0, 0, 0, 0, 0, 4, 4, 8, 8, 8, 8, 8})}) {
    for (const bool rational : {false, true}) expect_jets(test::drawn_curve(u, rational, 7));
  }
}

TEST(Rail, NegativeWeightsAreTheSameCurve) {
  const KnotList<Q> u = test::knots(3, {0, 0, 0, 1, 2, 2, 2});
  expect_jets(test::drawn_curve(u, true, 11, -1));
  const Rail plus = test::in_doubles(test::drawn_curve(u, true, 11, 1));
  const Rail minus = test::in_doubles(test::drawn_curve(u, true, 11, -1));
  EXPECT_EQ(plus(0.625).point, minus(0.625).point);
  EXPECT_EQ(plus(0.625).third, minus(0.625).third);
}

TEST(Rail, EqualWeightsAreNone) {
  const ExactCurve curve = test::drawn_curve(test::knots(3, {0, 0, 0, 1, 2, 2, 2}), false, 12);
  std::vector<Vec<Q, 4>> rows = curve.control;
  for (Vec<Q, 4>& row : rows) scale(row, Q(-4));
  expect_jets(ExactCurve(curve.knots, rows));
}

TEST(Rail, BreaksAreThoseOfTheProperPiecesOverTheUnitInterval) {
  const Rail rail = test::in_doubles(test::drawn_curve(test::knots(2, {-4, -4, -2, -2, 3, 4, 4}), false, 1));
  EXPECT_EQ(std::vector<double>(rail.breaks().begin(), rail.breaks().end()), (std::vector<double>{0, 0.25, 0.875, 1}));
  EXPECT_EQ(rail.degree(), 2);
}

TEST(Rail, PolynomialsGoOnBeyondTheEnds) {
  for (const bool rational : {false, true}) {
    const ExactCurve curve = test::drawn_curve(test::knots(3, {0, 0, 0, 2, 4, 4, 4}), rational, 3);
    const Rail rail = test::in_doubles(curve);
    // The weights stay above 1/4 there.
    expect_jet(rail(-1.0 / 16), exact_jet(curve, 1, ratio<Q>(-1, 16)), 3, 0.5, 100);
    expect_jet(rail(17.0 / 16), exact_jet(curve, 2, ratio<Q>(17, 16)), 3, 0.5, 100);
  }
}

Rail conic(const std::vector<Vec<double, 4>>& rows, std::vector<double> knots) {
  return Rail(Spline<double, Vec<double, 4>>(KnotList<double>(2, std::move(knots)), rows));
}

/// |c|^2 = 1 and its three derivatives; (c x c')_3 has one sign.
void expect_unit_circle(const Rail& rail, double sign) {
  for (int i = 0; i <= 64; ++i) {
    const RailJet jet = rail(i / 64.0);
    EXPECT_NEAR(jet.point.squaredNorm(), 1, 1e-14);
    EXPECT_NEAR(jet.point.dot(jet.first), 0, 1e-12);
    EXPECT_NEAR(jet.first.squaredNorm() + jet.point.dot(jet.second), 0, 1e-10);
    EXPECT_NEAR(3 * jet.first.dot(jet.second) + jet.point.dot(jet.third), 0, 1e-8);
    EXPECT_GT(sign * jet.point.cross(jet.first)[2], 1);
  }
}

TEST(Rail, TheUnitCircle) {
  const double h = std::numbers::sqrt2 / 2;
  expect_unit_circle(conic({{1, 1, 0, 0},
                            {h, h, h, 0},
                            {1, 0, 1, 0},
                            {h, -h, h, 0},
                            {1, -1, 0, 0},
                            {h, -h, -h, 0},
                            {1, 0, -1, 0},
                            {h, h, -h, 0},
                            {1, 1, 0, 0}},
                           {0, 0, 1, 1, 2, 2, 3, 3, 4, 4}),
                     1);
  // A negative weight in the middle: the other three quarters, the other way round.
  expect_unit_circle(conic({{1, 1, 0, 0}, {-h, -h, -h, 0}, {1, 0, 1, 0}}, {0, 0, 1, 1}), -1);
}

TEST(Rail, NumbersThatAreNotFinite) {
  for (const double bad : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    for (int place = 0; place < 4; ++place) {
      std::vector<Vec<double, 4>> rows(3, Vec<double, 4>(1, 2, 3, 4));
      rows[1][place] = bad;
      try {
        const Rail rail = conic(rows, {0, 0, 1, 1});
        ADD_FAILURE() << rail.degree();
      } catch (const InvalidInput& error) {
        EXPECT_EQ(error.place(), "points");
      }
    }
  }
}

}  // namespace
}  // namespace torse::quasi
