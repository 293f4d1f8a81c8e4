#include "torse/quasi/descent.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "torse/quasi/loss.hpp"

namespace torse::quasi {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The share of the Gauss-Newton term that a sample keeps where its loss is concave.
constexpr double least_curvature = 0.05;

/// A stage ends where a step lowers the sum by less than this part of it, the descent where a stage does so.
constexpr double enough = 1e-4;

/// Damping at the start of a stage, and its factors after a step that lowers the sum and after one that does not.
constexpr double first_damping = 1e-3;
constexpr double relief = 0.2;
constexpr double tightening = 16;
constexpr double least_damping = 1e-12;
constexpr int most_trials = 12;

/// Angles below this are rounding errors.
constexpr double least_angle = 1e-15;

/// Lower measures may be nothing but rounding errors, which no descent leaves for good: an angle takes some 500
/// operations, and rulings and tangents are an eighth of the rails' size or so.
constexpr double rounding_angle = 0x1p-53 * 500 * 8;

/// The measure of angles.
double measure_of(const std::vector<Taylor<double>>& angles, Measure measure) {
  double total = 0;
  for (const Taylor<double>& angle : angles) {
    const double size = std::abs(angle.value);
    if (measure == Measure::max) {
      total = std::max(total, size);
    } else {
      total += measure == Measure::mean ? size : size * size;
    }
  }
  if (measure == Measure::max) return total;
  total /= static_cast<double>(angles.size());
  return measure == Measure::mean ? total : std::sqrt(total);
}

class Descender {
 public:
  Descender(const Rail& d, const Sampling& samples, std::vector<double> beta, const DescentOptions& options)
      : d_(d),
        samples_(samples),
        options_(options),
        model_(beta.size(), width(), options.ends),
        hessian_(beta.size(), width()),
        gradient_(beta.size()),
        move_(beta.size()),
        product_(beta.size()),
        angles_(samples.size()),
        trial_angles_(samples.size()) {
    result_.beta = std::move(beta);
    angles_at(result_.beta, angles_);
    result_.value = best_ = measure_of(angles_, options.measure);
    best_beta_ = result_.beta;
  }

  Descent run() {
    Loss loss{options_.measure, options_.measure == Measure::mean ? best_ : std::max(best_, least_angle), 2,
              options_.cap};
    for (int stage = 0; stage < options_.stages && best_ > least_angle && loss.scale > least_angle; ++stage) {
      const double before = best_;
      descend_stage(loss);
      result_.converged = before - best_ <= enough * before && stage > 0;
      if (result_.converged && sharp(loss)) break;
      sharpen(loss, stage);
    }
    result_.converged = result_.converged || best_ <= rounding_angle;
    result_.beta = best_beta_;
    result_.value = best_;
    return std::move(result_);
  }

 private:
  std::size_t width() const { return static_cast<std::size_t>(samples_.degree()); }

  void angles_at(const std::vector<double>& beta, std::vector<Taylor<double>>& angles) {
    ++result_.evaluations;
    for (std::size_t r = 0; r < samples_.size(); ++r) {
      angles[r] = ruling_angle(samples_.jet(r), d_(samples_.value(beta, r)), options_.kind).angle;
    }
  }

  static double total(const Loss& loss, const std::vector<Taylor<double>>& angles) {
    double sum = 0;
    for (const Taylor<double>& angle : angles) sum += loss(angle.value).value;
    return std::isfinite(sum) ? sum : infinity;
  }

  /// Whether the loss is as near to the measure as it gets, or as matters.
  bool sharp(const Loss& loss) const {
    if (options_.measure == Measure::mean) return loss.scale < 0.01 * best_;
    return options_.measure == Measure::rms || loss.power >= most_power;
  }

  void sharpen(Loss& loss, int stage) const {
    if (options_.measure == Measure::mean) {
      loss.scale = std::max(measure_of(angles_, Measure::mean) * std::pow(0.3, std::min(stage + 1, 6)), least_angle);
    } else if (options_.measure == Measure::max) {
      loss.scale = std::max(measure_of(angles_, Measure::max), least_angle);
      loss.power = std::min(loss.power * 2, most_power);
    }
  }

  /// Gradient and Hessian of the sum of losses by the coefficients.
  void build_model(const Loss& loss) {
    std::ranges::fill(gradient_, 0);
    hessian_.clear(gradient_.size());
    for (std::size_t r = 0; r < samples_.size(); ++r) {
      const Taylor<double>& angle = angles_[r];
      const Taylor<double> cost = loss(angle.value);
      const double slope = cost.first * angle.first;
      const double square = angle.first * angle.first;
      const double secant = angle.value != 0 ? cost.first / angle.value : cost.second;
      const double curvature =
          std::max(cost.second * square + cost.first * angle.second, least_curvature * secant * square);
      if (!std::isfinite(slope) || !std::isfinite(curvature)) continue;
      const std::span<const double> basis = samples_.basis(r);
      const std::size_t first = samples_.first(r);
      for (std::size_t i = 0; i < basis.size(); ++i) {
        gradient_[first + i] += slope * basis[i];
        for (std::size_t j = i; j < basis.size(); ++j) {
          hessian_.at(first + i, j - i) += curvature * basis[i] * basis[j];
        }
      }
    }
  }

  /// How much the model, without its damping, promises to lower the sum by the trial.
  double promised() {
    double slope = 0;
    double curvature = 0;
    for (std::size_t i = 0; i < trial_.size(); ++i) move_[i] = trial_[i] - result_.beta[i];
    hessian_.multiply(move_, product_);
    for (std::size_t i = 0; i < trial_.size(); ++i) {
      slope -= gradient_[i] * move_[i];
      curvature += move_[i] * product_[i];
    }
    return slope - curvature / 2;
  }

  void descend_stage(const Loss& loss) {
    double damping = first_damping;
    double sum = total(loss, angles_);
    for (int step = 0; step < options_.steps_per_stage; ++step) {
      build_model(loss);
      double lower = sum;
      for (int trial = 0; trial < most_trials; ++trial) {
        trial_ = model_.minimize(hessian_.damped(damping), gradient_, result_.beta);
        if (promised() <= enough * sum) return;
        angles_at(trial_, trial_angles_);
        lower = total(loss, trial_angles_);
        if (lower < sum) break;
        damping = std::max(damping * tightening, 1e-6);
      }
      if (!(lower < sum)) return;
      damping = std::max(damping * relief, least_damping);
      result_.beta.swap(trial_);
      angles_.swap(trial_angles_);
      keep_best();
      const double drop = sum - lower;
      sum = lower;
      if (drop <= enough * sum) return;
    }
  }

  void keep_best() {
    const double value = measure_of(angles_, options_.measure);
    const bool allowed = measure_of(angles_, Measure::max) <= options_.cap;
    if (value < best_ && allowed) {
      best_ = value;
      best_beta_ = result_.beta;
    }
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    result_.steps.push_back({value, elapsed.count()});
  }

  const Rail& d_;
  const Sampling& samples_;
  DescentOptions options_;
  MonotoneModel model_;
  BandedMatrix hessian_;
  std::vector<double> gradient_;
  std::vector<double> move_;
  std::vector<double> product_;  // of the Hessian with the move
  std::vector<Taylor<double>> angles_;
  std::vector<Taylor<double>> trial_angles_;
  std::vector<double> trial_;
  Descent result_;
  double best_ = infinity;
  std::vector<double> best_beta_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

Descent descend(const Rail& d, const Sampling& samples, std::vector<double> beta, const DescentOptions& options) {
  return Descender(d, samples, std::move(beta), options).run();
}

double measured(const Rail& d, const Sampling& samples, std::span<const double> beta, const DescentOptions& options) {
  std::vector<Taylor<double>> angles(samples.size());
  for (std::size_t r = 0; r < samples.size(); ++r) {
    angles[r] = ruling_angle(samples.jet(r), d(samples.value(beta, r)), options.kind).angle;
  }
  return measure_of(angles, options.measure);
}

}  // namespace torse::quasi
