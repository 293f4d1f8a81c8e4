// The method of BZZ19: its energies in rational numbers, its objective against smallest eigenvalues, and what the
// literal formula does at the ends.
#include "torse/quasi/paper_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "../spline/splines.hpp"
#include "rails.hpp"
#include "torse/quasi/condition.hpp"
#include "torse/quasi/fit.hpp"

namespace torse::quasi {
namespace {

using test::hundredths;
using test::Q;
using Point = Vec<Q, 3>;

Point point(int x, int y, int z) { return {Q(x), Q(y), Q(z)}; }

TEST(Energy, ValuesByHand) {
  // Rulings from (0, 0, 0) with the tangent (1, 0, 0) to (0, 0, 2) with (0, 3, 0).
  const Point c = point(0, 0, 0), c1 = point(1, 0, 0), d = point(0, 0, 2), d1 = point(0, 3, 0);
  EXPECT_EQ(ruling_determinant<Q>(difference(c, d), c1, d1), Q(-6));
  EXPECT_EQ(ruling_determinant<Q>(difference(c, d), c1, point(5, 0, 7)), Q(0));
  const NormalProducts<Q> energy = normal_products<Q>(point(1, 2, 3), difference(c, d), c1, d1);
  EXPECT_EQ(energy.with_a, Q(1));
  EXPECT_EQ(energy.with_b, Q(6));
  EXPECT_EQ(energy.with_w, Q(-6));
  EXPECT_EQ(normal_residual<Q>(energy), Q(73));
  EXPECT_EQ(unit_penalty<Q>(point(1, 2, 3)), Q(169));
  EXPECT_EQ(unit_penalty<Q>(point(0, -1, 0)), Q(0));
}

/// A normal of two of the three vectors leaves one product, E1 or -E1: E2 = E1^2, so both vanish together.
TEST(Energy, OfNormalsIsTheSquareOfTheDeterminant) {
  std::mt19937_64 rng(1);
  const auto draw = [&] {
    const Q x = test::sixteenths(rng), y = test::sixteenths(rng);
    return Point(x, y, test::sixteenths(rng));
  };
  for (int trial = 0; trial < 30; ++trial) {
    const Point c = draw(), c1 = draw(), d = draw(), d1 = draw();
    const Point ruling = difference(c, d);
    const Q determinant = ruling_determinant<Q>(difference(c, d), c1, d1);
    for (const Point& normal : {cross(c1, d1), cross(ruling, c1), cross(d1, ruling)}) {
      EXPECT_EQ(normal_residual<Q>(normal, difference(c, d), c1, d1), determinant * determinant);
    }
  }
}

/// Random rails, one above the other by 2.
Rails drawn_rails(std::uint64_t seed) {
  test::ExactCurve d = test::drawn_curve(test::knots(3, {0, 0, 0, 1, 2, 2, 2}), seed % 2 == 1, 2 * seed + 1);
  for (Vec<Q, 4>& row : d.control) row[3] += Q(2) * row[0];
  return {test::in_doubles(test::drawn_curve(bezier_knots<Q>(4), false, 2 * seed)), test::in_doubles(d)};
}

/// E2 with the best unit normal: the smallest eigenvalue of the matrix of the rows c', d', c - d.
double least_energy(const RailJet& c, const RailJet& d) {
  Eigen::Matrix3d rows;
  rows << c.first.transpose(), d.first.transpose(), (c.point - d.point).transpose();
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(rows.transpose() * rows).eigenvalues()[0];
}

/// Of a mapping with the best normals of any length: E l s + W (s - 1)^2 is least for s = |N|^2 = 1 - E l / (2 W), or
/// 0.
double best_objective(const Rails& rails, const Mapping<double>& sigma, const PaperOptions& options, bool unit) {
  double total = 0;
  const double last = static_cast<double>(options.samples - 1);
  for (std::size_t r = 0; r < options.samples; ++r) {
    const double t = static_cast<double>(r) / last;
    const double l = least_energy(rails.c(t), rails.d(mapping_value(sigma, t)));
    const double s = unit ? 1 : std::max(0.0, 1 - options.energy_weight * l / (2 * options.normal_weight));
    total += options.energy_weight * l * s + options.normal_weight * (s - 1) * (s - 1);
  }
  if (options.ends == Ends::fixed) {
    for (const double t : {0.0, 1.0}) {
      total += options.end_weight * (rails.d(mapping_value(sigma, t)).point - rails.d(t).point).squaredNorm();
    }
  }
  return total;
}

const KnotList<double> ten_pieces = mapping_knots(2, {0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1});

TEST(PaperFit, BeginsAtTheSameParameterWithTheBestNormals) {
  for (const Ends ends : {Ends::fixed, Ends::free}) {
    PaperOptions options;
    options.ends = ends;
    const Rails rails = drawn_rails(1);
    const double start = best_objective(rails, identity_mapping(ten_pieces), options, true);
    EXPECT_NEAR(paper_fit(rails, ten_pieces, options).curve.front().objective, start, 1e-9 * start);
  }
}

TEST(PaperFit, EndsWithTheBestNormalsAndNotAboveTheStart) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    for (const Ends ends : {Ends::fixed, Ends::free}) {
      PaperOptions options;
      options.ends = ends;
      options.samples = 20;
      options.most_steps = 300;
      options.normal_weight = static_cast<double>(seed);
      const Rails rails = drawn_rails(seed);
      const PaperFit fit = paper_fit(rails, ten_pieces, options);
      const double best = best_objective(rails, mapping_of(ten_pieces, fit.beta), options, false);
      EXPECT_GE(fit.objective, best * (1 - 1e-9));
      if (fit.converged) {
        EXPECT_LE(fit.objective, best * (1 + 1e-3));
      }
      EXPECT_LE(fit.objective, fit.curve.front().objective);
      for (std::size_t i = 1; i < fit.curve.size(); ++i) {
        EXPECT_LT(fit.curve[i].objective, fit.curve[i - 1].objective);
      }
      EXPECT_EQ(fit.objective, fit.curve.back().objective);
      EXPECT_FALSE(fit.stop.empty());
      EXPECT_EQ(fit.gradient_error, 0) << "nobody has asked";
      EXPECT_TRUE(std::ranges::is_sorted(fit.beta));
    }
  }
}

/// At T = t one of 21 samples is at the knot 1/2 of the second rail.
TEST(PaperFit, ItsGradientIsTheDerivativeForRationalRailsToo) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    PaperOptions options;
    options.samples = 21;
    options.most_steps = 1;
    options.check_gradient = true;
    options.ends = seed < 3 ? Ends::fixed : Ends::free;
    options.normal_weight = static_cast<double>(seed);
    const double smooth = paper_fit(drawn_rails(seed), mapping_knots(3, {0, 0.5, 1}), options).gradient_error;
    EXPECT_GT(smooth, 0);
    EXPECT_LT(smooth, 1e-7);
  }
}

/// Rails on a cylinder with the mapping T = a t: c(t) = d(a t) + (1 + t) (0, 0, 1), d(T) = (T, T^2, 0).
Rails cylinder_rails(int percent) {
  const test::Polynomials d{hundredths({0, 100}), hundredths({0, 0, 100}), hundredths({0})};
  const test::Polynomials e{hundredths({0}), hundredths({0}), hundredths({100, 100})};
  return {test::rail_of(test::plus(test::compose(d, hundredths({0, percent})), e)), test::rail_of(d)};
}

TEST(PaperFit, TheLiteralFormulaLeavesTheEndAnywhere) {
  for (const int percent : {80, 120}) {
    PaperOptions options;
    options.ends = Ends::free;
    const PaperFit fit = paper_fit(cylinder_rails(percent), mapping_knots(2, {0, 1}), options);
    EXPECT_NEAR(fit.beta.back(), percent / 100.0, 2e-3);
    options.ends = Ends::fixed;
    EXPECT_NEAR(paper_fit(cylinder_rails(percent), mapping_knots(2, {0, 1}), options).beta.back(), 1, 2e-2);
  }
}

/// c(t) = d(1/4 + t / 2) + ...: sigma(0) = 1/4 is right, but the objective is even in eps_0, which is 0 at the start.
TEST(PaperFit, TheLiteralFormulaNeverLeavesTheBegin) {
  const test::Polynomials d{hundredths({0, 100}), hundredths({0, 0, 100}), hundredths({0})};
  const test::Polynomials e{hundredths({0}), hundredths({0}), hundredths({100, 100})};
  const Rails rails{test::rail_of(test::plus(test::compose(d, hundredths({25, 50})), e)), test::rail_of(d)};
  PaperOptions options;
  options.ends = Ends::free;
  EXPECT_EQ(paper_fit(rails, mapping_knots(2, {0, 1}), options).beta.front(), 0);
  FitOptions free;
  free.ends = Ends::free;
  free.coefficients = 3;
  EXPECT_NEAR(coefficients(fit_rails(rails, free).mapping).front(), 0.25, 1e-6);
}

TEST(DiscreteFit, HasOneRulingForEachSample) {
  PaperOptions options;
  options.samples = 30;
  const Rails rails = drawn_rails(2);
  const PaperFit fit = discrete_fit(rails, options);
  ASSERT_EQ(fit.beta.size(), 30U);
  EXPECT_TRUE(std::ranges::is_sorted(fit.beta));
  std::vector<double> places;
  for (int i = 0; i < 30; ++i) places.push_back(i / 29.0);
  const KnotList<double> u(1, places);
  EXPECT_NEAR(fit.curve.front().objective, best_objective(rails, identity_mapping(u), options, true),
              1e-9 * fit.curve.front().objective);
  EXPECT_LT(fit.objective, fit.curve.front().objective);
  EXPECT_GE(fit.objective, best_objective(rails, mapping_of(u, fit.beta), options, false) * (1 - 1e-9));
}

TEST(DiscreteFit, FindsTheRulingsOfACylinder) {
  PaperOptions options;
  options.samples = 20;
  options.ends = Ends::free;
  const PaperFit fit = discrete_fit(cylinder_rails(80), options);
  for (std::size_t i = 0; i < 20; ++i) EXPECT_NEAR(fit.beta[i], 0.8 * static_cast<double>(i) / 19, 5e-3);
}

/// Rails whose squares no double holds: nothing is found, and T = t is what was met.
TEST(PaperFit, WithoutAFiniteObjectiveTheStartIsLeft) {
  const auto line = [](double x, double y, double z) {
    const std::vector<Vec<double, 4>> rows{{1, 0, y, z}, {1, x, 0, z}};
    return Rail(Spline<double, Vec<double, 4>>(bezier_knots<double>(1), rows));
  };
  const PaperFit fit = paper_fit({line(1e200, 0, 0), line(1e200, 1e200, 1e200)}, mapping_knots(1, {0, 1}));
  EXPECT_FALSE(fit.converged);
  EXPECT_EQ(fit.beta, (std::vector<double>{0, 1}));
  EXPECT_EQ(fit.stop.substr(0, 24), "the line search failed: ");
  EXPECT_GT(fit.stop.size(), 24U);
  EXPECT_TRUE(fit.curve.empty());
  EXPECT_FALSE(std::isfinite(fit.objective));
}

TEST(PaperFit, TooFewSamples) {
  PaperOptions options;
  options.samples = 1;
  try {
    discrete_fit(cylinder_rails(100), options);
    ADD_FAILURE();
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.place(), "samples");
  }
  EXPECT_THROW(paper_fit(cylinder_rails(100), mapping_knots(1, {0, 1}), options), InvalidInput);
  options.samples = 2;
  EXPECT_EQ(discrete_fit(cylinder_rails(100), options).beta.size(), 2U);
}

}  // namespace
}  // namespace torse::quasi
