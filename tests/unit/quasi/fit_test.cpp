// Fits of rails whose best mapping is known, and of rails that have none.
#include "torse/quasi/fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "../spline/splines.hpp"
#include "rails.hpp"
#include "support/refusal.hpp"
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

/// Cylinder, cone and tangent surface with the rail d and this mapping.
std::vector<Rails> developable_rails(const Polynomial<Rational>& sigma) {
  using test::hundredths;
  const test::Polynomials d{hundredths({0, 100}), hundredths({0, 20, 70}), hundredths({10, 0, 10, 50})};
  const test::Polynomials along = test::compose(d, sigma);
  const test::Polynomials direction{hundredths({30}), hundredths({10}), hundredths({-50})};
  const test::Polynomials apex{hundredths({30}), hundredths({40}), hundredths({300})};
  const auto rails = [](const test::Polynomials& c, const test::Polynomials& e) {
    return Rails{test::rail_of(c), test::rail_of(e)};
  };
  return {rails(test::plus(along, test::times(hundredths({100, 30}), direction)), d),
          rails(test::plus(test::times(hundredths({50, 20}), along), test::times(hundredths({50, -20}), apex)), d),
          rails(test::plus(along, test::times(hundredths({30, 20}), test::compose(test::derivative(d), sigma))),
                test::plus(d, test::derivative(d)))};
}

TEST(Fit, MappingsOfTheSpaceComeOutToRounding) {
  const auto expect_exact = [](const Polynomial<Rational>& sigma, int degree, int coefficients) {
    for (const Rails& rails : developable_rails(sigma)) {
      FitOptions options;
      options.degree = degree;
      options.coefficients = coefficients;
      const Fit fit = fit_rails(rails, options);
      EXPECT_LT(warp_statistics(rails, fit.mapping, 997).max, 1e-9) << degree << " " << coefficients;
      for (const double t : {0.125, 0.5, 0.875}) {
        EXPECT_NEAR(mapping_value(fit.mapping, t), sigma(ratio<Rational>(static_cast<int>(8 * t), 8)).to_double(),
                    1e-9);
      }
    }
  };
  for (const auto& [degree, coefficients] : {std::pair{2, 3}, {2, 20}, {3, 4}, {5, 12}}) {
    expect_exact(test::hundredths({0, 0, 100}), degree, coefficients);
    expect_exact(test::hundredths({0, 50, 50}), degree, coefficients);
  }
  for (const auto& [degree, coefficients] : {std::pair{3, 4}, {5, 6}}) {
    expect_exact(test::hundredths({0, 30, 120, -50}), degree, coefficients);
  }
}

/// A tenth of what BZZ19 reports in section 5 for known mappings: 0.026 and 5.5e-4 degrees.
TEST(Fit, OtherMappingsWithAHundredCoefficients) {
  for (const std::vector<int>& sigma : {std::vector{0, 30, 120, -50}, {0, 200, -180, 80}, {0, 0, 0, 100}}) {
    for (const Rails& rails : developable_rails(test::hundredths(sigma))) {
      for (const bool adaptive : {false, true}) {
        FitOptions options;
        options.coefficients = 100;
        options.adaptive = adaptive;
        const WarpStatistics warp = warp_statistics(rails, fit_rails(rails, options).mapping, 1999);
        EXPECT_LT(warp.max, 0.0026);
        EXPECT_LT(warp.mean, 5.5e-5);
      }
    }
  }
}

TEST(Fit, CoefficientsInOrderWithTheEndsAndTheNumberAskedFor) {
  const test::ExactCurve upper = test::drawn_curve(bezier_knots<Rational>(4), true, 5);
  std::vector<Vec<Rational, 4>> rows = upper.control;
  for (Vec<Rational, 4>& row : rows) row[3] += Rational(2) * row[0];
  const Rails rails{test::in_doubles(test::drawn_curve(bezier_knots<Rational>(3), false, 4)),
                    test::in_doubles(test::ExactCurve(upper.knots, rows))};
  for (int degree = 1; degree <= 5; ++degree) {
    for (const int count : {degree + 1, 17, degree == 2 ? 200 : 30}) {
      for (const Ends ends : {Ends::fixed, Ends::free}) {
        FitOptions options;
        options.degree = degree;
        options.coefficients = count;
        options.ends = ends;
        options.adaptive = count == 17;
        const Fit fit = fit_rails(rails, options);
        const std::vector<double> beta = coefficients(fit.mapping);
        EXPECT_EQ(beta.size(), static_cast<std::size_t>(count));
        EXPECT_EQ(fit.mapping.knots.degree(), degree);
        EXPECT_TRUE(std::ranges::is_sorted(beta));
        EXPECT_GE(beta.front(), 0);
        EXPECT_LE(beta.back(), 1);
        if (ends == Ends::fixed) {
          EXPECT_EQ(beta.front(), 0);
          EXPECT_EQ(beta.back(), 1);
        }
        EXPECT_LE(fit.value, fit.initial);
        for (std::size_t i = 1; i < fit.curve.size(); ++i) EXPECT_LE(fit.curve[i].value, fit.curve[i - 1].value);
      }
    }
  }
}

/// Random rails, one above the other by 2.
std::pair<test::ExactCurve, test::ExactCurve> drawn_curves(std::uint64_t seed) {
  test::ExactCurve d = test::drawn_curve(test::knots(3, {0, 0, 0, 1, 2, 2, 2}), true, 2 * seed + 1);
  for (Vec<Rational, 4>& row : d.control) row[3] += Rational(2) * row[0];
  return {test::drawn_curve(bezier_knots<Rational>(4), false, 2 * seed), d};
}

Rails drawn_rails(std::uint64_t seed) {
  const auto [c, d] = drawn_curves(seed);
  return {test::in_doubles(c), test::in_doubles(d)};
}

/// With better knots the first of these strips is worse, the second much better.
TEST(Fit, IsTheBestOfItsStages) {
  for (const std::uint64_t seed : {7U, 11U}) {
    FitOptions options;
    options.coefficients = 12;
    options.kind = AngleKind::sides;
    const Fit fit = fit_rails(drawn_rails(seed), options);
    double best = fit.stages.front().after;
    for (const FitStage& stage : fit.stages) {
      EXPECT_LE(stage.after, stage.before) << stage.start;
      best = std::min(best, stage.after);
    }
    EXPECT_EQ(fit.stages.back().start, "moved knots");
    EXPECT_EQ(fit.stages.back().after == best, seed == 11);
    EXPECT_NEAR(fit.curve.back().value / best, 1, 1e-12);
    EXPECT_LT(fit.value, 1.015 * best) << "between the samples of the descents";
    EXPECT_GT(fit.value, 0.95 * best);
  }
}

/// The path of the first strip leads to a worse mapping than T = t, which is tried then; those of the others do not.
TEST(Fit, StartsFromTheSameParameterOnlyWhereThePathIsWorse) {
  for (const std::uint64_t seed : {28U, 7U, 11U}) {
    FitOptions options;
    options.coefficients = 3;
    options.adaptive = false;
    const Fit fit = fit_rails(drawn_rails(seed), options);
    const FitStage& path = fit.stages.front();
    EXPECT_EQ(path.start, "path");
    EXPECT_EQ(std::ranges::count(fit.stages, "T = t", &FitStage::start), seed == 28 ? 1 : 0);
    EXPECT_EQ(fit.stages.back().after < 0.99 * path.after, seed == 28);
    EXPECT_LT(fit.value, 1.02 * fit.stages.back().after);
  }
}

/// Rulings between parallel lines have no angle, whatever the mapping: the first descent is enough.
TEST(Fit, StartsOnceWhereThereIsNothingToGain) {
  const Fit fit = fit_rails(skew_rails(0), {});
  EXPECT_EQ(fit.initial, 0);
  EXPECT_EQ(fit.value, 0);
  EXPECT_EQ(std::ranges::count(fit.stages, "path", &FitStage::start), 1);
  EXPECT_EQ(std::ranges::count(fit.stages, "T = t", &FitStage::start), 0);
}

Fit sides_fit(std::uint64_t seed, Measure measure, int coefficients) {
  FitOptions options;
  options.coefficients = coefficients;
  options.kind = AngleKind::sides;
  options.measure = measure;
  return fit_rails(drawn_rails(seed), options);
}

/// The mapping with the least mean has a larger maximum, so the mean is lowered as far as it stays.
TEST(Fit, TheMaximumStaysWhereTheMeanIsLowered) {
  const Fit fit = sides_fit(7, Measure::max, 6);
  const FitStage& mean = fit.stages.back();
  EXPECT_EQ(mean.start, "mean");
  EXPECT_LE(mean.after, mean.before);
  double best = fit.stages.front().after;
  for (const FitStage& stage : fit.stages) {
    if (stage.start != "mean") best = std::min(best, stage.after);
  }
  EXPECT_LT(fit.value, 1.05 * best);
  const Rails rails = drawn_rails(7);
  EXPECT_GT(warp_statistics(rails, sides_fit(7, Measure::mean, 6).mapping, 997).max, 1.1 * best);
}

/// Fixed ends have the largest angle whatever the mapping is: the one with the least mean is the best.
TEST(Fit, WhereTheEndsDecideTheMaximumTheMeanDecides) {
  for (const std::uint64_t seed : {2U, 4U, 9U}) {
    const Fit fit = sides_fit(seed, Measure::max, 12);
    const Rails rails = drawn_rails(seed);
    const auto angle = [&](double t) {
      return std::abs(ruling_angle(rails.c(t), rails.d(t), AngleKind::sides).angle.value);
    };
    EXPECT_NEAR(fit.value, std::max(angle(0), angle(1)) * 180 / std::numbers::pi, 1e-9);
    const std::vector<double> found = coefficients(fit.mapping);
    const std::vector<double> expected = coefficients(sides_fit(seed, Measure::mean, 12).mapping);
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-3) << seed << " " << i;
  }
}

/// The same strip drawn from the other end: what is shifted backwards in one is shifted forwards in the other.
TEST(Fit, ReversedRailsAreShiftedAsWell) {
  const auto reversed = [](const test::ExactCurve& curve) {
    std::vector<Rational> list;
    for (const Rational& t : curve.knots.list()) list.push_back(-t);
    std::ranges::reverse(list);
    std::vector<Vec<Rational, 4>> rows = curve.control;
    std::ranges::reverse(rows);
    return test::ExactCurve(KnotList<Rational>(curve.knots.degree(), list), rows);
  };
  FitOptions options;
  options.coefficients = 12;
  options.kind = AngleKind::sides;
  const auto [c, d] = drawn_curves(11);
  const Fit forwards = fit_rails({test::in_doubles(c), test::in_doubles(d)}, options);
  const Fit backwards = fit_rails({test::in_doubles(reversed(c)), test::in_doubles(reversed(d))}, options);
  EXPECT_GT(std::ranges::count(forwards.stages, "shifted", &FitStage::start), 0);
  EXPECT_GT(std::ranges::count(backwards.stages, "shifted", &FitStage::start), 0);
  EXPECT_NEAR(backwards.value / forwards.value, 1, 0.02);
}

TEST(SampledRulings, AreSpreadEvenlyWithTheirWarp) {
  const Rails rails = drawn_rails(7);
  const Mapping<double> sigma = sides_fit(7, Measure::mean, 6).mapping;
  const std::vector<SampledRuling> rulings = sampled_rulings(rails, sigma, 20);
  ASSERT_EQ(rulings.size(), 20U);
  // From the first to the last of 320 even parts.
  EXPECT_DOUBLE_EQ(rulings.front().t, 0.5 / 320);
  EXPECT_DOUBLE_EQ(rulings.back().t, 1 - 0.5 / 320);
  double largest = 0;
  for (std::size_t i = 0; i < rulings.size(); ++i) {
    const SampledRuling& r = rulings[i];
    EXPECT_NEAR(r.t + r.target, 2 * static_cast<double>(i) / 19, 0.05);
    EXPECT_NEAR(r.target, mapping_value(sigma, r.t), 1e-12);
    EXPECT_LT((r.c - rails.c(r.t).point).norm() + (r.d - rails.d(r.target).point).norm(), 1e-12);
    const double angle = ruling_angle(rails.c(r.t), rails.d(r.target), AngleKind::planes).angle.value;
    EXPECT_NEAR(r.warp, std::abs(angle) * 180 / std::numbers::pi, 1e-9);
    largest = std::max(largest, r.warp);
  }
  EXPECT_GT(largest, 1);
}

/// More than `degree` equal coefficients would make a cone of a piece: they are parted, but by little.
TEST(Fit, NoPieceRestsOnAPointOfTheSecondRail) {
  int parted = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    for (const Ends ends : {Ends::fixed, Ends::free}) {
      FitOptions options;
      options.coefficients = 30;
      options.ends = ends;
      const Fit fit = fit_rails(drawn_rails(seed), options);
      EXPECT_LT(fit.value, fit.initial) << seed;
      const std::vector<double> beta = coefficients(fit.mapping);
      for (std::size_t i = 0; i + 2 < beta.size(); ++i) {
        EXPECT_LT(beta[i], beta[i + 2]) << seed << " " << i;
        parted += beta[i + 2] - beta[i] < 1e-6 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(parted, 0);
}

TEST(Fit, Errors) {
  const auto place = [](int degree, int count) {
    FitOptions options;
    options.degree = degree;
    options.coefficients = count;
    return test::place_of([&] { return fit_rails(skew_rails(10), options); });
  };
  EXPECT_EQ(place(0, 5), "degree");
  EXPECT_EQ(place(11, 50), "degree");
  EXPECT_EQ(place(3, 3), "coefficients");
  EXPECT_EQ(place(2, 10001), "coefficients");
  EXPECT_EQ(place(3, 4), "");
  FitOptions few;
  few.degree = 3;
  few.coefficients = 3;
  try {
    fit_rails(skew_rails(10), few);
    ADD_FAILURE();
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(), "coefficients: expected 4 to 10000, found 3");
  }
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

TEST(PaperFit, StopsWhereItIsTold) {
  const KnotList<double> knots = mapping_knots(2, {0, 1});
  const PaperFit whole = paper_fit(cylinder_rails(), knots, {});
  const auto steps = [&](const PaperOptions& options) {
    const PaperFit fit = paper_fit(cylinder_rails(), knots, options);
    EXPECT_EQ(fit.converged, fit.steps < options.most_steps);
    EXPECT_EQ(fit.stop, fit.converged ? "the gradient or the change of the objective is small" : "the steps ran out");
    EXPECT_GE(fit.evaluations, fit.steps);
    EXPECT_GE(fit.objective, whole.objective);
    EXPECT_EQ(fit.objective, fit.curve.back().objective);
    return fit.steps;
  };
  PaperOptions few, steep, changing;
  few.most_steps = 15;
  steep.gradient = 1e-2;
  changing.change = 0.5;
  EXPECT_EQ(steps(few), 15);
  EXPECT_LT(steps(steep), whole.steps);
  EXPECT_LT(steps(changing), whole.steps);
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
