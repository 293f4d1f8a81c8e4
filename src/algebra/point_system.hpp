// Linear systems whose unknowns and right sides are points: one elimination for all coordinates.
//   TracedEquation<S, P>  a row with its right side and the given equations it comes from
//   Contradiction<S, P>   a combination of the equations that says 0 = a point that is not 0
//   PointSystem<S, P>     insert, contradiction, solution, kernel
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "torse/algebra/free_module.hpp"
#include "torse/algebra/linear_system.hpp"

namespace torse {

/// Whether a point is the zero vector.
template <Field S, int D>
Truth vanishes(const Vec<S, D>& x) {
  Truth all = Truth::yes;
  for (int i = 0; i < D; ++i) all = all & is_zero(S(x[i]));
  return all;
}

template <Field S>
Truth vanishes(const Form<S>& x) {
  Truth all = Truth::yes;
  for (const auto& term : x.terms()) all = all & is_zero(term.coefficient);
  return all;
}

/// sum_j left_j x_j = right, the combination `origin` of the given equations; generators count unknowns in `left` and
/// equations in `origin`, both from 0.
template <Field S, Point<S> P>
struct TracedEquation {
  Form<S> left;
  P right;
  Form<S> origin;
};

template <Field S, class P>
void add_scaled(TracedEquation<S, P>& y, const std::type_identity_t<S>& a, const TracedEquation<S, P>& x) {
  add_scaled(y.left, a, x.left);
  add_scaled(y.right, a, x.right);
  add_scaled(y.origin, a, x.origin);
}

template <Field S, class P>
void divide(TracedEquation<S, P>& y, const std::type_identity_t<S>& a) {
  divide(y.left, a);
  divide(y.right, a);
  divide(y.origin, a);
}

template <Field S, class P>
S entry_of(const TracedEquation<S, P>& equation, int j) {
  return equation.left.coefficient(j);
}

/// The last unknown with a coefficient that is not zero: the unknowns that stay free are the first ones.
template <Field S, class P>
std::optional<int> pivot_of(const TracedEquation<S, P>& equation) {
  const auto& terms = equation.left.terms();
  for (auto term = terms.rbegin(); term != terms.rend(); ++term) {
    if (!no_pivot(term->coefficient)) return term->generator;
  }
  return std::nullopt;
}

/// The combination of the given equations (generator i is the i-th, from 0) whose left side is 0 and whose right side
/// is `value`, which is not.
template <Field S, Point<S> P>
struct Contradiction {
  Form<S> combination;
  P value;
};

/// Equations sum_j left_j x_j = right for points x_0, ..., x_{m-1}.
template <Field S, Point<S> P>
class PointSystem {
 public:
  /// m unknowns.
  explicit PointSystem(int unknowns) : unknowns_(unknowns) {}

  /// Adds an equation whose left side has generators 0, ..., m-1. Throws Undecided where an entry that decides a pivot,
  /// or a right side without a left side, is neither zero nor not.
  void insert(Form<S> left, P right) {
    TracedEquation<S, P> equation{std::move(left), std::move(right), Form<S>::generator(count_++)};
    std::optional<TracedEquation<S, P>> rest = rows_.insert(std::move(equation));
    if (!rest || contradiction_) return;
    const Truth zero = vanishes(rest->right);
    if (zero == Truth::unknown) throw Undecided("linear system: a right side is neither zero nor not");
    if (!definitely(zero)) contradiction_ = Contradiction<S, P>{std::move(rest->origin), std::move(rest->right)};
  }

  /// The first contradiction, if the equations have no solution.
  const std::optional<Contradiction<S, P>>& contradiction() const { return contradiction_; }

  /// The solution whose free unknowns are zero. It means nothing where there is a contradiction.
  std::vector<P> solution() const {
    std::vector<P> x(static_cast<std::size_t>(unknowns_), PointTraits<P>::zero());
    for (const auto& known : rows_.kept()) x[static_cast<std::size_t>(known.pivot)] = known.row.right;
    return x;
  }

  /// A basis of the solutions of the homogeneous system in scalars, one for each free unknown: 1 there and 0 at the
  /// other free ones and at all unknowns before it.
  std::vector<std::vector<S>> kernel() const {
    std::vector<std::vector<S>> basis;
    for (int free = 0; free < unknowns_; ++free) {
      if (rows_.is_pivot(free)) continue;
      std::vector<S> x(static_cast<std::size_t>(unknowns_), from_int<S>(0));
      x[static_cast<std::size_t>(free)] = from_int<S>(1);
      for (const auto& known : rows_.kept()) x[static_cast<std::size_t>(known.pivot)] = -entry_of(known.row, free);
      basis.push_back(std::move(x));
    }
    return basis;
  }

 private:
  int unknowns_;
  int count_ = 0;
  RowEchelon<S, TracedEquation<S, P>> rows_;
  std::optional<Contradiction<S, P>> contradiction_;
};

}  // namespace torse
