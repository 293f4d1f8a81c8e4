// The edge of regression, FJ21 section 6.
//   edge_parameter        6.1, v(t)           edge_speed          alpha, beta of section 6
//   edge_row              r(t) = (1-v) p + v q at one parameter
//   edge_curve            the Bezier rows of degree n+1 of the edge for constant Lam, M, sigma
//   edge_patch            Theorem 6.1: the patch of degree n with constant Lam, M, sigma = 1 on the tangents of r
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "torse/developable/factors.hpp"
#include "torse/spline/blossom.hpp"

namespace torse {

/// v(t) = sigma (t-M) / (Lam - t + sigma (t-M)) (FJ21.6.1). Throws DivisionByZero (exact fields) where the edge is at
/// infinity on this ruling (or the ruling carries no edge: a cylinder).
template <Field S>
S edge_parameter(const S& t, const BlossomFunctions<S>& f) {
  const S right = f.sigma * (t - f.m);
  return right / (f.lambda - t + right);
}

/// alpha and beta of (1-v) p' + v q' = alpha (q-p) + beta ((1-v) p + v q) at v = v(t).
template <Field S>
struct EdgeSpeed {
  S alpha;
  S beta;
};

/// alpha = n sigma (Lam-M) / E^2, beta = n (sigma-1) / E with E = Lam - t + sigma (t-M) (FJ21, section 6).
template <Field S>
EdgeSpeed<S> edge_speed(int degree, const S& t, const BlossomFunctions<S>& f) {
  const S n = from_int<S>(degree);
  const S e = f.lambda - t + f.sigma * (t - f.m);
  return {n * f.sigma * (f.lambda - f.m) / (e * e), n * (f.sigma - from_int<S>(1)) / e};
}

/// r = (1-v) p + v q: a homogeneous row of the edge of regression from the rows at the same parameter (FJ21.6.1).
template <Field S, Point<S> P>
P edge_row(const S& v, const P& p, const P& q) {
  return combine(from_int<S>(1) - v, p, v, q);
}

/// The n + 2 Bezier rows on [0, 1] of the edge of regression of a patch with constant Lam != M and sigma:
/// R = ((Lam-t) p + sigma (t-M) q) / (Lam-M), of degree n+1 for every sigma. It is r of FJ21.6.1 for sigma = 1 and a
/// multiple of it by a polynomial of degree one otherwise, the same curve in space. Throws InvalidInput naming "Lambda"
/// for Lam = M, where the edge is one point.
template <Field S, Point<S> P>
std::vector<P> edge_curve(const std::vector<P>& p, const std::vector<P>& q, const BlossomFunctions<S>& f) {
  if (definitely(equal(f.lambda, f.m))) {
    throw InvalidInput("Lambda", "expected a value other than M: a cylinder or cone has no edge curve");
  }
  const S over = from_int<S>(1) / (f.lambda - f.m);
  const S right_over = f.sigma * over;
  std::vector<P> r = times_linear(p, Linear<S>{f.lambda * over, -over});
  const std::vector<P> right = times_linear(q, Linear<S>{-f.m * right_over, right_over});
  for (std::size_t i = 0; i < r.size(); ++i) add(r[i], right[i]);
  return r;
}

/// The Bezier rows of degree n on [0, 1] of r(t) + (x-t)/(n+1) r'(t), which is the blossom r[t^<n>, x]: one boundary of
/// the patch of FJ21 Theorem 6.1 on the tangent surface of the curve r of degree n+1 (p for x = M, q for x = Lam).
template <Field S, Point<S> P>
std::vector<P> edge_patch(const std::vector<P>& r, const S& x) {
  std::vector<P> rows;
  for (std::size_t i = 0; i + 1 < r.size(); ++i) {
    rows.push_back(blossom_step(from_int<S>(0), from_int<S>(1), at(x), r[i], r[i + 1]));
  }
  return rows;
}

}  // namespace torse
