// Closed curves.
//   closed            whether a curve ends where it begins
//   rotated           the same curve from another parameter on
#pragma once

#include <utility>
#include <vector>

#include "torse/spline/compatible.hpp"

namespace torse {

/// Whether the curve begins and ends in one point.
template <ExactField S>
bool closed(const Spline<S, Vec<S, 3>>& curve) {
  const KnotList<S>& u = curve.knots;
  return curve_point(u, curve.points(), u.proper_pieces().front(), u.domain_begin()) ==
         curve_point(u, curve.points(), u.proper_pieces().back(), u.domain_end());
}

/// Whether the curve with these homogeneous rows w (1, c) begins and ends in one finite point.
template <ExactField S>
bool closed(const Spline<S, Vec<S, 4>>& curve) {
  const KnotList<S>& u = curve.knots;
  const Vec<S, 4> begin = curve_point(u, curve.points(), u.proper_pieces().front(), u.domain_begin());
  const Vec<S, 4> end = curve_point(u, curve.points(), u.proper_pieces().back(), u.domain_end());
  if (definitely(is_zero(begin[0])) || definitely(is_zero(end[0]))) return false;
  for (int i = 1; i < 4; ++i) {
    if (!definitely(equal(begin[i] * end[0], end[i] * begin[0]))) return false;
  }
  return true;
}

/// The closed curve over [t, t + b - a] for its domain [a, b]: from t to b as it was, then from a to t, b - a later,
/// with an n-fold knot where it was open. Throws InvalidInput naming "t" unless a < t < b.
template <ExactField S>
Spline<S, Vec<S, 4>> rotated(const Spline<S, Vec<S, 4>>& curve, const S& t) {
  const S a = curve.knots.domain_begin();
  const S b = curve.knots.domain_end();
  if (!definitely(less(a, t)) || !definitely(less(t, b)))
    throw InvalidInput("t", "expected a parameter inside the domain");
  Spline<S, Vec<S, 4>> first = restrict_spline(curve, t, b);
  const Spline<S, Vec<S, 4>> second = reparametrized(restrict_spline(curve, a, t), b, b + t - a);
  const S weight = first.control.back()[0] / second.control.front()[0];
  std::vector<S> knots = first.knots.list();
  const std::vector<S>& more = second.knots.list();
  knots.insert(knots.end(), more.begin() + curve.knots.degree(), more.end());
  for (std::size_t i = 1; i < second.control.size(); ++i) first.control.push_back(scaled(weight, second.control[i]));
  return Spline<S, Vec<S, 4>>(KnotList<S>(curve.knots.degree(), std::move(knots)), std::move(first.control));
}

}  // namespace torse
