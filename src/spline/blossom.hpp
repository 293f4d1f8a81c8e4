// Blossoms (polar forms) of B-spline curves by de Boor's algorithm with homogeneous arguments.
//   Parameter        (a : w): (t, 1) is the parameter t, (1, 0) the direction whose blossom is a derivative
//   blossom_step     one affine step between two neighbours in de Boor's triangle (FJ07, section 3)
//   blossom          c[v_1, ..., v_n] on piece k
//   last_pair        c_0^{n-1}(t), c_1^{n-1}(t): the last but one points of de Boor's algorithm on piece k
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "torse/algebra/point.hpp"
#include "torse/spline/knots.hpp"

namespace torse {

/// A homogeneous argument of a blossom.
template <Ring S>
struct Parameter {
  S a;
  S w;
};

/// The parameter t.
template <Ring S>
Parameter<S> at(const S& t) {
  return {t, from_int<S>(1)};
}

/// The point at infinity of the parameter line: c[t^<n-1>, direction] = c'(t)/n.
template <Ring S>
Parameter<S> direction() {
  return {from_int<S>(1), from_int<S>(0)};
}

/// The same argument repeated.
template <Ring S>
std::vector<Parameter<S>> repeated(const Parameter<S>& v, int times) {
  return std::vector<Parameter<S>>(static_cast<std::size_t>(times), v);
}

/// ((w hi - a) x + (a - w lo) y) / (hi - lo): the affine step of de Boor's algorithm. Throws DivisionByZero if hi = lo.
template <Field S, Point<S> P>
P blossom_step(const S& lo, const S& hi, const Parameter<S>& v, P x, const P& y) {
  scale(x, v.w * hi - v.a);
  add_scaled(x, v.a - v.w * lo, y);
  divide(x, hi - lo);
  return x;
}

/// De Boor's triangle on piece k after the given arguments (at most n of them): the row of the n + 1 - r points
/// c_i^r[v_1..v_r]. The piece must not be empty.
template <Field S, class P>
std::vector<P> blossom_row(const KnotList<S>& u, std::span<const P> c, int k, std::span<const Parameter<S>> v) {
  const int n = u.degree();
  std::vector<P> row(c.begin() + (k - 1), c.begin() + (k + n));
  for (int r = 1; r <= static_cast<int>(v.size()); ++r) {
    for (int i = 0; i <= n - r; ++i) {
      const std::size_t at = static_cast<std::size_t>(i);
      row[at] = blossom_step(u[k - 2 + i + r], u[k - 1 + i + n], v[static_cast<std::size_t>(r - 1)], std::move(row[at]),
                             row[at + 1]);
    }
    row.pop_back();
  }
  return row;
}

/// c[v_1, ..., v_n] on piece k (FJ07, section 3); symmetric and multiaffine. The piece must not be empty.
template <Field S, class P>
P blossom(const KnotList<S>& u, std::span<const P> c, int k, std::span<const Parameter<S>> v) {
  return std::move(blossom_row(u, c, k, v).front());
}

/// c(t) on piece k: the blossom on the diagonal.
template <Field S, class P>
P curve_point(const KnotList<S>& u, std::span<const P> c, int k, const S& t) {
  return blossom<S, P>(u, c, k, repeated(at(t), u.degree()));
}

/// c'(t) on piece k: n c[t^<n-1>, direction].
template <Field S, class P>
P curve_derivative(const KnotList<S>& u, std::span<const P> c, int k, const S& t) {
  std::vector<Parameter<S>> v = repeated(at(t), u.degree());
  v.back() = direction<S>();
  return scaled(from_int<S>(u.degree()), blossom<S, P>(u, c, k, v));
}

/// c_0^{n-1}(t) and c_1^{n-1}(t) on piece k (FJ07, section 3): the blossom at (t^<n-1>, a) and (t^<n-1>, b) for the
/// ends a, b of the piece.
template <Field S, class P>
std::pair<P, P> last_pair(const KnotList<S>& u, std::span<const P> c, int k, const S& t) {
  std::vector<P> row = blossom_row<S, P>(u, c, k, repeated(at(t), u.degree() - 1));
  return {std::move(row[0]), std::move(row[1])};
}

/// c[t^<n-1>, s] on piece k: the point with parameter s on the tangent at c(t) (FJ07.9, FJ21.3.5).
template <Field S, class P>
P tangent_point(const KnotList<S>& u, std::span<const P> c, int k, const S& t, const Parameter<S>& s) {
  std::vector<Parameter<S>> v = repeated(at(t), u.degree());
  v.back() = s;
  return blossom<S, P>(u, c, k, v);
}

}  // namespace torse
