// The linear construction of developable nets.
//   linear_net        FJ07.13: d_0..d_L from c_0..c_L, L*, M*, d_0, ruling by ruling      (polynomial surfaces)
//   net_from          the same from any vertex d_k
//   printed_net       the same, solved for d_{i+1} as FJ07.13 stands in the paper
//   rational_net      FJ21.7.1: the same for homogeneous rows, with sigma   (rational surfaces)
//   cell_point        one side of FJ07.13: the point where the sides c_i c_{i+1} and d_i d_{i+1} of a cell meet
#pragma once

#include <span>
#include <string>
#include <vector>

#include "torse/scalar/formula.hpp"
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

namespace detail {

/// Throws InvalidInput naming "points" unless c fits the knots.
template <Field S, class P>
void require_row(const KnotList<S>& u, std::span<const P> c) {
  if (static_cast<int>(c.size()) != u.last() + 1) {
    throw InvalidInput(
        "points", "expected " + std::to_string(u.last() + 1) + " control points, found " + std::to_string(c.size()));
  }
}

/// (near r + gap (c_{i+1} - c_i)) / far: the next ruling.
template <Field S, class P>
void next_ruling(P& ruling, const S& gap, const P& side, const S& near, const S& far) {
  ruling = combine(gap, side, near, ruling);
  divide(ruling, far);
}

}  // namespace detail

/// The second row of the developable net through c whose vertex k is `dk`, 0 <= k <= L. In the rulings r_i = d_i - c_i
/// FJ07.13 is (M* - u_i) r_{i+1} = (M* - u_{i+n}) r_i + (L* - M*) (c_{i+1} - c_i) (FJ07.13.rulings): neither the
/// place of the origin nor the cancellation of L* - M* enters, docs/findings.md bounds the rounding errors. L* = M*
/// gives a cylinder. Throws InvalidInput naming "points" (not L+1 of them), "M" (a knot) or "k".
template <Field S, class P>
std::vector<P> net_from(const KnotList<S>& u, std::span<const P> c, const S& lambda, const S& m, int k, const P& dk) {
  const int n = u.degree();
  detail::require_row(u, c);
  require_off_knots(u, m);
  if (k < 0 || k > u.last()) throw InvalidInput("k", "expected a vertex of the row");
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  std::vector<P> d(c.begin(), c.end());
  d[at(k)] = dk;
  const S gap = lambda - m;
  P ruling = difference(dk, c[at(k)]);
  for (int i = k; i < u.last(); ++i) {
    const FormulaScope<S> scope("FJ07.13.rulings", "d", i + 1);
    detail::next_ruling<S, P>(ruling, gap, difference(c[at(i + 1)], c[at(i)]), m - u[i + n], m - u[i]);
    add(d[at(i + 1)], ruling);
  }
  ruling = difference(dk, c[at(k)]);
  for (int i = k - 1; i >= 0; --i) {
    const FormulaScope<S> scope("FJ07.13.rulings", "d", i);
    detail::next_ruling<S, P>(ruling, gap, difference(c[at(i)], c[at(i + 1)]), m - u[i], m - u[i + n]);
    add(d[at(i)], ruling);
  }
  return d;
}

/// The second row of a developable net through c (FJ07.13) from its first vertex: for i = 0..L-1,
///   (u_{i+n} - L*) c_i + (L* - u_i) c_{i+1} = (u_{i+n} - M*) d_i + (M* - u_i) d_{i+1}.
/// L* = M* gives a cylinder. Throws InvalidInput naming "points" (not L+1 of them) or "M" (a knot).
template <Field S, class P>
std::vector<P> linear_net(const KnotList<S>& u, std::span<const P> c, const S& lambda, const S& m, const P& d0) {
  return net_from<S, P>(u, c, lambda, m, 0, d0);
}

/// The row of net_from with each equation of FJ07.13 solved as it stands: its rounding errors grow with the distance of
/// the points from the origin. It is there to be compared with (docs/findings.md). Throws as net_from does.
template <Field S, class P>
std::vector<P> printed_net(const KnotList<S>& u, std::span<const P> c, const S& lambda, const S& m, int k,
                           const P& dk) {
  const int n = u.degree();
  detail::require_row(u, c);
  require_off_knots(u, m);
  if (k < 0 || k > u.last()) throw InvalidInput("k", "expected a vertex of the row");
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  std::vector<P> d(c.begin(), c.end());
  d[at(k)] = dk;
  const auto left_side = [&](int i) { return combine(u[i + n] - lambda, c[at(i)], lambda - u[i], c[at(i + 1)]); };
  for (int i = k; i < u.last(); ++i) {
    const FormulaScope<S> scope("FJ07.13", "d", i + 1);
    P next = left_side(i);
    add_scaled(next, m - u[i + n], d[at(i)]);
    divide(next, m - u[i]);
    d[at(i + 1)] = std::move(next);
  }
  for (int i = k - 1; i >= 0; --i) {
    const FormulaScope<S> scope("FJ07.13", "d", i);
    P next = left_side(i);
    add_scaled(next, u[i] - m, d[at(i + 1)]);
    divide(next, u[i + n] - m);
    d[at(i)] = std::move(next);
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
  const FormulaScope<S> scope("FJ21.7.1", "q", 0);
  std::vector<P> row(p.begin(), p.end());
  for (P& x : row) divide(x, sigma);
  return linear_net<S, P>(u, row, lambda, m, q0);
}

}  // namespace torse
