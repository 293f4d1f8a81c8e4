// Descartes' rule of signs on an interval: the quick answer before roots are isolated.
//   surely_rootless
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "torse/exact/rational/rational.hpp"
#include "torse/spline/piece_polynomials.hpp"

namespace torse {

/// Whether the Bernstein coefficients over [a, b] are all positive or all negative: by Descartes' rule there is no
/// root in [a, b]. False for the zero polynomial.
inline bool surely_rootless(const Polynomial<Rational>& f, const Rational& a, const Rational& b) {
  if (f.zero()) return false;
  const std::vector<Vec<Rational, 1>> coefficients =
      bezier_rows(std::array<Polynomial<Rational>, 1>{f}, f.degree(), a, b);
  const int sign = coefficients.front()[0].sign();
  return sign != 0 && std::ranges::all_of(coefficients, [&](const Vec<Rational, 1>& x) { return x[0].sign() == sign; });
}

}  // namespace torse
