// Moebius reparametrisation t = u / ((1-b) u + b) of a rational Bezier piece on [0, 1], FJ21.5.1-2.
//   moebius_parameter    5.1, t(u)
//   moebius_rows         rows times b^{n-i}: the same curves in the parameter u
//   moebius_functions    5.2, Lam~, M~, sigma~ at u from Lam, M, sigma at t(u)
#pragma once

#include <utility>
#include <vector>

#include "torse/algebra/point.hpp"
#include "torse/developable/functions.hpp"

namespace torse {

/// t(u) = u / ((1-b) u + b) (FJ21.5.1); maps [0, 1] onto itself for b > 0.
template <Field S>
S moebius_parameter(const S& b, const S& u) {
  return u / ((from_int<S>(1) - b) * u + b);
}

/// The homogeneous Bezier rows of the reparametrised curve, b^{n-i} p_i (FJ21.5.2).
template <Field S, Point<S> P>
std::vector<P> moebius_rows(std::vector<P> rows, const S& b) {
  S power = from_int<S>(1);
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    scale(*row, power);
    power *= b;
  }
  return rows;
}

/// Lam~ = b Lam / (1+(b-1) Lam), M~ = b M / (1+(b-1) M), sigma~ = sigma (1+(b-1) M) / (1+(b-1) Lam) (FJ21.5.2). Throws
/// DivisionByZero (exact fields) where Lam or M is sent to infinity.
template <Field S>
BlossomFunctions<S> moebius_functions(const BlossomFunctions<S>& f, const S& b) {
  const S one = from_int<S>(1);
  const S at_lambda = one + (b - one) * f.lambda;
  const S at_m = one + (b - one) * f.m;
  return {b * f.lambda / at_lambda, b * f.m / at_m, f.sigma * at_m / at_lambda};
}

}  // namespace torse
