#include "torse/quasi/fit.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

#include "torse/quasi/breaks.hpp"
#include "torse/quasi/equal_runs.hpp"

namespace torse::quasi {
namespace {

constexpr double degrees = 180 / std::numbers::pi;

/// Rows of the grid of the global start, and the most columns: one for each piece of the mapping where these are less.
constexpr int grid_rows = 96;
constexpr int least_columns = 24;
constexpr int most_columns = 200;

constexpr std::size_t least_samples = 100;

/// A result is measured at so many times as many rulings, and the fit repeated with `finer` times as many samples where
/// the measure exceeds that at the samples by this factor.
constexpr std::size_t between = 4;
constexpr double missed = 1.5;
constexpr int finer = 4;

/// Measures below this, in degrees, differ by rounding.
constexpr double rounding = 1e-9;

/// What a strip may cost that does not fold over, as a factor of the measure.
constexpr double next_to_nothing = 1.005;

/// What a surface may cost that is not singular, or whose mean is lower than that of others with its maximum.
constexpr double as_good = 1.0001;

/// A place is steep where a coefficient exceeds the one before by so many times the mean difference.
constexpr double steep = 4;

/// As many of the steepest places as are tried elsewhere, and what a trial has to gain.
constexpr std::size_t most_shifts = 4;
constexpr double worth_while = 0.999;

/// The larger angle of the rulings from the ends of c, which lead to d at the first and the last coefficient.
double end_angle(const Rails& rails, const std::vector<double>& beta, AngleKind kind) {
  return std::max(std::abs(ruling_angle(rails.c(0), rails.d(beta.front()), kind).angle.value),
                  std::abs(ruling_angle(rails.c(1), rails.d(beta.back()), kind).angle.value));
}

class Fitter {
 public:
  Fitter(const Rails& rails, const FitOptions& options)
      : rails_(rails),
        options_(options),
        breaks_(even_breaks(options.coefficients - options.degree)),
        knots_(mapping_knots(options.degree, breaks_)),
        samples_(rails.c, knots_, sample_parameters()),
        fit_{identity_mapping(knots_)} {}

  Fit run() {
    const std::vector<double> identity = coefficients(fit_.mapping);
    fit_.initial = measured(rails_.d, samples_, identity, descent_options()) * degrees;
    fit_.curve.push_back({fit_.initial, 0});
    const int columns = std::clamp(options_.coefficients - options_.degree, least_columns, most_columns);
    const RulingGrid grid(rails_, columns, grid_rows, options_.kind);
    start_from("path", follow_path(best_path(grid, options_.ends), identity));
    if (value_ > fit_.initial) start_from("T = t", identity);
    shift_steep_places();
    if (options_.adaptive) move_knots();
    if (options_.measure == Measure::max) lower_mean();
    part_equal_coefficients();
    fit_.mapping = mapping_of(knots_, beta_);
    fit_.value = seen(beta_);
    fit_.seconds = elapsed();
    return std::move(fit_);
  }

 private:
  std::vector<double> sample_parameters() const { return midpoints(fit_samples(options_)); }

  DescentOptions descent_options() const {
    DescentOptions descent;
    descent.measure = options_.measure;
    descent.kind = options_.kind;
    descent.ends = options_.ends;
    return descent;
  }

  double elapsed() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

  Descent descend_from(const std::string& name, const Sampling& samples, std::vector<double> beta,
                       const DescentOptions& options) {
    const double before = elapsed();
    const double initial = measured(rails_.d, samples, beta, options) * degrees;
    Descent descent = descend(rails_.d, samples, std::move(beta), options);
    for (const DescentStep& step : descent.steps) {
      fit_.curve.push_back({std::min(fit_.curve.back().value, step.value * degrees), before + step.seconds});
    }
    fit_.stages.push_back({name, initial, descent.value * degrees, static_cast<int>(descent.steps.size()),
                           descent.evaluations, descent.converged});
    return descent;
  }

  /// Goes on where a descent from beta ends.
  void start_from(const std::string& name, std::vector<double> beta) {
    Descent descent = descend_from(name, samples_, std::move(beta), descent_options());
    beta_ = std::move(descent.beta);
    value_ = descent.value * degrees;
  }

  /// A steep place of the mapping is in one piece or in another: no descent leads from here to there. So the steepest
  /// ones are moved to the pieces beside them.
  void shift_steep_places() {
    std::vector<std::size_t> places;
    const double mean = (beta_.back() - beta_.front()) / static_cast<double>(beta_.size() - 1);
    for (std::size_t i = 1; i < beta_.size(); ++i) {
      if (beta_[i] - beta_[i - 1] > steep * mean) places.push_back(i);
    }
    std::ranges::sort(places, std::greater<>(), [&](std::size_t i) { return beta_[i] - beta_[i - 1]; });
    places.resize(std::min(places.size(), most_shifts));
    for (const std::size_t place : places) {
      for (const bool forwards : {false, true}) shift(place, forwards);
    }
  }

  /// Moves the step between beta_{i-1} and beta_i one piece further as long as that helps.
  void shift(std::size_t i, bool forwards) {
    while (forwards ? i + 1 != beta_.size() : i != 1) {
      std::vector<double> moved = beta_;
      (forwards ? moved[i] : moved[i - 1]) = forwards ? moved[i - 1] : moved[i];
      DescentOptions brief = descent_options();
      brief.stages = 2;
      brief.steps_per_stage = 3;
      const Descent glance = descend(rails_.d, samples_, std::move(moved), brief);
      if (!(glance.value * degrees < worth_while * value_)) return;
      start_from("shifted", glance.beta);
      i = forwards ? i + 1 : i - 1;
    }
  }

  void move_knots() {
    std::vector<double> warp;
    for (std::size_t r = 0; r < samples_.size(); ++r) {
      const RulingAngle ruling = ruling_angle(samples_.jet(r), rails_.d(samples_.value(beta_, r)), options_.kind);
      warp.push_back(std::abs(ruling.angle.value));
    }
    const std::vector<double> breaks =
        moved_breaks(breaks_, means_by_piece(breaks_, sample_parameters(), warp), options_.degree);
    const KnotList<double> knots = mapping_knots(options_.degree, breaks);
    const Mapping<double> now = mapping_of(knots_, beta_);
    std::vector<double> beta;
    for (const double t : coefficients(identity_mapping(knots))) beta.push_back(mapping_value(now, t));
    const Sampling samples(rails_.c, knots, sample_parameters());
    Descent descent = descend_from("moved knots", samples, std::move(beta), descent_options());
    if (!(descent.value * degrees < worth_while * value_)) return;
    beta_ = std::move(descent.beta);
    knots_ = knots;
  }

  /// A few rulings decide the maximum, often those at fixed ends. The others are made good among mappings with no
  /// larger one, by the mean: the best one by that, if it is among them, else by a descent.
  void lower_mean() {
    DescentOptions mean = descent_options();
    mean.measure = Measure::mean;
    mean.cap = as_good * seen(beta_) / degrees;
    FitOptions by_mean = options_;
    by_mean.measure = Measure::mean;
    Fit other = Fitter(rails_, by_mean).run();
    const Sampling others(rails_.c, other.mapping.knots, sample_parameters());
    if (measured(rails_.d, others, coefficients(other.mapping), descent_options()) <= mean.cap) {
      knots_ = other.mapping.knots;
      beta_ = coefficients(other.mapping);
    }
    const Sampling samples(rails_.c, knots_, sample_parameters());
    const double before = measured(rails_.d, samples, beta_, mean) * degrees;
    Descent descent = descend(rails_.d, samples, beta_, mean);
    fit_.stages.push_back({"mean", before, descent.value * degrees, static_cast<int>(descent.steps.size()),
                           descent.evaluations, descent.converged});
    beta_ = std::move(descent.beta);
  }

  /// The measure of what a fit looks at, degrees: the rulings at the samples and, for the maximum, those at fixed ends.
  double seen(const std::vector<double>& beta) const {
    const Sampling samples(rails_.c, knots_, sample_parameters());
    const double inside = measured(rails_.d, samples, beta, descent_options());
    const bool ends = options_.measure == Measure::max && options_.ends == Ends::fixed;
    return degrees * (ends ? std::max(inside, end_angle(rails_, beta, options_.kind)) : inside);
  }

  /// Where more than `degree` coefficients are equal the mapping would rest on a point of the second rail and the
  /// surface be a cone with its vertex there. Where two are at an end, or `degree` elsewhere, its slope vanishes and
  /// the surface is singular: that may stay only if the warp is better for it, as with T = t^2.
  void part_equal_coefficients() {
    const std::size_t degree = static_cast<std::size_t>(options_.degree);
    part_equal(beta_, {.at_end = degree + 1, .inside = degree + 1});
    std::vector<double> regular = beta_;
    part_equal(regular, {.at_end = 2, .inside = std::max<std::size_t>(degree, 2)});
    if (seen(regular) <= as_good * seen(beta_) + rounding) beta_ = std::move(regular);
  }

  const Rails& rails_;
  FitOptions options_;
  std::vector<double> breaks_;
  KnotList<double> knots_;
  Sampling samples_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  Fit fit_;
  std::vector<double> beta_;
  double value_ = 0;
};

/// The measure by an angle, degrees, at `times` as many rulings as a fit samples; the maximum is that of the end
/// rulings too.
double measure_at(const Rails& rails, const Mapping<double>& sigma, const FitOptions& options, AngleKind kind,
                  std::size_t times) {
  const Sampling samples(rails.c, sigma.knots, midpoints(times * fit_samples(options)));
  const DescentOptions descent{.measure = options.measure, .kind = kind};
  const std::vector<double> beta = coefficients(sigma);
  const double inside = measured(rails.d, samples, beta, descent);
  return degrees * (options.measure == Measure::max ? std::max(inside, end_angle(rails, beta, kind)) : inside);
}

/// A fit by the angle of planes, or by that of sides if the strip would fold over and this costs next to nothing.
Fit fit_without_folds(const Rails& rails, const FitOptions& options) {
  Fit fit = Fitter(rails, options).run();
  if (options.kind == AngleKind::sides || warp_statistics(rails, fit.mapping, fit_samples(options)).folded == 0) {
    return fit;
  }
  FitOptions by_sides = options;
  by_sides.kind = AngleKind::sides;
  Fit other = Fitter(rails, by_sides).run();
  const double value = measure_at(rails, other.mapping, options, AngleKind::planes, 1);
  const double seconds = fit.seconds + other.seconds;
  if (value < next_to_nothing * fit.value) {
    other.value = value;
    fit = std::move(other);
  }
  fit.by_sides = value;
  fit.seconds = seconds;
  return fit;
}

void require(const FitOptions& options) {
  if (options.degree < 1 || options.degree > 10) {
    throw InvalidInput("degree", "expected 1 to 10, found " + std::to_string(options.degree));
  }
  if (options.coefficients < options.degree + 1 || options.coefficients > 10000) {
    throw InvalidInput("coefficients", "expected " + std::to_string(options.degree + 1) + " to 10000, found " +
                                           std::to_string(options.coefficients));
  }
}

}  // namespace

std::size_t fit_samples(const FitOptions& options) {
  return std::max(least_samples, static_cast<std::size_t>(options.samples_per_piece) *
                                     static_cast<std::size_t>(options.coefficients - options.degree));
}

KnotList<double> mapping_knots(int degree, const std::vector<double>& breaks) {
  std::vector<double> knots(static_cast<std::size_t>(degree), breaks.front());
  knots.insert(knots.end(), breaks.begin() + 1, breaks.end() - 1);
  knots.insert(knots.end(), static_cast<std::size_t>(degree), breaks.back());
  return {degree, std::move(knots)};
}

Fit fit_rails(const Rails& rails, const FitOptions& options) {
  require(options);
  const auto value_of = [&](const Mapping<double>& sigma) {
    return measure_at(rails, sigma, options, options.kind, between);
  };
  Fit fit = fit_without_folds(rails, options);
  const double sampled = fit.value;
  fit.value = value_of(fit.mapping);
  fit.initial = value_of(identity_mapping(fit.mapping.knots));
  if (fit.value <= missed * sampled + rounding && fit.value <= fit.initial) return fit;

  FitOptions fine = options;
  fine.samples_per_piece *= finer;
  Fit other = fit_without_folds(rails, fine);
  other.value = value_of(other.mapping);
  other.initial = fit.initial;
  other.seconds += fit.seconds;
  if (other.value < fit.value) fit = std::move(other);
  if (fit.value > fit.initial) {
    fit.mapping = identity_mapping(fit.mapping.knots);
    fit.value = fit.initial;
  }
  return fit;
}

}  // namespace torse::quasi
