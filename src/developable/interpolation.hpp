// Interpolation between a clamped curve and two skew end rulings, FJ07.20-21.
//   chord_polynomial      c_L - a(M) with denominators cleared
//   branch_polynomial     [c_L - a(M), v, w] with denominators cleared: its roots off the knots are the branches
//   chord_coordinates     alpha, beta of a(M_0) - c_L = alpha v + beta w
//   end_rulings           sigma_0, tau_0 of a branch M_0 and a free L*
//   interpolating_net     the row d of a branch
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "torse/algebra/determinant.hpp"
#include "torse/developable/closed_forms.hpp"

namespace torse {

/// The coefficients of 1, M, ..., M^{L-1} of
///   F(M) = sum_{i=0}^{L-1} (c_{i+1}-c_i) prod_{j<i} (M-u_j) prod_{i<j<L} (M-u_{j+n}),
/// which is (c_L - a(M)) prod_{j<L-1} (M-u_j) for the a(M) of FJ07.20 (see FJ07.15 and 16).
template <Field S, class P>
std::vector<P> chord_polynomial(const KnotList<S>& u, std::span<const P> c) {
  std::vector<P> total;
  std::vector<S> head{from_int<S>(1)};  // prod_{j<i} (M - u_j)
  for (int i = 0; i < u.last(); ++i) {
    const std::size_t at_i = static_cast<std::size_t>(i);
    total.resize(head.size(), PointTraits<P>::zero());
    if (i > 0) {  // total (M - u_{i+n})
      for (std::size_t j = total.size() - 1; j > 0; --j) {
        scale(total[j], -u[i + u.degree()]);
        add(total[j], total[j - 1]);
      }
      scale(total[0], -u[i + u.degree()]);
    }
    const P side = difference(c[at_i + 1], c[at_i]);
    for (std::size_t j = 0; j < head.size(); ++j) add_scaled(total[j], head[j], side);
    head.push_back(from_int<S>(1));
    for (std::size_t j = head.size() - 2; j > 0; --j) head[j] = head[j - 1] - u[i] * head[j];
    head[0] *= -u[i];
  }
  return total;
}

/// [F(M), v, w] for the F of chord_polynomial, by coefficients of 1, M, ..., M^{L-1}. A root that is not a knot is a
/// branch M_0 of the interpolation. The zero polynomial means that every M is one.
template <Field S>
std::vector<S> branch_polynomial(const KnotList<S>& u, std::span<const Vec<S, 3>> c, const Vec<S, 3>& v,
                                 const Vec<S, 3>& w) {
  const Vec<S, 3> normal = cross(v, w);
  std::vector<S> volumes;
  for (const Vec<S, 3>& coefficient : chord_polynomial<S, Vec<S, 3>>(u, c)) volumes.push_back(dot(coefficient, normal));
  return volumes;
}

/// a(M_0) - c_L = alpha v + beta w (FJ07.20-21).
template <Field S>
struct ChordCoordinates {
  S alpha;
  S beta;
};

/// The coordinates of a vector of the plane of v, w: alpha = [x, w, n] / [v, w, n], beta = [v, x, n] / [v, w, n] with
/// n = v x w (before FJ07.21). Throws InvalidInput naming "v" for parallel v, w.
template <Field S>
ChordCoordinates<S> chord_coordinates(const Vec<S, 3>& x, const Vec<S, 3>& v, const Vec<S, 3>& w) {
  const FormulaScope<S> scope("FJ07.20", "alpha, beta", 0);
  const Vec<S, 3> n = cross(v, w);
  const S volume = det3(v, w, n);
  if (definitely(is_zero(volume))) throw InvalidInput("v", "expected end rulings that are not parallel");
  return {det3(x, w, n) / volume, det3(v, x, n) / volume};
}

/// d_0 - c_0 = sigma0 v and d_L - c_L = tau0 w (FJ07.21).
template <Field S>
struct EndRulings {
  S sigma0;
  S tau0;
};

/// sigma_0 and tau_0 of FJ07.21 from alpha, beta: alpha (L*-M_0)/(M_0-u_{L-1}) / P(0, L) and beta
/// (M_0-L*)/(M_0-u_{L-1}). L* is free, L* = M_0 collapses the rulings. Throws InvalidInput naming "M" if M_0 is a knot.
template <Field S>
EndRulings<S> end_rulings(const KnotList<S>& u, const ChordCoordinates<S>& chord, const S& m0, const S& lambda) {
  require_off_knots(u, m0);
  const FormulaScope<S> scope("FJ07.21", "sigma_0, tau_0", 0);
  const S over = m0 - u[u.last() - 1];
  return {chord.alpha * (lambda - m0) / over / product_p(u, m0, 0, u.last()), chord.beta * (m0 - lambda) / over};
}

/// The same for a branch M_0 of the curve c and skew end rulings v, w.
template <Field S>
EndRulings<S> end_rulings(const KnotList<S>& u, std::span<const Vec<S, 3>> c, const Vec<S, 3>& v, const Vec<S, 3>& w,
                          const S& m0, const S& lambda) {
  require_off_knots(u, m0);
  const Vec<S, 3> chord = difference(eq20(u, c, m0, u.last()), c[static_cast<std::size_t>(u.last())]);
  return end_rulings(u, chord_coordinates(chord, v, w), m0, lambda);
}

/// The row d through the clamped curve c whose first ruling lies along v and, for a branch M_0, whose last lies along
/// w. Throws InvalidInput naming "knots" unless both ends are n-fold, and as end_rulings does.
template <Field S>
std::vector<Vec<S, 3>> interpolating_net(const KnotList<S>& u, std::span<const Vec<S, 3>> c, const Vec<S, 3>& v,
                                         const Vec<S, 3>& w, const S& m0, const S& lambda) {
  if (!possibly(u.clamped())) throw InvalidInput("knots", "expected n-fold end knots for interpolation");
  Vec<S, 3> d0 = c[0];
  add_scaled(d0, end_rulings(u, c, v, w, m0, lambda).sigma0, v);
  return linear_net<S, Vec<S, 3>>(u, c, lambda, m0, d0);
}

}  // namespace torse
