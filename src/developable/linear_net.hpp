// The linear construction of developable nets.
//   linear_net        FJ07.13: d_0..d_L from c_0..c_L, L*, M*, d_0          (polynomial surfaces)
//   rational_net      FJ21.7.1: the same for homogeneous rows, with sigma   (rational surfaces)
//   cell_point        one side of FJ07.13: the point where the sides c_i c_{i+1} and d_i d_{i+1} of a cell meet
#pragma once

#include <span>
#include <string>
#include <vector>

#include "torse/spline/blossom.hpp"

namespace torse {

/// c[u_{i+1}, ..., u_{i+n-1}, X]: ((u_{i+n} - X) c_i + (X - u_i) c_{i+1}) / (u_{i+n} - u_i), one side of FJ07.13.
template <Field S, class P>
P cell_point(const KnotList<S>& u, std::span<const P> c, int i, const S& x) {
  const std::size_t at_i = static_cast<std::size_t>(i);
  return blossom_step(u[i], u[i + u.degree()], at(x), c[at_i], c[at_i + 1]);
}

/// Throws InvalidInput naming "M" if M* is decidedly one of the knots: at u_0..u_{L-1} FJ07.13 does not determine the
/// next vertex, at a later knot the net forgets d_0.
template <Field S>
void require_off_knots(const KnotList<S>& u, const S& m) {
  for (int i = 0; i < u.size(); ++i) {
    if (definitely(equal(m, u[i]))) {
      throw InvalidInput(
          "M", "expected a value that is not a knot, found the knot u_" + std::to_string(i) + " = " + as_text(u[i]));
    }
  }
}

/// The second row of a developable net through c (FJ07.13): for i = 0..L-1,
///   (u_{i+n} - L*) c_i + (L* - u_i) c_{i+1} = (u_{i+n} - M*) d_i + (M* - u_i) d_{i+1}.
/// L* = M* gives a cylinder. Throws InvalidInput naming "points" (not L+1 of them) or "M" (a knot).
template <Field S, class P>
std::vector<P> linear_net(const KnotList<S>& u, std::span<const P> c, const S& lambda, const S& m, const P& d0) {
  const int n = u.degree();
  if (static_cast<int>(c.size()) != u.last() + 1) {
    throw InvalidInput(
        "points", "expected " + std::to_string(u.last() + 1) + " control points, found " + std::to_string(c.size()));
  }
  require_off_knots(u, m);
  std::vector<P> d{d0};
  d.reserve(c.size());
  for (int i = 0; i < u.last(); ++i) {
    const std::size_t at_i = static_cast<std::size_t>(i);
    P next = combine(u[i + n] - lambda, c[at_i], lambda - u[i], c[at_i + 1]);
    add_scaled(next, m - u[i + n], d[at_i]);
    divide(next, m - u[i]);
    d.push_back(std::move(next));
  }
  return d;
}

/// The second homogeneous row of a rational developable net through the row p (FJ21.7.1 with a knot list): for
/// i = 0..L-1, (u_{i+n} - L*) p_i + (L* - u_i) p_{i+1} = sigma ((u_{i+n} - M*) q_i + (M* - u_i) q_{i+1}).
/// Throws InvalidInput naming "sigma" (zero), "points" or "M".
template <Field S, class P>
std::vector<P> rational_net(const KnotList<S>& u, std::span<const P> p, const S& lambda, const S& m, const S& sigma,
                            const P& q0) {
  if (definitely(is_zero(sigma))) throw InvalidInput("sigma", "expected a value that is not zero");
  std::vector<P> row(p.begin(), p.end());
  for (P& x : row) divide(x, sigma);
  return linear_net<S, P>(u, row, lambda, m, q0);
}

}  // namespace torse
