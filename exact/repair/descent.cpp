// Steps with Marquardt's damping: the diagonal of the curvature, so that units do not matter.
#include "torse/exact/repair/descent.hpp"

#include <algorithm>
#include <utility>

namespace torse::repair {
namespace {

/// Divides the constants of each group by the largest and returns the indices of these.
std::vector<std::size_t> normalise(std::vector<Real>& theta, std::size_t group) {
  std::vector<std::size_t> fixed;
  for (std::size_t first = 0; first < theta.size(); first += group) {
    std::size_t largest = first;
    for (std::size_t m = first; m < first + group; ++m) {
      if (magnitude(theta[m]) > magnitude(theta[largest])) largest = m;
    }
    const Real divisor = theta[largest];
    for (std::size_t m = first; m < first + group; ++m) theta[m] /= divisor;
    fixed.push_back(largest);
  }
  return fixed;
}

/// The step of all constants but the fixed one.
template <int D>
std::optional<std::vector<Real>> damped_step(const Projection<D>& at, const std::vector<std::size_t>& fixed,
                                             const Real& damping) {
  Matrix a = at.curvature;
  std::vector<Real> b;
  for (std::size_t m = 0; m < a.size(); ++m) {
    b.push_back(-at.slope[m]);
    a[m][m] *= Real(1) + damping;
    if (a[m][m] == Real(0)) a[m][m] = Real(1);  // without influence
  }
  for (const std::size_t one : fixed) {
    for (std::size_t m = 0; m < a.size(); ++m) a[one][m] = a[m][one] = Real(0);
    a[one][one] = Real(1);
    b[one] = Real(0);
  }
  return solve_positive(std::move(a), std::move(b));
}

}  // namespace

Real negligible_distance() { return Real::from_rational(power_of_two(20 - 2 * Real::precision)); }

template <int D>
std::optional<Descent<D>> descend(const Projector<D>& projector, std::vector<Real> theta, std::size_t group,
                                  const Real& rival) {
  constexpr int most_steps = 100;
  constexpr int first_steps = 10;
  const Real little = Real::from_rational(power_of_two(-20));
  const Real factor(16);
  const Real most_damping = Real::from_rational(power_of_two(60));
  Real damping = Real::from_rational(power_of_two(-20));

  Descent<D> descent;
  descent.fixed = normalise(theta, group);
  auto start = projector(theta);
  if (!start) return std::nullopt;
  descent.theta = std::move(theta);
  descent.nearest = std::move(*start);
  for (int step = 0; step < most_steps && !descent.converged; ++step) {
    if (descent.nearest.squared <= negligible_distance()) descent.converged = true;
    if (step >= first_steps && little * descent.nearest.squared > rival) break;
    const auto change = damped_step<D>(descent.nearest, descent.fixed, damping);
    if (change) {
      Real expected;  // a bound of what the step gains on the quadratic model
      std::vector<Real> moved = descent.theta;
      for (std::size_t m = 0; m < moved.size(); ++m) {
        expected -= Real(2) * descent.nearest.slope[m] * (*change)[m];
        moved[m] += (*change)[m];
      }
      if (damping <= Real(1) && expected <= little * descent.nearest.squared) descent.converged = true;
      std::vector<std::size_t> fixed = normalise(moved, group);
      auto trial = projector(moved);
      if (trial && trial->squared < descent.nearest.squared) {
        descent.theta = std::move(moved);
        descent.fixed = std::move(fixed);
        descent.nearest = std::move(*trial);
        damping /= factor;
        continue;
      }
    }
    if (damping > most_damping) break;
    damping *= factor;
  }
  return descent;
}

template std::optional<Descent<3>> descend<3>(const Projector<3>&, std::vector<Real>, std::size_t, const Real&);
template std::optional<Descent<4>> descend<4>(const Projector<4>&, std::vector<Real>, std::size_t, const Real&);

}  // namespace torse::repair
