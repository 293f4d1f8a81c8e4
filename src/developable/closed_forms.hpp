// Closed forms of the linear construction, FJ07.14-16: the vertex d_N, N = 1..L, without the vertices before it.
//   eq14    d_N                    eq15    d_N - c_N, sorted by L*-M*            eq16    d_N - c_N by differences of c
//   eq16_rulings    eq16 for all vertices at once
// with P(a, b) = prod_{i=a}^{b-1} (M*-u_{i+n})/(M*-u_i) and Q(i, N) = prod_{j=i}^{N-2} (M*-u_{n+j+1})/(M*-u_j).
#pragma once

#include <span>
#include <vector>

#include "torse/developable/linear_net.hpp"

namespace torse {

/// P(a, b) of FJ07.14.
template <Field S>
S product_p(const KnotList<S>& u, const S& m, int a, int b) {
  S product = from_int<S>(1);
  for (int i = a; i < b; ++i) product *= (m - u[i + u.degree()]) / (m - u[i]);
  return product;
}

/// Q(i, N) of FJ07.14.
template <Field S>
S product_q(const KnotList<S>& u, const S& m, int i, int vertex) {
  S product = from_int<S>(1);
  for (int j = i; j <= vertex - 2; ++j) product *= (m - u[u.degree() + j + 1]) / (m - u[j]);
  return product;
}

/// sum_{i=1}^{N-1} (u_{i+n}-u_{i-1})/(M*-u_{i-1}) Q(i,N) c_i, shared by FJ07.14, 15 and 20; the products Q(i, N) are
/// built up from i = N-1 downwards.
template <Field S, class P>
P weighted_vertices(const KnotList<S>& u, std::span<const P> c, const S& m, int vertex) {
  const int n = u.degree();
  P total = PointTraits<P>::zero();
  S q = from_int<S>(1);
  for (int i = vertex - 1; i >= 1; --i) {
    if (i <= vertex - 2) q *= (m - u[n + i + 1]) / (m - u[i]);
    add_scaled(total, (u[i + n] - u[i - 1]) / (m - u[i - 1]) * q, c[static_cast<std::size_t>(i)]);
  }
  return total;
}

/// a(M) of FJ07.20 for the vertex N (the paper's case is N = L):
/// (M-u_{N-1})/(M-u_0) P(1,N) c_0 + sum_{i=1}^{N-1} (u_{i+n}-u_{i-1})/(M-u_{i-1}) Q(i,N) c_i.
template <Field S, class P>
P eq20(const KnotList<S>& u, std::span<const P> c, const S& m, int vertex) {
  const FormulaScope<S> scope("FJ07.20", "a", vertex);
  P a = weighted_vertices(u, c, m, vertex);
  add_scaled(a, (m - u[vertex - 1]) / (m - u[0]) * product_p(u, m, 1, vertex), c[0]);
  return a;
}

/// d_N by FJ07.14, 1 <= N <= L. Throws InvalidInput naming "M" if M* is a knot.
template <Field S, class P>
P eq14(const KnotList<S>& u, std::span<const P> c, const S& lambda, const S& m, const P& d0, int vertex) {
  require_off_knots(u, m);
  const FormulaScope<S> scope("FJ07.14", "d", vertex);
  const int n = u.degree();
  P d = scaled((m - lambda) / (m - u[vertex - 1]), weighted_vertices(u, c, m, vertex));
  add_scaled(d, product_p(u, m, 0, vertex), d0);
  add_scaled(d, (u[n] - lambda) / (m - u[0]) * product_p(u, m, 1, vertex), c[0]);
  add_scaled(d, (lambda - u[vertex - 1]) / (m - u[vertex - 1]), c[static_cast<std::size_t>(vertex)]);
  return d;
}

/// d_N - c_N by FJ07.15, 1 <= N <= L. Throws InvalidInput naming "M" if M* is a knot.
template <Field S, class P>
P eq15(const KnotList<S>& u, std::span<const P> c, const S& lambda, const S& m, const P& d0, int vertex) {
  require_off_knots(u, m);
  const FormulaScope<S> scope("FJ07.15", "d-c", vertex);
  P ruling = scaled((lambda - m) / (m - u[vertex - 1]),
                    difference(c[static_cast<std::size_t>(vertex)], eq20(u, c, m, vertex)));
  add_scaled(ruling, product_p(u, m, 0, vertex), difference(d0, c[0]));
  return ruling;
}

namespace detail {

/// 1/(M*-u_i) for i = 0..count-1.
template <Field S>
std::vector<S> reciprocal_distances(const KnotList<S>& u, const S& m, int count) {
  std::vector<S> over;
  over.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) over.push_back(from_int<S>(1) / (m - u[i]));
  return over;
}

/// The right side of FJ07.16 from over_i = 1/(M*-u_i) and the differences c_{i+1}-c_i, i < N, and ruling = d_0-c_0.
template <Field S, class P>
P eq16_sum(const KnotList<S>& u, const S& lambda, const S& m, const std::vector<S>& over, const std::vector<P>& steps,
           const P& ruling, int vertex) {
  const FormulaScope<S> scope("FJ07.16", "d-c", vertex);
  P total = PointTraits<P>::zero();
  S p = from_int<S>(1);  // P(i+1, N)
  for (int i = vertex - 1; i >= 0; --i) {
    const std::size_t at_i = static_cast<std::size_t>(i);
    p *= over[at_i];
    add_scaled(total, p, steps[at_i]);
    p *= m - u[i + u.degree()];
  }
  scale(total, lambda - m);
  add_scaled(total, p, ruling);
  return total;
}

template <class P>
std::vector<P> differences(std::span<const P> c, int count) {
  std::vector<P> steps;
  steps.reserve(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) steps.push_back(difference(c[i + 1], c[i]));
  return steps;
}

}  // namespace detail

/// d_N - c_N by FJ07.16, 1 <= N <= L: P(0,N) (d_0-c_0) + (L*-M*) sum_{i=0}^{N-1} P(i+1,N) (c_{i+1}-c_i)/(M*-u_i).
/// Throws InvalidInput naming "M" if M* is a knot.
template <Field S, class P>
P eq16(const KnotList<S>& u, std::span<const P> c, const S& lambda, const S& m, const P& d0, int vertex) {
  require_off_knots(u, m);
  return detail::eq16_sum<S, P>(u, lambda, m, detail::reciprocal_distances(u, m, vertex),
                                detail::differences(c, vertex), difference(d0, c[0]), vertex);
}

/// d_N - c_N by FJ07.16 for all N = 1..L, with L divisions. Throws InvalidInput naming "M" if M* is a knot.
template <Field S, class P>
std::vector<P> eq16_rulings(const KnotList<S>& u, std::span<const P> c, const S& lambda, const S& m, const P& d0) {
  require_off_knots(u, m);
  const std::vector<S> over = detail::reciprocal_distances(u, m, u.last());
  const std::vector<P> steps = detail::differences(c, u.last());
  const P ruling = difference(d0, c[0]);
  std::vector<P> rulings;
  rulings.reserve(steps.size());
  for (int vertex = 1; vertex <= u.last(); ++vertex) {
    rulings.push_back(detail::eq16_sum<S, P>(u, lambda, m, over, steps, ruling, vertex));
  }
  return rulings;
}

}  // namespace torse
