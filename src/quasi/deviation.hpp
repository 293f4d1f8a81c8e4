// How far two ruled B-spline surfaces are apart, parameter by parameter.
//   largest_deviation     an upper bound by the convex hulls of their difference
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "torse/algebra/determinant.hpp"
#include "torse/developable/ruled.hpp"
#include "torse/quasi/surface.hpp"

namespace torse {

/// An upper bound of |x(s, t) - y(s, t)|^2 over all 0 <= s <= 1 and t in the common domain. Every breakpoint of the
/// coarser surface x is one of y. On each piece of y the difference is a Bezier surface, and no point of it is longer
/// than the longest of its control points. With exact scalars the bound is exact; in floating arithmetic it is rounded.
template <OrderedField S>
S largest_deviation(const RuledSpline<S, Vec<S, 3>>& x, const RuledSpline<S, Vec<S, 3>>& y) {
  using P = Vec<S, 3>;
  const int degree = std::max(x.knots.degree(), y.knots.degree());
  S largest = from_int<S>(0);
  for (int k : y.knots.proper_pieces()) {
    const S& a = y.knots.piece_begin(k);
    const S& b = y.knots.piece_end(k);
    const int j = piece_at(x.knots, a);
    for (const bool second : {false, true}) {
      const std::vector<P> of_x = restricted_points(x.knots, second ? x.d_row() : x.c_row(), j, a, b);
      const std::vector<P> of_y = bezier_points(y.knots, second ? y.d_row() : y.c_row(), k);
      const std::vector<P> fine_x = elevated_points<S, P>(of_x, degree);
      const std::vector<P> fine_y = elevated_points<S, P>(of_y, degree);
      for (std::size_t i = 0; i < fine_x.size(); ++i) {
        const P rest = difference(fine_x[i], fine_y[i]);
        const S square = dot(rest, rest);
        if (definitely(less(largest, square))) largest = square;
      }
    }
  }
  return largest;
}

}  // namespace torse
