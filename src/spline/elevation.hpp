// Degree elevation of splines with several pieces, by blossoms.
//   elevated_knots    every knot once more
//   elevate           the same curve with degree n + 1
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "torse/spline/refinement.hpp"

namespace torse {

/// Each group of equal knots once more, cut to n + 1 knots up to the start and from the end of the domain. Needs a
/// field whose zero test is decided on the knots; throws Undecided otherwise.
template <Field S>
KnotList<S> elevated_knots(const KnotList<S>& u) {
  const int n = u.degree();
  std::vector<S> raised;
  std::size_t begin = 0;  // entries of `raised` up to and including the group of the domain's start
  std::size_t end = 0;    // entries before the group of the domain's end
  std::size_t group = 0;  // entries before the group of u_i
  for (int i = 0; i < u.size(); ++i) {
    const Truth closes = i + 1 == u.size() ? Truth::yes : !equal(u[i], u[i + 1]);
    if (closes == Truth::unknown) throw Undecided("degree elevation: equality of knots is not decided");
    if (i == u.last()) end = group;
    raised.push_back(u[i]);
    if (!definitely(closes)) continue;
    raised.push_back(u[i]);
    group = raised.size();
    if (i >= n - 1 && begin == 0) begin = group;
  }
  const auto first = raised.begin() + static_cast<std::ptrdiff_t>(begin) - (n + 1);
  const auto last = raised.begin() + static_cast<std::ptrdiff_t>(end) + (n + 1);
  return KnotList<S>(n + 1, std::vector<S>(first, last));
}

/// The same curve with degree n + 1: each vertex is the mean of the n + 1 blossoms that leave one knot out.
template <Field S, class P>
Spline<S, P> elevate(const Spline<S, P>& curve) {
  const KnotList<S>& u = curve.knots;
  const int n = u.degree();
  KnotList<S> v = elevated_knots(u);
  const std::vector<int> under = pieces_under(u, v.list());
  std::vector<P> points;
  for (int i = 0; i <= v.last(); ++i) {
    const int k = piece_of_vertex(under, v, i);
    P mean = PointTraits<P>::zero();
    for (int skip = 0; skip <= n; ++skip) {
      std::vector<Parameter<S>> arguments;
      for (int j = 0; j <= n; ++j) {
        if (j != skip) arguments.push_back(at(v[i + j]));
      }
      add(mean, blossom<S, P>(u, curve.points(), k, arguments));
    }
    divide(mean, from_int<S>(n + 1));
    points.push_back(std::move(mean));
  }
  return Spline<S, P>(std::move(v), std::move(points));
}

}  // namespace torse
