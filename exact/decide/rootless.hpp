// Descartes' rule of signs on an interval: the quick answer before roots are isolated.
//   surely_rootless
#pragma once

#include <algorithm>
#include <vector>

#include "torse/algebra/bernstein.hpp"
#include "torse/algebra/polynomial.hpp"
#include "torse/exact/rational/rational.hpp"

namespace torse {

/// Whether the Bernstein coefficients over [a, b] are all positive or all negative: by Descartes' rule there is no
/// root in [a, b]. False for the zero polynomial.
///
/// With t = a + (b-a) s and the polynomial sum_j f_j s^j of degree m, f_j / C(m, j) is the j-th difference of the first
/// Bernstein coefficient; the others follow by additions.
inline bool surely_rootless(const Polynomial<Rational>& f, const Rational& a, const Rational& b) {
  if (f.zero()) return false;
  std::vector<Rational> values = f.compose(Polynomial<Rational>(std::vector<Rational>{a, b - a})).coefficients();
  const std::vector<Rational> weights = binomials<Rational>(f.degree());
  values.resize(weights.size());
  for (std::size_t j = 0; j < values.size(); ++j) values[j] /= weights[j];
  const Rational factor = ScalarTraits<Rational>::common_denominator(values);  // sums of integers need no reduction
  for (Rational& x : values) x *= factor;
  for (std::size_t j = 1; j < values.size(); ++j) {
    for (std::size_t i = values.size() - 1; i >= j; --i) values[i] += values[i - 1];
  }
  const int sign = values.front().sign();
  return sign != 0 && std::ranges::all_of(values, [&](const Rational& x) { return x.sign() == sign; });
}

}  // namespace torse
