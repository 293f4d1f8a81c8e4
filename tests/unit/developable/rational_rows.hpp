// Homogeneous rows for tests of rational patches, and a curve by its Bernstein sum, without the library's blossoms.
#pragma once

#include <vector>

#include "nets.hpp"
#include "torse/algebra/bernstein.hpp"

namespace torse::test {

using Row = Vec<Q, 4>;

inline Q q(int num, int den) { return ratio<Q>(num, den); }

inline Row row(int w, int x, int y, int z) { return Row(Q(w), Q(x), Q(y), Q(z)); }

/// Coordinate j of the rows as a polynomial.
inline Bernstein<Q> coordinate(const std::vector<Row>& rows, int j) {
  std::vector<Q> b;
  for (const Row& x : rows) b.push_back(x[j]);
  return Bernstein<Q>(std::move(b));
}

inline Row value(const std::vector<Row>& rows, const Q& t) {
  Row x;
  for (int j = 0; j < 4; ++j) x[j] = coordinate(rows, j)(t);
  return x;
}

inline Row derivative(const std::vector<Row>& rows, const Q& t) {
  Row x;
  for (int j = 0; j < 4; ++j) x[j] = coordinate(rows, j).derivative()(t);
  return x;
}

/// rows[t^<n-1>, x] as the point p + (x-t)/n p' of the tangent.
inline Row on_tangent(const std::vector<Row>& rows, const Q& t, const Q& x) {
  const Q n(static_cast<int>(rows.size()) - 1);
  return combine<Row>(Q(1), value(rows, t), (x - t) / n, derivative(rows, t));
}

/// Whether p[t^<n-1>, Lam] = sigma q[t^<n-1>, M].
template <class Functions>
bool related(const std::vector<Row>& p, const std::vector<Row>& q, const Q& t, const Functions& f) {
  const Row left = on_tangent(p, t, f.lambda);
  const Row right = scaled<Row>(f.sigma, on_tangent(q, t, f.m));
  for (int j = 0; j < 4; ++j) {
    if (left[j] != right[j]) return false;
  }
  return true;
}

/// A cubic row whose points lie in no plane.
inline std::vector<Row> cubic_row() { return {row(1, 0, 0, 1), row(2, 3, 1, 0), row(1, 4, -1, 2), row(3, 1, 5, 1)}; }

}  // namespace torse::test
