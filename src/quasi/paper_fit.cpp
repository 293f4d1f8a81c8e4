#include "torse/quasi/paper_fit.hpp"

#include <LBFGS.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "torse/quasi/condition.hpp"
#include "torse/quasi/sampling.hpp"

namespace torse::quasi {
namespace {

using Variables = Eigen::VectorXd;

/// The step of the central differences that check the gradient: the cube root of 2^-52.
constexpr double difference_step = 6e-6;

std::vector<double> with_both_ends(std::size_t count) {
  if (count < 2) throw InvalidInput("samples", "expected at least 2, found " + std::to_string(count));
  std::vector<double> parameters;
  for (std::size_t i = 0; i < count; ++i) {
    parameters.push_back(static_cast<double>(i) / static_cast<double>(count - 1));
  }
  return parameters;
}

/// The unit normal for which E2 is least: an eigenvector of the smallest eigenvalue of its matrix.
Vector best_normal(const RailJet& c, const RailJet& d) {
  const Vector ruling = c.point - d.point;
  const Eigen::Matrix3d energy =
      c.first * c.first.transpose() + d.first * d.first.transpose() + ruling * ruling.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(energy);
  return solver.eigenvectors().col(0);
}

/// BZZ19.9 as a function of the steps eps_0..eps_n, then the coordinates of the normals.
class Objective {
 public:
  Objective(const Rails& rails, const Sampling& samples, std::size_t count, const PaperOptions& options)
      : rails_(rails),
        samples_(samples),
        options_(options),
        count_(static_cast<Eigen::Index>(count)),
        ends_{rails.d(0).point, rails.d(1).point} {}

  /// sigma(t) = beta with the best normals.
  Variables start(const std::vector<double>& beta) const {
    Variables x(count_ + 3 * static_cast<Eigen::Index>(samples_.size()));
    double before = 0;
    for (Eigen::Index i = 0; i < count_; ++i) {
      const double here = beta[static_cast<std::size_t>(i)];
      x[i] = std::sqrt(std::max(0.0, here - before));
      before = here;
    }
    for (std::size_t r = 0; r < samples_.size(); ++r) {
      x.segment<3>(normal_at(r)) = best_normal(samples_.jet(r), rails_.d(samples_.value(beta, r)));
    }
    return x;
  }

  double operator()(const Variables& x, Variables& gradient) {
    ++evaluations;
    const std::vector<double> beta = coefficients_at(x);
    std::vector<double> by_beta(beta.size(), 0);
    double total = 0;
    for (std::size_t r = 0; r < samples_.size(); ++r) {
      const RailJet& c = samples_.jet(r);
      const RailJet d = rails_.d(samples_.value(beta, r));
      const Vector normal = x.segment<3>(normal_at(r));
      const Vector ruling = c.point - d.point;
      const NormalProducts<double> products = normal_products<double>(normal, ruling, c.first, d.first);
      total += options_.energy_weight * normal_residual<double>(products) +
               options_.normal_weight * unit_penalty<double>(normal);
      gradient.segment<3>(normal_at(r)) =
          2 * options_.energy_weight *
              (products.with_a * c.first + products.with_b * d.first + products.with_w * ruling) +
          4 * options_.normal_weight * (normal.squaredNorm() - 1) * normal;
      const double by_parameter =
          2 * options_.energy_weight * (products.with_b * normal.dot(d.second) - products.with_w * normal.dot(d.first));
      const std::span<const double> basis = samples_.basis(r);
      for (std::size_t i = 0; i < basis.size(); ++i) by_beta[samples_.first(r) + i] += by_parameter * basis[i];
    }
    if (options_.ends == Ends::fixed) total += end_terms(beta, by_beta);
    double sum = 0;
    for (Eigen::Index i = count_; i-- > 0;) {
      sum += by_beta[static_cast<std::size_t>(i)];
      gradient[i] = 2 * x[i] * sum;
    }
    note(x, total);
    return total;
  }

  std::vector<double> coefficients_at(const Variables& x) const {
    return coefficients_from_steps<double>({x.data(), static_cast<std::size_t>(count_)});
  }

  int evaluations = 0;
  double least = std::numeric_limits<double>::infinity();
  Variables best;
  std::vector<PaperStep> curve;

 private:
  Eigen::Index normal_at(std::size_t r) const { return count_ + 3 * static_cast<Eigen::Index>(r); }

  double end_terms(const std::vector<double>& beta, std::vector<double>& by_beta) const {
    double total = 0;
    const std::array<std::size_t, 2> places{0, beta.size() - 1};
    for (std::size_t end = 0; end < 2; ++end) {
      const RailJet d = rails_.d(beta[places[end]]);
      const Vector off = d.point - ends_[end];
      total += options_.end_weight * off.squaredNorm();
      by_beta[places[end]] += 2 * options_.end_weight * off.dot(d.first);
    }
    return total;
  }

  void note(const Variables& x, double total) {
    if (!std::isfinite(total) || !(total < least)) return;
    least = total;
    best = x;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    curve.push_back({total, elapsed.count()});
  }

  const Rails& rails_;
  const Sampling& samples_;
  const PaperOptions& options_;
  Eigen::Index count_;
  std::array<Vector, 2> ends_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// The largest difference of the gradient from central differences, relative to its largest entry, at a point near x:
/// each variable is changed by up to a hundredth of it, since at T = t the samples may lie on knots of the second rail,
/// where the objective has no second derivative.
double gradient_error(Objective objective, Variables x) {
  for (Eigen::Index i = 0; i < x.size(); ++i) x[i] *= 1 + 0.01 * std::fmod(0.618034 * static_cast<double>(i), 1.0);
  Variables gradient(x.size());
  Variables unused(x.size());
  objective(x, gradient);
  double error = 0;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    Variables moved = x;
    moved[i] = x[i] + difference_step;
    const double above = objective(moved, unused);
    moved[i] = x[i] - difference_step;
    const double below = objective(moved, unused);
    error = std::max(error, std::abs((above - below) / (2 * difference_step) - gradient[i]));
  }
  return error / std::max(1.0, gradient.cwiseAbs().maxCoeff());
}

PaperFit minimize(Objective objective, const Variables& start, const PaperOptions& options) {
  LBFGSpp::LBFGSParam<double> parameters;
  parameters.epsilon = parameters.epsilon_rel = options.gradient;
  parameters.past = 10;
  parameters.delta = options.change;
  parameters.max_iterations = options.most_steps;
  parameters.max_linesearch = 40;
  parameters.linesearch = LBFGSpp::LBFGS_LINESEARCH_BACKTRACKING_STRONG_WOLFE;

  PaperFit fit;
  if (options.check_gradient) fit.gradient_error = gradient_error(objective, start);
  Variables x = start;
  double value = 0;
  try {
    fit.steps = LBFGSpp::LBFGSSolver<double>(parameters).minimize(objective, x, value);
    fit.converged = fit.steps < options.most_steps;
    fit.stop = fit.converged ? "the gradient or the change of the objective is small" : "the steps ran out";
  } catch (const std::exception& failure) {
    fit.steps = static_cast<int>(objective.curve.size());
    fit.stop = std::string("the line search failed: ") + failure.what();
  }
  if (objective.best.size() == 0) objective.best = start;
  fit.beta = objective.coefficients_at(objective.best);
  fit.objective = objective.least;
  fit.evaluations = objective.evaluations;
  fit.curve = std::move(objective.curve);
  return fit;
}

PaperFit fit_over(const Rails& rails, const KnotList<double>& knots, const PaperOptions& options) {
  const Sampling samples(rails.c, knots, with_both_ends(options.samples));
  const Mapping<double> identity = identity_mapping(knots);
  const Objective objective(rails, samples, identity.control.size(), options);
  return minimize(objective, objective.start(coefficients(identity)), options);
}

}  // namespace

PaperFit paper_fit(const Rails& rails, const KnotList<double>& knots, const PaperOptions& options) {
  return fit_over(rails, knots, options);
}

PaperFit discrete_fit(const Rails& rails, const PaperOptions& options) {
  return fit_over(rails, KnotList<double>(1, with_both_ends(options.samples)), options);
}

}  // namespace torse::quasi
