// Splines over one knot list: parts of curves, and two curves of different degrees and knots brought together.
//   restrict_spline      the part of a curve on [a, b], clamped
//   reparametrized       the same curve over another interval
//   reversed_spline      the same curve from its end to its begin
//   united_knots         the knots of two curves
//   make_compatible      two curves over the first one's interval, with one degree and one knot list
#pragma once

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "torse/spline/elevation.hpp"
#include "torse/spline/insertion.hpp"

namespace torse {

/// How often a knot occurs.
template <OrderedField S>
int multiplicity(const KnotList<S>& u, const S& t) {
  return static_cast<int>(std::ranges::count_if(u.list(), [&](const S& x) { return definitely(equal(x, t)); }));
}

/// The curve with the knot t inserted until it occurs `times` times.
template <OrderedField S, class P>
Spline<S, P> with_multiplicity(Spline<S, P> curve, const S& t, int times) {
  for (int i = multiplicity(curve.knots, t); i < times; ++i) curve = insert_knot(curve, t);
  return curve;
}

/// The part of a curve between two parameters a < b of its domain, with n-fold knots at both. Throws InvalidInput
/// naming "t" for parameters outside the domain and unless a < b.
template <OrderedField S, class P>
Spline<S, P> restrict_spline(const Spline<S, P>& curve, const S& a, const S& b) {
  if (definitely(!less(a, b))) {
    throw InvalidInput("t", "expected a part of positive length, found [" + as_text(a) + ", " + as_text(b) + "]");
  }
  const int n = curve.knots.degree();
  const Spline<S, P> fine = with_multiplicity(with_multiplicity(curve, a, n), b, n);
  const std::vector<S>& u = fine.knots.list();
  const auto is = [](const S& t) { return [&](const S& x) { return definitely(equal(x, t)); }; };
  const auto first = std::ranges::find_if(u, is(a));
  const auto last = std::ranges::find_if(u, is(b)) + n;
  std::vector<S> knots(first, last);
  const auto begin = fine.control.begin() + (first - u.begin());
  std::vector<P> points(begin, begin + (std::ssize(knots) - n + 1));
  return Spline<S, P>(KnotList<S>(n, std::move(knots)), std::move(points));
}

/// The same curve over [a, b]: its parameter under the affine map that takes its domain there.
template <OrderedField S, class P>
Spline<S, P> reparametrized(const Spline<S, P>& curve, const S& a, const S& b) {
  const KnotList<S>& u = curve.knots;
  const S factor = (b - a) / (u.domain_end() - u.domain_begin());
  std::vector<S> knots;
  for (const S& t : u.list()) knots.push_back(a + factor * (t - u.domain_begin()));
  return Spline<S, P>(KnotList<S>(u.degree(), std::move(knots)), curve.control);
}

/// The same curve with the parameter begin + end - t.
template <OrderedField S, class P>
Spline<S, P> reversed_spline(const Spline<S, P>& curve) {
  const S sum = curve.knots.domain_begin() + curve.knots.domain_end();
  std::vector<S> knots;
  for (int i = curve.knots.size() - 1; i >= 0; --i) knots.push_back(sum - curve.knots[i]);
  return Spline<S, P>(KnotList<S>(curve.knots.degree(), std::move(knots)),
                      std::vector<P>(curve.control.rbegin(), curve.control.rend()));
}

/// Every knot as often as in the list, of two of one degree, that has it more often.
template <OrderedField S>
KnotList<S> united_knots(const KnotList<S>& u, const KnotList<S>& v) {
  std::vector<S> knots;
  std::ranges::set_union(u.list(), v.list(), std::back_inserter(knots),
                         [](const S& x, const S& y) { return definitely(less(x, y)); });
  return KnotList<S>(u.degree(), std::move(knots));
}

/// The same two curves, the second over the domain of the first, clamped, with the higher of their degrees and with the
/// knots of both. Nothing is done to curves that share their knots already.
template <OrderedField S, class P>
std::pair<Spline<S, P>, Spline<S, P>> make_compatible(Spline<S, P> c, Spline<S, P> d) {
  const auto same = [](const S& x, const S& y) { return definitely(equal(x, y)); };
  if (c.knots.degree() == d.knots.degree() && std::ranges::equal(c.knots.list(), d.knots.list(), same)) return {c, d};
  const S a = c.knots.domain_begin();
  const S b = c.knots.domain_end();
  d = reparametrized(d, a, b);
  c = restrict_spline(c, a, b);
  d = restrict_spline(d, a, b);
  while (c.knots.degree() < d.knots.degree()) c = elevate(c);
  while (d.knots.degree() < c.knots.degree()) d = elevate(d);
  const KnotList<S> both = united_knots(c.knots, d.knots);
  return {refined(c, both), refined(d, both)};
}

}  // namespace torse
