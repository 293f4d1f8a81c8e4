// Nets for tests of the constructions: rational points, and the oracle's verdict.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "support/knots.hpp"
#include "support/refusal.hpp"
#include "torse/developable/condition.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/spline/curve.hpp"

namespace torse::test {

using Q = Rational;
using Point3 = Vec<Q, 3>;

inline Point3 point(int x, int y, int z) { return Point3(Q(x), Q(y), Q(z)); }

/// Clamped and not, with repeated knots and an empty piece; degrees 1 to 4. None contains -1 or 9.
inline std::vector<KnotList<Q>> knot_lists() {
  return {knots(1, {0, 1, 3, 4}),
          knots(2, {0, 0, 1, 1}),
          knots(2, {0, 1, 1, 2, 3}),
          knots(2, {0, 0, 1, 1, 2, 2}),
          knots(3, {0, 0, 0, 2, 3, 3, 5, 5, 5}),
          knots(3, {0, 1, 2, 3, 4, 5, 7, 8}),
          knots(4, {0, 1, 1, 3, 4, 4, 4, 6, 7, 8})};
}

inline std::vector<Point3> points(int count, std::uint64_t seed = 1) {
  std::mt19937_64 rng(seed);
  std::vector<Point3> row;
  for (int i = 0; i < count; ++i) {
    const auto draw = [&] { return Q(static_cast<int>(rng() % 201) - 100) / Q(static_cast<int>(rng() % 5) + 1); };
    const Q x = draw();
    const Q y = draw();
    row.push_back(Point3(x, y, draw()));
  }
  return row;
}

/// Whether the determinant of every piece vanishes identically.
inline bool developable(const KnotList<Q>& u, const std::vector<Point3>& c, const std::vector<Point3>& d) {
  return !find_witness<Q, 3>(u, c, d);
}

}  // namespace torse::test
