// The same curve over more knots.
//   pieces_under     for each knot of a finer list, a piece of the coarse list
//   refined          the curve over a finer list
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "torse/spline/curve.hpp"

namespace torse {

/// For each knot of v the proper piece of u that starts there or holds it, the last one from the end of the domain on;
/// 0 for the knots before the start of the domain. v has all knots of u from the start to the end of the domain.
template <Field S>
std::vector<int> pieces_under(const KnotList<S>& u, const std::vector<S>& v) {
  const std::vector<int> pieces = u.proper_pieces();
  std::vector<int> under;
  under.reserve(v.size());
  std::size_t at = 0;
  bool inside = false;
  for (const S& t : v) {
    inside = inside || definitely(equal(u.piece_begin(pieces[0]), t));
    if (inside && at + 1 < pieces.size() && definitely(equal(u.piece_end(pieces[at]), t))) ++at;
    under.push_back(inside ? pieces[at] : 0);
  }
  return under;
}

/// A piece whose polynomial determines the vertex of v that belongs to the knots v_i..v_{i+n-1}, n being v's degree:
/// that of the first of these knots which has one. Throws Undecided where none has.
template <Field S>
int piece_of_vertex(const std::vector<int>& under, const KnotList<S>& v, int i) {
  for (int j = i; j < i + v.degree(); ++j) {
    if (const int k = under[static_cast<std::size_t>(j)]) return k;
  }
  throw Undecided("refinement: no piece found under a vertex");
}

/// The curve over the knots v of the same degree, which hold its own from the start to the end of the domain: vertex i
/// is the blossom at v_i..v_{i+n-1}. The time is that of L + 1 blossoms.
template <Field S, class P>
Spline<S, P> refined(const Spline<S, P>& curve, KnotList<S> v) {
  const std::vector<int> under = pieces_under(curve.knots, v.list());
  std::vector<P> points;
  points.reserve(static_cast<std::size_t>(v.last()) + 1);
  for (int i = 0; i <= v.last(); ++i) {
    std::vector<Parameter<S>> arguments;
    for (int j = i; j < i + v.degree(); ++j) arguments.push_back(at(v[j]));
    points.push_back(blossom<S, P>(curve.knots, curve.points(), piece_of_vertex(under, v, i), arguments));
  }
  return Spline<S, P>(std::move(v), std::move(points));
}

}  // namespace torse
