// Curves that go on beyond their ends, by unclamping (Hu, Tai and Zhang 2002, as BZZ19 takes it in section 3.4).
//   extended_end          one more piece behind the end, to a given point
//   tangent_target        where the tangent leads
//   extended              both ends, along the tangents
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "torse/spline/compatible.hpp"

namespace torse {

/// The curve with a piece [b, e] more behind its end b < e that leads to `target`, with n-1 derivatives in common with
/// it at b: b becomes a simple knot, e is n-fold, and the control points of the windows that reach e are values of the
/// last piece's blossom. Only the last control point is free: the target. Throws InvalidInput naming "e" unless b < e.
template <OrderedField S, class P>
Spline<S, P> extended_end(const Spline<S, P>& curve, const S& e, const P& target) {
  const KnotList<S>& old = curve.knots;
  const int n = old.degree();
  const S b = old.domain_end();
  if (!definitely(less(b, e))) throw InvalidInput("e", "expected a parameter behind the end of the curve");
  const int last = old.proper_pieces().back();
  const int kept = n + last - 2;  // u_kept is the begin of the last proper piece
  std::vector<S> knots(old.list().begin(), old.list().begin() + (kept + 1));
  knots.push_back(b);
  knots.insert(knots.end(), static_cast<std::size_t>(n), e);
  const KnotList<S> u(n, std::move(knots));
  std::vector<P> control(curve.control.begin(), curve.control.begin() + last);
  for (int i = last; i < u.last(); ++i) {
    std::vector<Parameter<S>> window;
    for (int j = i; j < i + n; ++j) window.push_back(at(u[j]));
    control.push_back(blossom<S, P>(old, curve.points(), last, window));
  }
  control.push_back(target);
  return Spline<S, P>(u, std::move(control));
}

/// c(b) + (e - b) c'(b): the point on the tangent at the end b.
template <OrderedField S, class P>
P tangent_target(const Spline<S, P>& curve, const S& e) {
  const S& b = curve.knots.domain_end();
  const int k = curve.knots.proper_pieces().back();
  P point = curve_point(curve.knots, curve.points(), k, b);
  add_scaled(point, e - b, curve_derivative(curve.knots, curve.points(), k, b));
  return point;
}

/// The curve over [a - share (b - a), b + share (b - a)], along the tangents at its ends a and b. The share is
/// positive; throws InvalidInput naming "e" otherwise. For homogeneous rows the weights go on along their tangents too.
template <OrderedField S, class P>
Spline<S, P> extended(Spline<S, P> curve, const S& share) {
  const S begin = curve.knots.domain_begin();
  const S rise = share * (curve.knots.domain_end() - begin);
  for (int end = 0; end < 2; ++end) {
    const S e = curve.knots.domain_end() + rise;
    curve = reversed_spline(extended_end(curve, e, tangent_target(curve, e)));
  }
  // reversed_spline keeps a domain, so the second piece has moved all parameters up.
  return reparametrized(curve, begin - rise, curve.knots.domain_end() - rise);
}

}  // namespace torse
