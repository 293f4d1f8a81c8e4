// A surface with its knots, and the quotients that its warp angles are bounded by.
//   Surface, converted      knots and both rows over one scalar type; the same over another
//   sine_forms_of           sin^2 of the warp angle on a piece
//   sine_degree             of that quotient
//   quotient_of             the quotient in Bernstein form
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "torse/developable/warp.hpp"
#include "torse/exact/warp/quotient.hpp"

namespace torse {

/// A surface over S: D = 3 points, D = 4 homogeneous rows.
template <class S, int D>
struct Surface {
  KnotList<S> knots;
  std::vector<Vec<S, D>> c;
  std::vector<Vec<S, D>> d;
};

/// The same surface over T, each number by `convert`.
template <class T, class S, int D, class Convert>
Surface<T, D> converted(const KnotList<S>& u, std::span<const Vec<S, D>> c, std::span<const Vec<S, D>> d,
                        Convert convert) {
  const auto row = [&](std::span<const Vec<S, D>> from) {
    std::vector<Vec<T, D>> to;
    for (const Vec<S, D>& x : from) {
      Vec<T, D> y;
      for (int j = 0; j < D; ++j) y[j] = convert(x[j]);
      to.push_back(std::move(y));
    }
    return to;
  };
  std::vector<T> knots;
  for (const S& x : u.list()) knots.push_back(convert(x));
  return {KnotList<T>(u.degree(), std::move(knots)), row(c), row(d)};
}

/// sin^2 of the warp angle on piece k, see developable/warp.hpp.
template <class S, int D>
SineForms<S> sine_forms_of(const Surface<S, D>& surface, int k) {
  return sine_forms(ruling_forms<S>(surface.knots, surface.c, surface.d, k));
}

/// The degree of sine_forms for rows of degree n: |w|^2 [a, w, b]^2 has 2n + 2 (3n - 2) of directions of degree
/// n-1, n, n-1, and 4n + 2 (6n - 4) of 2n-2, 2n, 2n-2 with weights.
template <int D>
constexpr int sine_degree(int n) {
  return (D == 3 ? 1 : 2) * (8 * n - 4);
}

/// The quotient of two forms, whose degrees are equal.
template <class S>
BernsteinQuotient<S> quotient_of(const SineForms<S>& forms) {
  return {Bernstein<S>::from_form(forms.numerator), Bernstein<S>::from_form(forms.denominator)};
}

}  // namespace torse
