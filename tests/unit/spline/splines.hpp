// Splines for tests: knot lists of every kind, control points, and values by the Cox-de Boor basis.
//   knot_lists      clamped, unclamped, repeated knots, empty pieces; degrees 1 to 4
//   points          control points off any special position
//   value           the curve at a parameter by basis functions
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include "support/knots.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/spline/basis.hpp"
#include "torse/spline/curve.hpp"

namespace torse::test {

using Q = Rational;
using Point2 = Vec<Q, 2>;

inline std::vector<KnotList<Q>> knot_lists() {
  return {knots(1, {0, 1}),
          knots(1, {0, 1, 3, 4}),
          knots(2, {0, 0, 1, 1}),
          knots(2, {0, 1, 2, 3}),
          knots(2, {0, 1, 1, 2, 3}),              // the first piece is empty, unclamped
          knots(2, {0, 0, 1, 1, 2, 2}),           // a corner
          knots(3, {0, 0, 0, 2, 3, 3, 5, 5, 5}),  // a double knot
          knots(3, {-2, -1, 0, 1, 4, 5, 7, 8}),
          knots(3, {0, 0, 1, 2, 2, 2, 3, 4, 4}),  // a triple knot, ends neither simple nor clamped
          knots(3, {0, 1, 2, 2, 4, 5, 5, 6, 7}),  // the first and the last piece are empty, unclamped
          knots(4, {0, 0, 0, 0, 1, 2, 2, 5, 5, 5, 5}),
          knots(4, {0, 1, 1, 3, 4, 4, 4, 6, 7, 8})};
}

inline std::vector<Point2> points(const KnotList<Q>& u, std::uint64_t seed = 1) {
  std::mt19937_64 rng(seed);
  std::vector<Point2> row;
  for (int i = 0; i <= u.last(); ++i) {
    const auto draw = [&] { return Q(static_cast<int>(rng() % 2001) - 1000) / Q(static_cast<int>(rng() % 12) + 1); };
    const Q x = draw();
    row.push_back(Point2(x, draw()));
  }
  return row;
}

/// The curve at a parameter of the proper piece k, inside it or not.
inline Point2 value(const KnotList<Q>& u, const std::vector<Point2>& c, int k, const Q& t) {
  const auto forms = piece_forms<Q, 2>(basis_forms(u, k), c, k);
  const Q s = (t - u.piece_begin(k)) / (u.piece_end(k) - u.piece_begin(k));
  return Point2(forms[0](Q(1) - s, s), forms[1](Q(1) - s, s));
}

/// The curve at a parameter of the domain.
inline Point2 value(const KnotList<Q>& u, const std::vector<Point2>& c, const Q& t) {
  const std::vector<int> pieces = u.proper_pieces();
  const auto k = std::find_if(pieces.begin(), pieces.end() - 1, [&](int piece) { return t < u.piece_end(piece); });
  return value(u, c, *k, t);
}

/// Parameters of the domain: every knot in it and points between them.
inline std::vector<Q> parameters(const KnotList<Q>& u) {
  std::vector<Q> list;
  for (int k : u.proper_pieces()) {
    for (int i = 0; i <= 6; ++i) {
      list.push_back(u.piece_begin(k) + Q(i) / Q(6) * (u.piece_end(k) - u.piece_begin(k)));
    }
  }
  return list;
}

}  // namespace torse::test
