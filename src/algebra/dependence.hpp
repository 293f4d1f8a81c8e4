// Coplanarity and parallelism as lists of scalars that must all vanish, for every kind of point.
//   dependence_residual       four points of a plane
//   proportional_residual     two parallel vectors
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "torse/algebra/determinant.hpp"
#include "torse/algebra/free_module.hpp"
#include "torse/scalar/errors.hpp"

namespace torse {

/// One entry: [p1 - p0, p2 - p0, p3 - p0], zero iff the four affine points lie in a plane.
template <class S>
std::vector<S> dependence_residual(const std::array<Vec<S, 3>, 4>& p) {
  return {det3<S>(difference(p[1], p[0]), difference(p[2], p[0]), difference(p[3], p[0]))};
}

/// One entry: the determinant of the four homogeneous rows, zero iff they are dependent.
template <class S>
std::vector<S> dependence_residual(const std::array<Vec<S, 4>, 4>& p) {
  return {det4<S>(p[0], p[1], p[2], p[3])};
}

namespace detail {

/// How costly it is to divide by x.
template <class S>
long long pivot_weight(const S& x) {
  if constexpr (requires { ScalarTraits<S>::weight(x); }) {
    return static_cast<long long>(ScalarTraits<S>::weight(x));
  } else {
    return 0;
  }
}

struct Pivot {
  std::size_t row;
  int generator;
};

/// The certainly nonzero coefficient with the fewest others in its column, the lightest of these; none where all
/// coefficients are known to be zero. Few entries below the pivot keep the rows sparse and the fractions small: for the
/// condition of FJ07.13 at n = 5 the count makes the elimination 200 times faster than the weight alone.
template <class S>
std::optional<Pivot> find_pivot(std::span<const Form<S>> rows) {
  std::map<int, long long> column_size;
  for (const Form<S>& row : rows) {
    for (const auto& term : row.terms()) ++column_size[term.generator];
  }
  std::optional<Pivot> best;
  std::pair<long long, long long> best_cost;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (const auto& term : rows[row].terms()) {
      if (possibly(is_zero(term.coefficient))) continue;
      const std::pair cost(column_size[term.generator], pivot_weight(term.coefficient));
      if (!best || cost < best_cost) {
        best = Pivot{row, term.generator};
        best_cost = cost;
      }
    }
  }
  if (!best && !column_size.empty()) throw Undecided("no coefficient of the linear forms is certainly nonzero");
  return best;
}

template <class S>
std::vector<S> coefficients_or_zero(const Form<S>& form) {
  std::vector<S> result;
  for (const auto& term : form.terms()) result.push_back(term.coefficient);
  if (result.empty()) result.push_back(from_int<S>(0));
  return result;
}

}  // namespace detail

/// The coefficients left in the fourth form by Gaussian elimination with the other three; all of them vanish iff the
/// forms are dependent. Where some form has a nonzero sum of coefficients, as points have, that is the case iff the
/// four points are coplanar for every choice of the generators in R^3. Throws Undecided where a pivot is needed and no
/// coefficient is certainly nonzero.
template <class S>
std::vector<S> dependence_residual(std::array<Form<S>, 4> rows) {
  for (std::size_t step = 0; step + 1 < rows.size(); ++step) {
    const std::optional<detail::Pivot> pivot = detail::find_pivot<S>(std::span(rows).subspan(step));
    if (!pivot) return {from_int<S>(0)};
    std::swap(rows[step], rows[step + pivot->row]);
    const S divisor = rows[step].extract(pivot->generator);
    for (std::size_t row = step + 1; row < rows.size(); ++row) {
      const S entry = rows[row].extract(pivot->generator);
      if (!definitely(is_zero(entry))) add_scaled(rows[row], -(entry / divisor), rows[step]);
    }
  }
  return detail::coefficients_or_zero(rows.back());
}

/// The 2x2 minors p_i q_j - p_j q_i, i < j; all of them vanish iff p and q are parallel (or one of them is zero).
template <class S, int D>
requires(D >= 2) std::vector<S> proportional_residual(const Vec<S, D>& p, const Vec<S, D>& q) {
  std::vector<S> minors;
  for (int i = 0; i < D; ++i) {
    for (int j = i + 1; j < D; ++j) minors.push_back(det2<S>(p[i], p[j], q[i], q[j]));
  }
  return minors;
}

/// The coefficients of p_g q - q_g p for a generator g at which p is certainly nonzero; all of them vanish iff p and q
/// are parallel (or one of them is zero). Throws Undecided where p is not known to be zero and no coefficient of it is
/// certainly nonzero.
template <class S>
std::vector<S> proportional_residual(const Form<S>& p, const Form<S>& q) {
  const std::optional<detail::Pivot> pivot = detail::find_pivot<S>(std::span(&p, 1));
  if (!pivot) return {from_int<S>(0)};
  Form<S> rest = p;
  Form<S> other = q;
  const S p_g = rest.extract(pivot->generator);
  const S q_g = other.extract(pivot->generator);
  scale(other, p_g);
  add_scaled(other, -q_g, rest);
  return detail::coefficients_or_zero(other);
}

}  // namespace torse
