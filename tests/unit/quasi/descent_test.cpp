// Descents on sampled warps: against a scan of all mappings with one unknown, what each measure makes small, and rails
// of every awkward kind.
#include "torse/quasi/descent.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "../spline/splines.hpp"
#include "rails.hpp"
#include "torse/quasi/fit.hpp"

namespace torse::quasi {
namespace {

using test::hundredths;
using test::Polynomials;
using test::Q;

constexpr double degrees = 180 / std::numbers::pi;

/// Random rails, one above the other by 2.
Rails drawn_rails(std::uint64_t seed) {
  test::ExactCurve d = test::drawn_curve(test::knots(3, {0, 0, 0, 1, 2, 2, 2}), seed % 2 == 1, 2 * seed + 1);
  for (Vec<Q, 4>& row : d.control) row[3] += Q(2) * row[0];
  return {test::in_doubles(test::drawn_curve(bezier_knots<Q>(4), false, 2 * seed)), test::in_doubles(d)};
}

/// Ten pieces of degree 2 and 50 samples.
struct Problem {
  Rails rails;
  KnotList<double> knots = mapping_knots(2, {0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1});
  Sampling samples{rails.c, knots, midpoints(50)};
  std::vector<double> identity = coefficients(identity_mapping(knots));
};

/// Kept in order, between 0 and 1, at the ends where these are fixed, finite, and not worse than the start.
void expect_sound(const Problem& problem, const Descent& descent, const DescentOptions& options) {
  const std::vector<double>& beta = descent.beta;
  EXPECT_TRUE(std::ranges::is_sorted(beta));
  EXPECT_GE(beta.front(), 0);
  EXPECT_LE(beta.back(), 1);
  if (options.ends == Ends::fixed) {
    EXPECT_EQ(beta.front(), 0);
    EXPECT_EQ(beta.back(), 1);
  }
  EXPECT_TRUE(std::isfinite(descent.value));
  EXPECT_EQ(descent.value, measured(problem.rails.d, problem.samples, beta, options));
  EXPECT_LE(descent.value, measured(problem.rails.d, problem.samples, problem.identity, options));
  for (const DescentStep& step : descent.steps) EXPECT_GE(step.value, descent.value);
}

void expect_sound_descents(const Rails& rails) {
  const Problem problem{rails};
  for (const Measure measure : {Measure::mean, Measure::rms, Measure::max}) {
    for (const AngleKind kind : {AngleKind::planes, AngleKind::sides}) {
      for (const Ends ends : {Ends::fixed, Ends::free}) {
        DescentOptions options;
        options.measure = measure;
        options.kind = kind;
        options.ends = ends;
        expect_sound(problem, descend(rails.d, problem.samples, problem.identity, options), options);
      }
    }
  }
}

TEST(Descent, NeverWorseThanItsStart) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) expect_sound_descents(drawn_rails(seed));
}

/// The measures of a mapping by their definitions, from the statistics of the angles.
TEST(Descent, MeasuresAreThoseOfTheStatistics) {
  const Problem problem{drawn_rails(3)};
  const WarpStatistics statistics = warp_statistics(problem.rails.d, problem.samples, problem.identity);
  DescentOptions options;
  const auto value = [&](Measure measure) {
    options.measure = measure;
    return measured(problem.rails.d, problem.samples, problem.identity, options) * degrees;
  };
  EXPECT_NEAR(value(Measure::mean), statistics.mean, 1e-12);
  EXPECT_NEAR(value(Measure::rms), statistics.rms, 1e-12);
  EXPECT_NEAR(value(Measure::max), statistics.max, 1e-12);
}

/// Two arcs, the upper one turned by so many degrees.
Rails turned_arcs(int turn) {
  const int x = static_cast<int>(std::lround(100 * std::cos(turn / degrees)));
  const int y = static_cast<int>(std::lround(100 * std::sin(turn / degrees)));
  return {test::rail_of({hundredths({-100, 200}), hundredths({0, 40, -40}), hundredths({0})}),
          test::rail_of({hundredths({-x, 2 * x}), hundredths({-y, 2 * y, 30, -30}), hundredths({100})})};
}

/// From one start into one valley: each measure is least where it was what the descent made small. The descents end
/// where a stage gains less than a part in 10^4; the maximum is that of a power of 64 at most, over 50 samples.
TEST(Descent, EachMeasureIsLeastWhereItWasMinimised) {
  const Problem problem{turned_arcs(40)};
  const std::array<Measure, 3> measures{Measure::mean, Measure::rms, Measure::max};
  std::array<std::array<double, 3>, 3> value;  // [minimised][measured]
  for (std::size_t i = 0; i < 3; ++i) {
    DescentOptions options;
    options.ends = Ends::free;
    options.measure = measures[i];
    const Descent descent = descend(problem.rails.d, problem.samples, problem.identity, options);
    for (std::size_t j = 0; j < 3; ++j) {
      options.measure = measures[j];
      value[i][j] = measured(problem.rails.d, problem.samples, descent.beta, options);
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const double slack = measures[j] == Measure::max ? std::pow(50, 1.0 / 64) : 1.001;
      EXPECT_LE(value[j][j], value[i][j] * slack) << "minimised " << i << ", measured " << j;
    }
  }
}

/// Newton's method with the second derivatives of the angles: a smooth measure is least after a few steps. Two steps do
/// not tell that it is.
TEST(Descent, ASmoothMeasureTakesFewSteps) {
  for (const int turn : {20, 40, 60}) {
    const Problem problem{turned_arcs(turn)};
    DescentOptions options;
    options.ends = Ends::free;
    options.measure = Measure::rms;
    const Descent descent = descend(problem.rails.d, problem.samples, problem.identity, options);
    EXPECT_TRUE(descent.converged);
    EXPECT_LE(descent.steps.size(), 4U) << turn;
    options.stages = 2;
    options.steps_per_stage = 1;
    const Descent brief = descend(problem.rails.d, problem.samples, problem.identity, options);
    ASSERT_EQ(brief.steps.size(), 2U);
    EXPECT_LT(brief.steps[1].value, 0.9999 * brief.steps[0].value);
    EXPECT_GT(brief.value, 1.0001 * descent.value);
    EXPECT_FALSE(brief.converged);
  }
}

/// Over many pairs, valleys of their own included; the root mean square lies between the mean and the maximum.
TEST(Descent, EachMeasureIsLeastOnTheWholeWhereItWasMinimised) {
  const std::array<Measure, 3> measures{Measure::mean, Measure::rms, Measure::max};
  std::array<std::array<double, 3>, 3> total{};
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Problem problem{drawn_rails(seed)};
    for (std::size_t i = 0; i < 3; ++i) {
      DescentOptions options;
      options.measure = measures[i];
      const Descent descent = descend(problem.rails.d, problem.samples, problem.identity, options);
      for (std::size_t j = 0; j < 3; ++j) {
        options.measure = measures[j];
        total[i][j] += measured(problem.rails.d, problem.samples, descent.beta, options);
      }
    }
  }
  for (const std::size_t other : {0U, 1U}) EXPECT_LT(total[2][2], 0.995 * total[other][2]) << "minimised " << other;
  for (const std::size_t other : {1U, 2U}) EXPECT_LT(total[0][0], 0.995 * total[other][0]) << "minimised " << other;
}

/// Two pieces of degree 1 with fixed ends: sigma(1/2) is the only unknown.
TEST(Descent, OneUnknownAgainstAScan) {
  const KnotList<double> knots = mapping_knots(1, {0, 0.5, 1});
  for (const int turn : {10, 25, 60}) {
    const Rails rails = turned_arcs(turn);
    const Sampling samples(rails.c, knots, midpoints(40));
    for (const Measure measure : {Measure::mean, Measure::rms, Measure::max}) {
      DescentOptions options;
      options.measure = measure;
      double least = 10;
      for (int i = 0; i <= 200; ++i) {
        least = std::min(least, measured(rails.d, samples, std::vector<double>{0, i / 200.0, 1}, options));
      }
      const Descent descent = descend(rails.d, samples, {0, 0.8, 1}, options);
      const double slack = measure == Measure::max ? std::pow(40, 1.0 / 64) : 1.001;
      EXPECT_LE(descent.value, least * slack) << turn << " " << static_cast<int>(measure) << " " << descent.beta[1];
      EXPECT_NE(descent.beta[1], 0.8);
    }
  }
}

/// Cylinder, cone and tangent surface over d with the mapping T = (t + t^2) / 2.
std::vector<Rails> developable_rails(int size_exponent) {
  const Polynomials d{hundredths({0, 100}), hundredths({0, 20, 70}), hundredths({10, 0, 10, 50})};
  const Polynomial<Q> sigma = hundredths({0, 50, 50});
  const Polynomials along = test::compose(d, sigma);
  const Polynomials straight{hundredths({0}), hundredths({0, 10}), hundredths({100, 50})};
  const Polynomials apex{hundredths({30}), hundredths({40}), hundredths({300})};
  const Polynomials direction{hundredths({30}), hundredths({10}), hundredths({-50})};
  const Polynomial<Q> size = [&] {
    Q x(1);
    for (int i = 0; i < std::abs(size_exponent); ++i) x *= size_exponent > 0 ? Q(10) : ratio<Q>(1, 10);
    return Polynomial<Q>::constant(x);
  }();
  const auto rails = [&](const Polynomials& c, const Polynomials& e) {
    return Rails{test::rail_of(test::times(size, c)), test::rail_of(test::times(size, e))};
  };
  return {rails(test::plus(along, test::times(hundredths({100, 30}), direction)), d),
          rails(test::plus(test::times(hundredths({50, 20}), along), test::times(hundredths({50, -20}), apex)), d),
          rails(test::plus(along, test::times(hundredths({30, 20}), test::compose(test::derivative(d), sigma))),
                test::plus(d, test::derivative(d)))};
}

TEST(Descent, DevelopableRailsOfEverySizeComeOutExactly) {
  for (const int size : {0, -6, 6}) {
    for (const Rails& rails : developable_rails(size)) {
      const KnotList<double> knots = mapping_knots(2, {0, 0.5, 1});
      const Sampling samples(rails.c, knots, midpoints(60));
      for (const Measure measure : {Measure::mean, Measure::rms, Measure::max}) {
        DescentOptions options;
        options.measure = measure;
        const Descent descent = descend(rails.d, samples, coefficients(identity_mapping(knots)), options);
        EXPECT_LT(descent.value, 1e-11) << size << " " << static_cast<int>(measure);
        // (t + t^2) / 2 over the knots 0, 0, 1/2, 1, 1: the values (a + b + 2 a b) / 4 of its blossom.
        EXPECT_NEAR(descent.beta[1], 0.125, 1e-9);
        EXPECT_NEAR(descent.beta[2], 0.625, 1e-9);
      }
    }
  }
}

/// A cylinder over the middle half of d, T = (1 + 2 t) / 4, from where all coefficients but one are right already.
TEST(Descent, EachCoefficientMovesAlone) {
  const Polynomials d{hundredths({0, 100}), hundredths({0, 20, 70}), hundredths({10, 0, 10, 50})};
  const Polynomials direction{hundredths({30}), hundredths({10}), hundredths({-50})};
  const Rails rails{test::rail_of(test::plus(test::compose(d, hundredths({25, 50})), direction)), test::rail_of(d)};
  const KnotList<double> knots = mapping_knots(1, {0, 0.5, 1});
  const Sampling samples(rails.c, knots, midpoints(40));
  const std::vector<double> exact{0.25, 0.5, 0.75};
  for (const Measure measure : {Measure::mean, Measure::rms, Measure::max}) {
    DescentOptions options;
    options.measure = measure;
    options.ends = Ends::free;
    for (std::size_t i = 0; i < 3; ++i) {
      std::vector<double> start = exact;
      start[i] -= 0.125;
      const Descent descent = descend(rails.d, samples, start, options);
      for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(descent.beta[j], exact[j], 1e-9) << i << " " << j;
    }
  }
}

TEST(Descent, WithoutStagesOneEvaluationIsTheResult) {
  const Problem problem{turned_arcs(40)};
  DescentOptions options;
  options.stages = 0;
  const Descent descent = descend(problem.rails.d, problem.samples, problem.identity, options);
  EXPECT_EQ(descent.evaluations, 1);
  EXPECT_TRUE(descent.steps.empty());
  EXPECT_FALSE(descent.converged);
  EXPECT_EQ(descent.beta, problem.identity);
  EXPECT_EQ(descent.value, measured(problem.rails.d, problem.samples, problem.identity, options));
}

TEST(Descent, AwkwardRails) {
  const Polynomials line{hundredths({0, 100}), hundredths({0}), hundredths({0})};
  const Polynomials cross{hundredths({0, 40}), hundredths({-50, 100}), hundredths({100})};
  const Polynomials arc{hundredths({0, 100}), hundredths({0, 100, -100}), hundredths({0})};
  const Polynomials cusp{hundredths({0, 0, 100}), hundredths({0, 0, 0, 100}), hundredths({100})};
  const Polynomials loop{hundredths({0, 100, -100}), hundredths({0, 0, 100, -100}), hundredths({0})};
  const Polynomials lifted{hundredths({0, 100, -100}), hundredths({10, 0, 100, -100}), hundredths({100})};
  const Polynomials stopped{hundredths({50}), hundredths({50}), hundredths({100})};
  const auto pair = [](const Polynomials& c, const Polynomials& d) {
    return Rails{test::rail_of(c), test::rail_of(d)};
  };
  expect_sound_descents(pair(line, cross));  // straight and skew: every ruling is warped
  expect_sound_descents(pair(line, line));   // the same rail twice
  expect_sound_descents(pair(line, arc));    // they meet at both ends
  expect_sound_descents(pair(arc, cusp));    // a cusp at an end
  expect_sound_descents(pair(cusp, arc));
  expect_sound_descents(pair(loop, lifted));  // both closed
  expect_sound_descents(pair(arc, stopped));  // a rail that is a point
  expect_sound_descents(pair(stopped, arc));
  // A rail that rests at a point for a while.
  std::vector<Vec<double, 4>> rows;
  for (const double x : {0.0, 0.5, 0.5, 0.5, 0.5, 1.0}) rows.emplace_back(1, x, x * x, 1);
  const Rail resting(Spline<double, Vec<double, 4>>(KnotList<double>(3, {0, 0, 0, 1, 2, 3, 3, 3}), rows));
  expect_sound_descents({test::rail_of(arc), resting});
  expect_sound_descents({resting, test::rail_of(arc)});
}

}  // namespace
}  // namespace torse::quasi
