// What a fit says of itself, against the definitions of its measures.
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

using test::ExactCurve;
using test::Q;

ExactCurve reversed(const ExactCurve& curve) {
  std::vector<Q> list;
  for (const Q& t : curve.knots.list()) list.push_back(-t);
  std::ranges::reverse(list);
  std::vector<Vec<Q, 4>> rows = curve.control;
  std::ranges::reverse(rows);
  return {KnotList<Q>(curve.knots.degree(), list), rows};
}

/// Random rails, one above the other by 2; from the other end if wanted.
Rails drawn_rails(std::uint64_t seed, bool backwards = false) {
  const ExactCurve c = test::drawn_curve(bezier_knots<Q>(4), false, 2 * seed);
  ExactCurve d = test::drawn_curve(test::knots(3, {0, 0, 0, 1, 2, 2, 2}), true, 2 * seed + 1);
  for (Vec<Q, 4>& row : d.control) row[3] += Q(2) * row[0];
  return {test::in_doubles(backwards ? reversed(c) : c), test::in_doubles(backwards ? reversed(d) : d)};
}

double angle(const Rails& rails, const Mapping<double>& sigma, double t, AngleKind kind) {
  return std::abs(ruling_angle(rails.c(t), rails.d(mapping_value(sigma, t)), kind).angle.value) * 180 /
         std::numbers::pi;
}

/// The measure at the middles of so many equal parts; of the maximum, at the ends too if wanted.
double measure_of(const Rails& rails, const Mapping<double>& sigma, Measure measure, AngleKind kind, std::size_t count,
                  bool ends) {
  double total = 0, squares = 0;
  double largest = ends ? std::max(angle(rails, sigma, 0, kind), angle(rails, sigma, 1, kind)) : 0;
  for (std::size_t r = 0; r < count; ++r) {
    const double a = angle(rails, sigma, (static_cast<double>(r) + 0.5) / static_cast<double>(count), kind);
    total += a / static_cast<double>(count);
    squares += a * a / static_cast<double>(count);
    largest = std::max(largest, a);
  }
  return measure == Measure::mean ? total : measure == Measure::rms ? std::sqrt(squares) : largest;
}

TEST(FitResult, SamplesByHand) {
  EXPECT_EQ(fit_samples({.degree = 2, .coefficients = 52, .samples_per_piece = 3}), 150U);
  EXPECT_EQ(fit_samples({.degree = 5, .coefficients = 45, .samples_per_piece = 7}), 280U);
  EXPECT_EQ(fit_samples({.degree = 2, .coefficients = 35, .samples_per_piece = 3}), 100U) << "at least";
}

/// At four times as many rulings as a fit samples. The maximum is that of the end rulings too.
TEST(FitResult, ItsValuesAreTheMeasuresOfItsMapping) {
  for (const Measure measure : {Measure::mean, Measure::rms, Measure::max}) {
    for (const AngleKind kind : {AngleKind::planes, AngleKind::sides}) {
      for (const Ends ends : {Ends::fixed, Ends::free}) {
        FitOptions options;
        options.coefficients = 12;
        options.measure = measure;
        options.kind = kind;
        options.ends = ends;
        const Rails rails = drawn_rails(11);
        const Fit fit = fit_rails(rails, options);
        const auto at = [&](const Mapping<double>& sigma, std::size_t count, bool with_ends) {
          return measure_of(rails, sigma, measure, kind, count, with_ends);
        };
        const Mapping<double> identity = identity_mapping(fit.mapping.knots);
        EXPECT_NEAR(fit.value, at(fit.mapping, 400, true), 1e-9);
        EXPECT_NEAR(fit.initial, at(identity, 400, true), 1e-9);
        if (kind == AngleKind::sides) {  // else the curve may be that of a fit without folds, by their angle
          const double coarse = std::abs(fit.curve.front().value - at(identity, 100, false));
          const double fine = std::abs(fit.curve.front().value - at(identity, 400, false));
          EXPECT_LT(std::min(coarse, fine), 1e-9) << "at the samples, four times as many where it is repeated";
        }
        EXPECT_EQ(fit.stages.front().start, "path");
        EXPECT_LT(fit.stages.front().after, fit.stages.front().before);
      }
    }
  }
}

TEST(FitResult, ItsTimesGoOn) {
  FitOptions options;
  options.coefficients = 12;
  const Fit fit = fit_rails(drawn_rails(11), options);
  EXPECT_EQ(fit.curve.front().seconds, 0);
  for (std::size_t i = 1; i < fit.curve.size(); ++i) EXPECT_GE(fit.curve[i].seconds, fit.curve[i - 1].seconds);
  EXPECT_GT(fit.seconds, 0);
  if (!fit.by_sides) {
    EXPECT_GE(fit.seconds, fit.curve.back().seconds);
  }
}

/// Either end may have the largest angle of all.
TEST(FitResult, BothEndsCountForTheMaximum) {
  std::array<int, 2> decided{};
  for (const std::uint64_t seed : {2U, 4U, 9U}) {
    for (const bool backwards : {false, true}) {
      FitOptions options;
      options.coefficients = 12;
      options.kind = AngleKind::sides;
      options.measure = Measure::max;
      const Rails rails = drawn_rails(seed, backwards);
      const Fit fit = fit_rails(rails, options);
      const double first = angle(rails, fit.mapping, 0, options.kind);
      const double last = angle(rails, fit.mapping, 1, options.kind);
      EXPECT_NEAR(fit.value, std::max(first, last), 1e-9);
      ++decided[first > last ? 0 : 1];
    }
  }
  EXPECT_EQ(decided[0], decided[1]);
}

/// The normals c' x w and d' x w at the two ends of a ruling, by hand.
double share_of_folds(const Rails& rails, const Mapping<double>& sigma, int count) {
  int folds = 0;
  for (int r = 0; r < count; ++r) {
    const double t = (r + 0.5) / count;
    const RailJet c = rails.c(t), d = rails.d(mapping_value(sigma, t));
    const Vector w = d.point - c.point;
    const auto normal = [&](const Vector& tangent) {
      return Vector(tangent[1] * w[2] - tangent[2] * w[1], tangent[2] * w[0] - tangent[0] * w[2],
                    tangent[0] * w[1] - tangent[1] * w[0]);
    };
    if (normal(c.first).dot(normal(d.first)) < 0) ++folds;
  }
  return static_cast<double>(folds) / count;
}

TEST(WarpStatistics, FoldsAreNormalsThatTurnPastARightAngle) {
  int some = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Rails rails = drawn_rails(seed);
    const Mapping<double> identity = identity_mapping(mapping_knots(1, {0, 1}));
    const double folded = share_of_folds(rails, identity, 50);
    EXPECT_DOUBLE_EQ(warp_statistics(rails, identity, 50).folded, folded);
    some += folded > 0 && folded < 1 ? 1 : 0;
  }
  EXPECT_GT(some, 0);
}

/// A strip that would fold over is that of the angle of sides if this costs less than half a percent more.
TEST(FitResult, FoldsAreLeftOutWhereThatCostsNextToNothing) {
  int taken = 0, left = 0;
  for (std::uint64_t seed = 1; seed <= 16; ++seed) {
    FitOptions options;
    options.coefficients = 8;
    FitOptions sides = options;
    sides.kind = AngleKind::sides;
    const Rails rails = drawn_rails(seed);
    const Fit fit = fit_rails(rails, options);
    const Fit other = fit_rails(rails, sides);
    const double cost = measure_of(rails, other.mapping, Measure::mean, AngleKind::planes, 100, false);
    ASSERT_TRUE(fit.by_sides) << seed;
    EXPECT_NEAR(*fit.by_sides, cost, 1e-9) << seed;
    if (coefficients(fit.mapping) == coefficients(other.mapping)) {
      ++taken;
    } else {
      ++left;
      EXPECT_GE(cost, 1.005 * measure_of(rails, fit.mapping, Measure::mean, AngleKind::planes, 100, false)) << seed;
      EXPECT_GT(share_of_folds(rails, fit.mapping, 100), 0) << seed;
    }
  }
  EXPECT_GT(taken, 0);
  EXPECT_GT(left, 0);
}

/// Between two parallel arcs.
TEST(FitResult, WhereNothingFoldsOneAngleWillDo) {
  const auto arc = [](int height) {
    return test::rail_of({test::hundredths({0, 100}), test::hundredths({0, 0, 100}), test::hundredths({height})});
  };
  const Fit fit = fit_rails({arc(0), arc(100)}, {.coefficients = 8});
  EXPECT_FALSE(fit.by_sides);
  EXPECT_EQ(share_of_folds({arc(0), arc(100)}, fit.mapping, 100), 0);
}

/// Where it costs nothing no two coefficients are equal at an end, and elsewhere no more than leave a slope at the knot
/// that they share. Some of them would be: their rise is that of equal ones that are parted.
TEST(FitResult, MappingsHaveASlopeEverywhere) {
  std::array<int, 3> parted{};
  for (const int degree : {1, 2, 3}) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      FitOptions options;
      options.degree = degree;
      options.coefficients = 30;
      options.kind = AngleKind::sides;
      const std::vector<double> beta = coefficients(fit_rails(drawn_rails(seed), options).mapping);
      EXPECT_LT(beta[0], beta[1]) << degree << " " << seed;
      EXPECT_LT(beta[28], beta[29]) << degree << " " << seed;
      const std::size_t inside = degree == 3 ? 2 : 1;
      for (std::size_t i = 0; i + inside < beta.size(); ++i) {
        EXPECT_LT(beta[i], beta[i + inside]) << degree << " " << seed << " " << i;
        if (beta[i + inside] - beta[i] < 1e-6) ++parted[static_cast<std::size_t>(degree) - 1];
      }
    }
  }
  for (const int count : parted) EXPECT_GT(count, 0);
}

/// This mapping is steepest in its first step, and better where that is the second one.
TEST(FitResult, TheFirstStepMayBeTheOneToShift) {
  const Fit fit = fit_rails(drawn_rails(22), {.degree = 1, .coefficients = 12, .kind = AngleKind::sides});
  const auto shifted = std::ranges::find(fit.stages, "shifted", &FitStage::start);
  ASSERT_NE(shifted, fit.stages.end());
  EXPECT_LT(shifted->after, 0.999 * fit.stages.front().after);
}

/// What the last stage of a fit by the maximum promises is there: its mean, and a maximum that has not grown.
TEST(FitResult, TheMeanThatIsLoweredIsThatOfItsMapping) {
  FitOptions options;
  options.coefficients = 6;
  options.kind = AngleKind::sides;
  options.measure = Measure::max;
  for (const std::uint64_t seed : {1U, 3U, 5U, 7U}) {
    const Rails rails = drawn_rails(seed);
    const Fit fit = fit_rails(rails, options);
    ASSERT_EQ(fit.stages.back().start, "mean");
    EXPECT_NEAR(measure_of(rails, fit.mapping, Measure::mean, options.kind, 100, false) / fit.stages.back().after, 1,
                1e-3)
        << seed;
  }
}

}  // namespace
}  // namespace torse::quasi
