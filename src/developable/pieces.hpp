// Developable splines piece by piece, FJ07.10-12 and 19: each Bezier piece obeys Aumann's relation with its own Lam_k,
// M_k.
//   local_parameter      Lam_k from L*              next_local      Lam_k from Lam_{k-1} (FJ07.10)
//   affine_from_local    (lam, mu) from (Lam, M)    next_affine     (lam_k, mu_k) from (lam_{k-1}, mu_{k-1}) (FJ07.11)
//   aumann_net           the Bezier row D from C, Lam, M, D_0 (FJ07.12)
//   piecewise_net        all pieces' rows from the curve c and D_0 of the first piece
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "torse/scalar/formula.hpp"
#include "torse/spline/insertion.hpp"

namespace torse {

/// X_k = (X* - u_{n+k-2}) / Du_{n+k-2}: the global parameter X* in the coordinate of piece k (FJ07.10).
template <Field S>
S local_parameter(const KnotList<S>& u, const S& x, int k) {
  return (x - u.piece_begin(k)) / (u.piece_end(k) - u.piece_begin(k));
}

/// X_k from X_{k-1} (FJ07.10): Du_{n+k-3} / Du_{n+k-2} (X_{k-1} - 1). Both pieces are proper.
template <Field S>
S next_local(const KnotList<S>& u, const S& previous, int k) {
  return (u.piece_end(k - 1) - u.piece_begin(k - 1)) / (u.piece_end(k) - u.piece_begin(k)) *
         (previous - from_int<S>(1));
}

/// Aumann's affine coefficients of one piece: D_{i+1} = (1-lam-mu) C_i + lam C_{i+1} + mu D_i.
template <Field S>
struct AffineCell {
  S lam;
  S mu;
};

/// lam = Lam/M, mu = 1 - 1/M (before FJ07.9). M is not zero.
template <Field S>
AffineCell<S> affine_from_local(const S& lambda, const S& m) {
  return {lambda / m, from_int<S>(1) - from_int<S>(1) / m};
}

/// (lam_k, mu_k) from (lam_{k-1}, mu_{k-1}) (FJ07.11); mu_{k-1} is not zero. Cylinders (lam = 1) and cones (mu = 1)
/// propagate.
template <Field S>
AffineCell<S> next_affine(const KnotList<S>& u, const AffineCell<S>& previous, int k) {
  const S one = from_int<S>(1);
  const S step = (u.piece_end(k) - u.piece_begin(k)) / (u.piece_end(k - 1) - u.piece_begin(k - 1));
  return {(previous.lam + previous.mu - one) / previous.mu, one + step * (one - one / previous.mu)};
}

/// The Bezier row D_0..D_n with (1-Lam) C_i + Lam C_{i+1} = (1-M) D_i + M D_{i+1} (FJ07.12). Throws InvalidInput naming
/// "M" if M is zero: the piece begins at M*.
template <Field S, class P>
std::vector<P> aumann_net(std::span<const P> c, const S& lambda, const S& m, const P& d0) {
  if (definitely(is_zero(m))) throw InvalidInput("M", "expected a value that is not 0, the start of the piece");
  const S one = from_int<S>(1);
  std::vector<P> d{d0};
  for (std::size_t i = 0; i + 1 < c.size(); ++i) {
    const FormulaScope<S> scope("FJ07.12", "D", static_cast<int>(i) + 1);
    P next = combine(one - lambda, c[i], lambda, c[i + 1]);
    add_scaled(next, m - one, d[i]);
    divide(next, m);
    d.push_back(std::move(next));
  }
  return d;
}

/// The Bezier rows of all proper pieces, in order, by FJ07.10 and 12: each piece starts where the one before ends.
/// `start` is D_0 of the first piece, the point d(u_{n-1}). Throws InvalidInput naming "M" if M* is the start of a
/// piece.
template <Field S, class P>
std::vector<std::vector<P>> piecewise_net(const KnotList<S>& u, std::span<const P> c, const S& lambda, const S& m,
                                          P start) {
  std::vector<std::vector<P>> rows;
  S lambda_k = from_int<S>(0);
  S m_k = from_int<S>(0);
  int before = 0;
  for (int k : u.proper_pieces()) {
    const FormulaScope<S> scope("FJ07.10", "piece", k);
    const bool follows = before != 0 && before == k - 1;
    lambda_k = follows ? next_local(u, lambda_k, k) : local_parameter(u, lambda, k);
    m_k = follows ? next_local(u, m_k, k) : local_parameter(u, m, k);
    rows.push_back(aumann_net<S, P>(bezier_points(u, c, k), lambda_k, m_k, start));
    start = rows.back().back();
    before = k;
  }
  return rows;
}

}  // namespace torse
