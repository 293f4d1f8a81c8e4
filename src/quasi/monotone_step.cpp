#include "torse/quasi/monotone_step.hpp"

#include <algorithm>
#include <cmath>

namespace torse::quasi {
namespace {

/// Changes of the active set per call. It settles after a few; a cycle costs no more than this.
constexpr int most_rounds = 30;

}  // namespace

BandedMatrix BandedMatrix::damped(double damping) const {
  BandedMatrix h = *this;
  const std::span<double> diagonal = std::span(h.entries_).first(size_);
  const double largest = std::ranges::max(diagonal);
  for (double& x : diagonal) x += damping * (x + 1e-6 * largest) + 1e-12 * largest;
  return h;
}

void BandedMatrix::multiply(std::span<const double> x, std::span<double> y) const {
  for (std::size_t i = 0; i < size_; ++i) {
    double total = at(i, 0) * x[i];
    for (std::size_t k = 1; k <= width_; ++k) {
      if (i + k < size_) total += at(i, k) * x[i + k];
      if (i >= k) total += at(i - k, k) * x[i - k];
    }
    y[i] = total;
  }
}

void BandedMatrix::solve(std::span<double> b) {
  for (std::size_t i = 0; i < size_; ++i) {
    const double inverse = 1 / at(i, 0);
    const std::size_t reach = std::min(width_, size_ - 1 - i);
    for (std::size_t k = 1; k <= reach; ++k) {
      const double factor = at(i, k) * inverse;
      for (std::size_t l = k; l <= reach; ++l) at(i + k, l - k) -= factor * at(i, l);
      b[i + k] -= factor * b[i];
    }
    for (std::size_t k = 1; k <= reach; ++k) at(i, k) *= inverse;
    b[i] *= inverse;
  }
  for (std::size_t i = size_; i-- > 0;) {
    for (std::size_t k = 1; k <= std::min(width_, size_ - 1 - i); ++k) b[i] -= at(i, k) * b[i + k];
  }
}

MonotoneModel::MonotoneModel(std::size_t size, std::size_t width, Ends ends)
    : ends_(ends), tied_(size + 1, 0), group_(size), reduced_(size, width), x_(size) {
  if (ends_ == Ends::fixed) tied_.front() = tied_.back() = 1;
}

/// Solves H x = target with the tied coefficients as one unknown each.
void MonotoneModel::solve_tied(const BandedMatrix& h, std::span<const double> target) {
  const std::size_t n = x_.size();
  std::size_t groups = 0;
  for (std::size_t i = 0; i < n; ++i) group_[i] = i > 0 && tied_[i] ? groups - 1 : groups++;
  reduced_.clear(groups);
  unknowns_.assign(groups, 0);
  for (std::size_t i = 0; i < n; ++i) {
    unknowns_[group_[i]] += target[i];
    reduced_.at(group_[i], 0) += h.at(i, 0);
    for (std::size_t k = 1; k <= h.width() && i + k < n; ++k) {
      const std::size_t apart = group_[i + k] - group_[i];
      reduced_.at(group_[i], apart) += (apart == 0 ? 2 : 1) * h.at(i, k);
    }
  }
  const std::size_t last = groups - 1;
  if (tied_[0]) {
    unknowns_[0] = 0;
    for (std::size_t k = 1; k <= std::min(h.width(), last); ++k) reduced_.at(0, k) = 0;
  }
  if (tied_[n]) {
    reduced_.at(last, 0) = 1;
    unknowns_[last] = 1;
    for (std::size_t k = 1; k <= std::min(h.width(), last); ++k) {
      unknowns_[last - k] -= reduced_.at(last - k, k);
      reduced_.at(last - k, k) = 0;
    }
  }
  reduced_.solve(unknowns_);
  for (std::size_t i = 0; i < n; ++i) x_[i] = unknowns_[group_[i]];
}

/// Releases the ties whose force pulls. With `force` = H x - target the force of the tie between x_{i-1} and x_i is the
/// sum over the coefficients of the group from i on, or minus the sum up to i - 1 where the group is held at 1.
bool MonotoneModel::untie(std::span<const double> force) {
  const std::size_t n = x_.size();
  const auto release = [&](std::size_t i) {
    const bool end = i == 0 || i == n;
    if (!tied_[i] || (end && ends_ == Ends::fixed)) return false;
    tied_[i] = 0;
    return true;
  };
  bool changed = false;
  for (std::size_t end = n; end > 0;) {
    std::size_t begin = end - 1;
    while (begin > 0 && tied_[begin]) --begin;
    double total = 0;
    if (end == n && tied_[n]) {
      for (std::size_t i = begin; i < end; ++i) {
        total -= force[i];
        if (total < 0) changed = release(i + 1) || changed;
      }
    } else {
      for (std::size_t i = end; i-- > begin;) {
        total += force[i];
        if (total < 0) changed = release(i) || changed;
      }
    }
    end = begin;
  }
  return changed;
}

/// Ties neighbours that are out of order.
bool MonotoneModel::tie() {
  const std::size_t n = x_.size();
  bool changed = false;
  const auto tie_at = [&](std::size_t i, bool out_of_order) {
    if (tied_[i] || !out_of_order) return;
    tied_[i] = 1;
    changed = true;
  };
  tie_at(0, x_[0] < 0);
  for (std::size_t i = 1; i < n; ++i) tie_at(i, group_[i] != group_[i - 1] && x_[i] < x_[i - 1]);
  tie_at(n, x_[n - 1] > 1);
  return changed;
}

std::vector<double> MonotoneModel::minimize(const BandedMatrix& h, std::span<const double> g,
                                            std::span<const double> b) {
  const std::size_t n = x_.size();
  std::vector<double> target(n);
  std::vector<double> force(n);
  h.multiply(b, target);
  for (std::size_t i = 0; i < n; ++i) target[i] -= g[i];
  for (int round = 0; round < most_rounds; ++round) {
    solve_tied(h, target);
    h.multiply(x_, force);
    for (std::size_t i = 0; i < n; ++i) force[i] -= target[i];
    const bool released = untie(force);
    if (!tie() && !released) break;
  }
  if (!std::ranges::all_of(x_, [](double x) { return std::isfinite(x); })) return {b.begin(), b.end()};
  double least = 0;
  for (double& x : x_) least = x = std::clamp(x, least, 1.0);
  return x_;
}

}  // namespace torse::quasi
