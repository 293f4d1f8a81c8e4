// The edge of regression of a piece in closed form and the patch with constant Lam, M, sigma = 1 on it.
//   EdgeOfRegression       the reduced homogeneous curve r, its degree, and v(t) with r = (1-v) p + v q up to a factor
//   edge_of                from the functions of a piece
//   ConstantPatch          FJ21 Theorem 6.1           constant_patch     on the tangents of r
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "torse/developable/piece_functions.hpp"
#include "torse/developable/regression.hpp"

namespace torse {

/// The curve that the rulings touch, r = (delta q - beta p) / common factor. Degree 0: one point, the vertex of a cone,
/// or a direction, that of a cylinder's rulings (r[0] = 0).
template <ExactField S>
struct EdgeOfRegression {
  PolynomialRow<S, 4> row;
  int degree;
  /// v(t) = delta / (delta - beta), which is FJ21.6.1; none where beta = delta: the edge is q - p on every ruling.
  std::optional<PolynomialFraction<S>> v;
};

/// The edge of regression of a piece; none where there is no surface. By alpha p + beta p' = gamma q + delta q',
/// (delta q - beta p)' = (delta' - gamma) q - (beta' - alpha) p lies in the span of p and q, so the curve touches every
/// ruling. It exists also where Lam, M or sigma does not.
template <ExactField S>
std::optional<EdgeOfRegression<S>> edge_of(const PieceFunctions<S>& f) {
  if (f.sweep != Sweep::surface) return std::nullopt;
  EdgeOfRegression<S> edge{{}, 0, std::nullopt};
  for (std::size_t j = 0; j < 4; ++j) edge.row[j] = f.delta * f.q[j] - f.beta * f.p[j];
  const Polynomial<S> common = common_divisor(edge.row);
  for (Polynomial<S>& x : edge.row) {
    x = exact_quotient(x, common);
    edge.degree = std::max(edge.degree, x.degree());
  }
  const Polynomial<S> below = f.delta - f.beta;
  if (!below.zero()) edge.v = PolynomialFraction<S>(f.delta, below);
  return edge;
}

/// A Bezier patch of degree m - 1 over [begin, end] with constant Lam and M and sigma = 1 (FJ21.T6.1). The first weight
/// of p is 1.
template <ExactField S>
struct ConstantPatch {
  S lambda;
  S m;
  std::vector<Vec<S, 4>> p;
  std::vector<Vec<S, 4>> q;
};

namespace detail {

/// The patch with all rows divided by the first weight of p.
template <ExactField S>
ConstantPatch<S> unit_weight(ConstantPatch<S> patch) {
  const S weight = patch.p.front()[0];
  for (auto* rows : {&patch.p, &patch.q}) {
    for (Vec<S, 4>& x : *rows) divide(x, weight);
  }
  return patch;
}

}  // namespace detail

/// The patch p = r + (M-t)/m r', q = r + (Lam-t)/m r' on the rulings of a piece, r being its reduced edge, of degree m
/// >= 2 (FJ21.T6.1): it has the same ruling at the same t. Lam and M are those of the piece where they are constants
/// with sigma = 1 and n = m - 1, which gives the piece back; else the first of begin - h, begin - 2h, ... (h the length
/// of the piece) with which every control weight differs from zero. None for cones and cylinders, where r is a point,
/// and where no such weights exist.
template <ExactField S>
std::optional<ConstantPatch<S>> constant_patch(const PieceFunctions<S>& f, const EdgeOfRegression<S>& edge) {
  if (edge.degree < 2) return std::nullopt;
  const S length = f.end - f.begin;
  const std::vector<Vec<S, 4>> r = bezier_rows(edge.row, edge.degree, f.begin, f.end);
  const auto at_infinity = [](const Vec<S, 4>& y) { return definitely(is_zero(y[0])); };
  const auto both_are = [&](const Vec<S, 4>& x, const Vec<S, 4>& y) { return at_infinity(x) && at_infinity(y); };
  if (std::ranges::adjacent_find(r, both_are) != r.end()) return std::nullopt;
  const auto boundary = [&](const S& x) -> std::optional<std::vector<Vec<S, 4>>> {
    std::vector<Vec<S, 4>> rows = edge_patch<S>(r, (x - f.begin) / length);
    return std::ranges::none_of(rows, at_infinity) ? std::optional(std::move(rows)) : std::nullopt;
  };
  if (f.constant() && edge.degree == f.degree + 1 && *f.sigma()->constant_value() == from_int<S>(1)) {
    const S lambda = *f.lambda()->constant_value();
    const S m = *f.m()->constant_value();
    std::optional<std::vector<Vec<S, 4>>> p = boundary(m);
    std::optional<std::vector<Vec<S, 4>>> q = boundary(lambda);
    if (p && q) return detail::unit_weight(ConstantPatch<S>{lambda, m, *std::move(p), *std::move(q)});
  }
  // A weight (1-s) w_i + s w_{i+1} with s = (x - begin)/h that is not always zero is so for one x at most.
  S x = f.begin;
  const auto next_boundary = [&] {
    std::optional<std::vector<Vec<S, 4>>> rows;
    while (!rows) {
      x -= length;
      rows = boundary(x);
    }
    return *std::move(rows);
  };
  ConstantPatch<S> patch;
  patch.p = next_boundary();
  patch.m = x;
  patch.q = next_boundary();
  patch.lambda = x;
  return detail::unit_weight(std::move(patch));
}

}  // namespace torse
