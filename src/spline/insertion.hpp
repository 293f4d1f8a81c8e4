// Knot insertion and Bezier extraction.
//   insert_knot       Boehm's algorithm: one knot more, the same curve
//   bezier_points     the Bezier polygon of one piece      restricted_points   ... of the piece's polynomial on [a, b]
//   spline_vertex     c_i = c[u_i..u_{i+n-1}] from the Bezier polygon of a piece
#pragma once

#include <utility>
#include <vector>

#include "torse/spline/curve.hpp"

namespace torse {

/// The index j of the knot interval for inserting t: u_j <= t < u_{j+1} inside the domain, u_j < t at its right end.
/// Throws InvalidInput naming "t" if t is outside the domain, Undecided where the order is not decided.
template <OrderedField S>
int insertion_interval(const KnotList<S>& u, const S& t) {
  if (definitely(less(t, u.domain_begin())) || definitely(less(u.domain_end(), t))) {
    throw InvalidInput("t", "expected a parameter in [" + as_text(u.domain_begin()) + ", " + as_text(u.domain_end()) +
                                "], found " + as_text(t));
  }
  for (int j = u.last() - 1; j >= u.degree() - 1; --j) {
    const Truth left = less(t, u[j]);
    const Truth here = !left & less(u[j], u[j + 1]);
    if (here == Truth::unknown) throw Undecided("knot insertion: the order of t and the knots is not decided");
    if (definitely(here)) return j;
  }
  throw Undecided("knot insertion: no interval contains t");
}

/// The curve with the knot t inserted after u_j (Boehm). n-1 <= j <= L-1; t lies in [u_j, u_{j+1}] for ordered fields.
/// Throws InvalidInput if a knot would be repeated more than n times.
template <Field S, class P>
Spline<S, P> insert_knot(const Spline<S, P>& curve, const S& t, int j) {
  const KnotList<S>& u = curve.knots;
  const int n = u.degree();
  std::vector<S> knots = u.list();
  knots.insert(knots.begin() + (j + 1), t);
  std::vector<P> points;
  points.reserve(curve.control.size() + 1);
  for (int i = 0; i <= u.last() + 1; ++i) {
    const std::size_t at_i = static_cast<std::size_t>(i);
    if (i < j - n + 2) {
      points.push_back(curve.control[at_i]);
    } else if (i > j + 1) {
      points.push_back(curve.control[at_i - 1]);
    } else {
      points.push_back(blossom_step(u[i - 1], u[i + n - 1], at(t), curve.control[at_i - 1], curve.control[at_i]));
    }
  }
  return Spline<S, P>(KnotList<S>(n, std::move(knots)), std::move(points));
}

/// The curve with the knot t inserted once.
template <OrderedField S, class P>
Spline<S, P> insert_knot(const Spline<S, P>& curve, const S& t) {
  return insert_knot(curve, t, insertion_interval(curve.knots, t));
}

/// The Bezier polygon on [a, b] of the polynomial of piece k: c[a^<n-i>, b^<i>], i = 0..n.
template <Field S, class P>
std::vector<P> restricted_points(const KnotList<S>& u, std::span<const P> c, int k, const S& a, const S& b) {
  const int n = u.degree();
  std::vector<P> points;
  points.reserve(static_cast<std::size_t>(n) + 1);
  for (int i = 0; i <= n; ++i) {
    std::vector<Parameter<S>> v = repeated(at(a), n - i);
    v.insert(v.end(), static_cast<std::size_t>(i), at(b));
    points.push_back(blossom<S, P>(u, c, k, v));
  }
  return points;
}

/// The Bezier polygon of piece k on its own interval (FJ07.19).
template <Field S, class P>
std::vector<P> bezier_points(const KnotList<S>& u, std::span<const P> c, int k) {
  return restricted_points(u, c, k, u.piece_begin(k), u.piece_end(k));
}

/// The vertex c_i = c[u_i..u_{i+n-1}] of the spline from the Bezier polygon of piece k, k-1 <= i <= k+n-1.
template <Field S, class P>
P spline_vertex(const KnotList<S>& u, std::span<const P> bezier, int k, int i) {
  std::vector<Parameter<S>> v;
  for (int j = i; j < i + u.degree(); ++j) v.push_back(at(u[j]));
  return blossom<S, P>(bezier_knots(u.degree(), u.piece_begin(k), u.piece_end(k)), bezier, 1, v);
}

}  // namespace torse
