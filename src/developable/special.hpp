// Cylinders, cones, the tangent net, and the restriction of a developable net along its rulings.
//   cylinder_net     FJ07.4          cone_net       FJ07.5-6         tangent_net      FJ07.7
//   restrict_rulings, restricted_lambda             FJ07.17
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "torse/scalar/formula.hpp"
#include "torse/spline/curve.hpp"

namespace torse {

/// d_i = c_i + h_i v: a cylinder with rulings along v (FJ07.4). Throws InvalidInput naming "lengths" unless there is
/// one length h_i for each control point.
template <Field S, Point<S> P>
std::vector<P> cylinder_net(std::span<const P> c, const P& v, std::span<const S> lengths) {
  if (lengths.size() != c.size()) {
    throw InvalidInput("lengths", "expected " + std::to_string(c.size()) + ", found " + std::to_string(lengths.size()));
  }
  std::vector<P> d(c.begin(), c.end());
  for (std::size_t i = 0; i < d.size(); ++i) {
    const FormulaScope<S> scope("FJ07.4", "d", static_cast<int>(i));
    add_scaled(d[i], lengths[i], v);
  }
  return d;
}

/// d_i = d_{i-1} + alpha (c_i - c_{i-1}) (FJ07.6): for alpha != 1 a cone with vertex (alpha c_0 - d_0) / (alpha - 1)
/// (FJ07.5), for alpha = 1 a translated row, a cylinder.
template <Field S, Point<S> P>
std::vector<P> cone_net(std::span<const P> c, const S& alpha, const P& d0) {
  std::vector<P> d{d0};
  for (std::size_t i = 1; i < c.size(); ++i) {
    const FormulaScope<S> scope("FJ07.6", "d", static_cast<int>(i));
    P next = d.back();
    add_scaled(next, alpha, difference(c[i], c[i - 1]));
    d.push_back(std::move(next));
  }
  return d;
}

/// The vertex of the cone of FJ07.5-6. Throws InvalidInput naming "alpha" for alpha = 1, a cylinder.
template <Field S, Point<S> P>
P cone_vertex(const P& c0, const P& d0, const S& alpha) {
  if (definitely(equal(alpha, from_int<S>(1)))) throw InvalidInput("alpha", "1 gives a cylinder, which has no vertex");
  P vertex = difference(scaled(alpha, c0), d0);
  divide(vertex, alpha - from_int<S>(1));
  return vertex;
}

/// d_i = c_i + ((n-i) c_{i+1} + (2i-n) c_i - i c_{i-1}): the row c + c' of the tangent surface of one Bezier piece of
/// degree n on [0, 1] (FJ07.7 with lambda = 1).
template <Field S, Point<S> P>
std::vector<P> tangent_net(std::span<const P> c) {
  const int n = static_cast<int>(c.size()) - 1;
  std::vector<P> d(c.begin(), c.end());
  for (int i = 0; i <= n; ++i) {
    const FormulaScope<S> scope("FJ07.7", "d", i);
    const std::size_t at_i = static_cast<std::size_t>(i);
    add_scaled(d[at_i], from_int<S>(2 * i - n), c[at_i]);
    if (i < n) add_scaled(d[at_i], from_int<S>(n - i), c[at_i + 1]);
    if (i > 0) add_scaled(d[at_i], from_int<S>(-i), c[at_i - 1]);
  }
  return d;
}

/// d~_i = c_i + beta (d_i - c_i): the part 0 <= v <= beta of the surface (FJ07.17).
template <Field S, Point<S> P>
std::vector<P> restrict_rulings(std::span<const P> c, std::span<const P> d, const S& beta) {
  std::vector<P> row(c.begin(), c.end());
  for (std::size_t i = 0; i < row.size(); ++i) add_scaled(row[i], beta, difference(d[i], c[i]));
  return row;
}

/// L~* = M* + beta (L* - M*); M* stays (FJ07.17).
template <Field S>
S restricted_lambda(const S& lambda, const S& m, const S& beta) {
  return m + beta * (lambda - m);
}

}  // namespace torse
