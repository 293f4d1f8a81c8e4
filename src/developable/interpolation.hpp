// Interpolation between a clamped curve and two skew end rulings, FJ07.20-21.
//   branch_polynomial     [a(M) - c_L, v, w] with denominators cleared: its roots off the knots are the branches
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
///   F(M) = sum_{i=0}^{L-1} [c_{i+1}-c_i, v, w] prod_{j<i} (M-u_j) prod_{i<j<L} (M-u_{j+n}),
/// which is [c_L - a(M), v, w] prod_{j<L-1} (M-u_j) for the a(M) of FJ07.20 (see FJ07.15 and 16). A root that is not a
/// knot is a branch M_0 of the interpolation. The zero polynomial means that every M is one.
template <Field S>
std::vector<S> branch_polynomial(const KnotList<S>& u, std::span<const Vec<S, 3>> c, const Vec<S, 3>& v,
                                 const Vec<S, 3>& w) {
  const auto times_linear = [](std::vector<S> f, const S& root) {  // f(M) (M - root)
    f.push_back(from_int<S>(0));
    for (std::size_t i = f.size(); i-- > 0;) f[i] = (i > 0 ? f[i - 1] : from_int<S>(0)) - root * f[i];
    return f;
  };
  std::vector<S> total;
  std::vector<S> head{from_int<S>(1)};  // prod_{j<i} (M - u_j)
  for (int i = 0; i < u.last(); ++i) {
    if (i > 0) total = times_linear(std::move(total), u[i + u.degree()]);
    total.resize(head.size(), from_int<S>(0));
    const std::size_t at_i = static_cast<std::size_t>(i);
    const S volume = det3(difference(c[at_i + 1], c[at_i]), v, w);
    for (std::size_t j = 0; j < head.size(); ++j) add_product(total[j], volume, head[j]);
    head = times_linear(std::move(head), u[i]);
  }
  return total;
}

/// d_0 - c_0 = sigma0 v and d_L - c_L = tau0 w (FJ07.21).
template <Field S>
struct EndRulings {
  S sigma0;
  S tau0;
};

/// sigma_0 and tau_0 of FJ07.21 for a branch M_0 that is not a knot and skew v, w; L* is free, L* = M_0 collapses the
/// rulings. Throws InvalidInput naming "v" for parallel rulings and "M" for a knot.
template <Field S>
EndRulings<S> end_rulings(const KnotList<S>& u, std::span<const Vec<S, 3>> c, const Vec<S, 3>& v, const Vec<S, 3>& w,
                          const S& m0, const S& lambda) {
  require_off_knots(u, m0);
  const Vec<S, 3> nrm = cross(v, w);
  const S volume = det3(v, w, nrm);
  if (definitely(is_zero(volume))) throw InvalidInput("v", "expected end rulings that are not parallel");
  const int last = u.last();
  const Vec<S, 3> chord = difference(eq20(u, c, m0, last), c[static_cast<std::size_t>(last)]);
  const S alpha = det3(chord, w, nrm) / volume;
  const S beta = det3(v, chord, nrm) / volume;
  const S over = m0 - u[last - 1];
  return {alpha * (lambda - m0) / over / product_p(u, m0, 0, last), beta * (m0 - lambda) / over};
}

/// The row d through the clamped curve c whose first ruling lies along v and, for a branch M_0, whose last lies along w.
/// Throws InvalidInput naming "knots" unless both ends are n-fold, and as end_rulings does.
template <Field S>
std::vector<Vec<S, 3>> interpolating_net(const KnotList<S>& u, std::span<const Vec<S, 3>> c, const Vec<S, 3>& v,
                                         const Vec<S, 3>& w, const S& m0, const S& lambda) {
  if (!possibly(u.clamped())) throw InvalidInput("knots", "expected n-fold end knots for interpolation");
  Vec<S, 3> d0 = c[0];
  add_scaled(d0, end_rulings(u, c, v, w, m0, lambda).sigma0, v);
  return linear_net<S, Vec<S, 3>>(u, c, lambda, m0, d0);
}

}  // namespace torse
