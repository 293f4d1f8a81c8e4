// B-spline basis functions by Cox-de Boor, as polynomials of a piece: the second path to a curve, independent of
// blossoms.
//   basis_forms      the n + 1 basis functions of piece k as homogeneous polynomials in (s, t), s + t = 1 over the
//   piece piece_forms      a curve's coordinates on piece k in the same form
#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "torse/algebra/binary_form.hpp"
#include "torse/algebra/point.hpp"
#include "torse/spline/knots.hpp"

namespace torse {

/// The basis functions N_{k-1}, ..., N_{k+n-1} (degree n) on piece k = [a, b] as forms of degree n in (s, t), where the
/// parameter is a s + b t: the recursion of Cox and de Boor with the linear forms u_hi - x and x - u_lo. The piece must
/// not be empty.
template <Field S>
std::vector<BinaryForm<S>> basis_forms(const KnotList<S>& u, int k) {
  const int n = u.degree();
  const int m = n + k - 2;  // the piece is [u_m, u_{m+1}]
  const S& a = u.piece_begin(k);
  const S& b = u.piece_end(k);
  const auto from = [&](const S& lo) { return BinaryForm<S>(std::vector<S>{a - lo, b - lo}); };
  const auto until = [&](const S& hi) { return BinaryForm<S>(std::vector<S>{hi - a, hi - b}); };
  std::vector<BinaryForm<S>> basis{BinaryForm<S>(std::vector<S>{from_int<S>(1)})};
  for (int r = 1; r <= n; ++r) {
    std::vector<BinaryForm<S>> next(static_cast<std::size_t>(r) + 1, BinaryForm<S>(r));
    for (int i = 0; i < r; ++i) {
      const S& lo = u[m + 1 + i - r];
      const S& hi = u[m + 1 + i];
      const BinaryForm<S> part = (from_int<S>(1) / (hi - lo)) * basis[static_cast<std::size_t>(i)];
      next[static_cast<std::size_t>(i)] += until(hi) * part;
      next[static_cast<std::size_t>(i) + 1] += from(lo) * part;
    }
    basis = std::move(next);
  }
  return basis;
}

/// The coordinates of sum_i N_i c_i on piece k as forms of degree n.
template <Field S, int D>
std::array<BinaryForm<S>, static_cast<std::size_t>(D)> piece_forms(const std::vector<BinaryForm<S>>& basis,
                                                                   std::span<const Vec<S, D>> c, int k) {
  const int n = basis.front().degree();
  std::array<BinaryForm<S>, static_cast<std::size_t>(D)> forms;
  forms.fill(BinaryForm<S>(n));
  for (int i = 0; i <= n; ++i) {
    const Vec<S, D>& point = c[static_cast<std::size_t>(k - 1 + i)];
    for (int j = 0; j < D; ++j) forms[static_cast<std::size_t>(j)] += point[j] * basis[static_cast<std::size_t>(i)];
  }
  return forms;
}

}  // namespace torse
