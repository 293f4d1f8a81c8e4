#include "torse/studies/bound.hpp"

#include <cstddef>

#include "torse/algebra/point.hpp"
#include "torse/scalar/errors.hpp"

namespace torse::studies {
namespace {

using Q = Rational;

Q magnitude(const Q& x) { return x.sign() < 0 ? -x : x; }

/// One term of the unrolled recursion in one coordinate, and how many cells it has passed.
struct Term {
  Q size;
  int steps;
};

Q weighed(const std::vector<Term>& terms, int precision) {
  Q total;
  for (const Term& term : terms) total += gamma(5 * term.steps + 1, precision) * term.size;
  return total;
}

}  // namespace

Q gamma(int k, int precision) {
  Q unit(1);
  for (int i = 0; i < precision; ++i) unit /= Q(2);
  const Q share = Q(k) * unit;
  if (!(share < Q(1))) throw InvalidInput("precision", "too low for so many operations");
  return share / (Q(1) - share);
}

std::vector<Q> rulings_bound(const Inputs<Q>& in, const std::vector<Q>& d, int k, const Vec<Q, 3>& dk, int precision) {
  const int n = in.u.degree();
  const Q unit = gamma(1, precision) / (Q(1) + gamma(1, precision));
  const Q gap = magnitude(in.lambda - in.m);
  std::vector<Q> bounds(d.size());
  const auto walk = [&](int j, int step) {
    const std::size_t coordinate = static_cast<std::size_t>(j);
    std::vector<Term> terms{{magnitude(dk[j] - in.c[static_cast<std::size_t>(k)][j]), 0}};
    const int end = step > 0 ? in.u.last() : 0;
    for (int i = k; i != end; i += step) {
      const int cell = step > 0 ? i : i - 1;
      const Q at_start = magnitude(in.m - in.u[cell]);
      const Q at_end = magnitude(in.m - in.u[cell + n]);
      const Q& near = step > 0 ? at_end : at_start;
      const Q& far = step > 0 ? at_start : at_end;
      for (Term& term : terms) {
        term.size *= near / far;
        ++term.steps;
      }
      const std::size_t at = static_cast<std::size_t>(cell);
      terms.push_back({gap * magnitude(in.c[at + 1][j] - in.c[at][j]) / far, 1});
      const std::size_t vertex = 3 * static_cast<std::size_t>(i + step) + coordinate;
      bounds[vertex] = unit * magnitude(d[vertex]) + (Q(1) + unit) * weighed(terms, precision);
    }
  };
  for (int j = 0; j < 3; ++j) {
    walk(j, 1);
    walk(j, -1);
  }
  return bounds;
}

}  // namespace torse::studies
