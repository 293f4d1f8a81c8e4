// Fits of rails whose best mapping is known, and of rails that have none.
#include "torse/quasi/fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "torse/quasi/paper_fit.hpp"

namespace torse::quasi {
namespace {

using Row = Vec<double, 4>;

Rail bezier_rail(const std::vector<Vector>& points) {
  std::vector<Row> rows;
  for (const Vector& x : points) rows.push_back(Row(1, x[0], x[1], x[2]));
  const int degree = static_cast<int>(points.size()) - 1;
  return Rail(Spline<double, Row>(bezier_knots<double>(degree), rows));
}

/// Two rails on the cylinder over a parabola: c(t) = d(t^2) + (1 + t) e with d(T) = (T, T^2, 0), e = (0, 0, 1); the
/// Bezier points of c are those of t^2, t^4 and 1 + t.
Rails cylinder_rails() {
  return {bezier_rail({{0, 0, 1}, {0, 0, 1.25}, {1.0 / 6, 0, 1.5}, {0.5, 0, 1.75}, {1, 1, 2}}),
          bezier_rail({{0, 0, 0}, {0.5, 0, 0}, {1, 1, 0}})};
}

/// Two straight rails whose directions enclose an angle: no ruling but those of a point are developable.
Rails skew_rails(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return {bezier_rail({{-1, 0, 0}, {1, 0, 0}}),
          bezier_rail({{-std::cos(angle), -std::sin(angle), 1}, {std::cos(angle), std::sin(angle), 1}})};
}

TEST(Fit, FindsTheMappingOfDevelopableRails) {
  FitOptions options;
  options.coefficients = 3;
  const Rails rails = cylinder_rails();
  const Fit fit = fit_rails(rails, options);
  EXPECT_NEAR(mapping_value(fit.mapping, 0.5), 0.25, 1e-9);
  EXPECT_LT(warp_statistics(rails, fit.mapping, 997).max, 1e-9);
  EXPECT_GT(fit.initial, 1);
}

TEST(Fit, NeverWorseThanTheSameParameter) {
  const Rails rails = skew_rails(50);
  for (const Measure measure : {Measure::mean, Measure::rms, Measure::max}) {
    FitOptions options;
    options.measure = measure;
    const Fit fit = fit_rails(rails, options);
    EXPECT_LE(fit.value, fit.initial);
  }
}

TEST(PaperFit, ItsGradientIsTheDerivative) {
  PaperOptions options;
  options.check_gradient = true;
  options.most_steps = 1;
  for (const Ends ends : {Ends::fixed, Ends::free}) {
    options.ends = ends;
    const PaperFit fit = paper_fit(cylinder_rails(), mapping_knots(2, {0, 0.25, 0.5, 1}), options);
    EXPECT_LT(fit.gradient_error, 1e-7);
    EXPECT_GT(fit.gradient_error, 0);
  }
}

TEST(PaperFit, ComesNearTheMappingOfDevelopableRails) {
  const PaperFit fit = paper_fit(cylinder_rails(), mapping_knots(2, {0, 1}), {});
  EXPECT_TRUE(fit.converged) << fit.stop;
  EXPECT_NEAR(fit.beta[1], 0, 1e-3);
  EXPECT_NEAR(fit.beta[2], 1, 1e-3);
  EXPECT_LT(fit.objective, 1e-6);
}

}  // namespace
}  // namespace torse::quasi
