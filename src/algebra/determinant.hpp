// Determinants without division, in any commutative ring.
//   det2, det3, det4        dot, cross
#pragma once

#include "torse/algebra/eigen.hpp"
#include "torse/scalar/traits.hpp"

namespace torse {

/// a d - b c.
template <class S>
S det2(const S& a, const S& b, const S& c, const S& d) {
  return a * d - b * c;
}

/// a . b.
template <class S>
S dot(const Vec<S, 3>& a, const Vec<S, 3>& b) {
  S value = a[0] * b[0];
  add_product(value, a[1], b[1]);
  add_product(value, a[2], b[2]);
  return value;
}

/// a x b.
template <class S>
Vec<S, 3> cross(const Vec<S, 3>& a, const Vec<S, 3>& b) {
  Vec<S, 3> c;
  c[0] = det2(a[1], a[2], b[1], b[2]);
  c[1] = det2(a[2], a[0], b[2], b[0]);
  c[2] = det2(a[0], a[1], b[0], b[1]);
  return c;
}

/// [a, b, c] = a . (b x c).
template <class S>
S det3(const Vec<S, 3>& a, const Vec<S, 3>& b, const Vec<S, 3>& c) {
  S value = a[0] * det2(b[1], b[2], c[1], c[2]);
  add_product(value, a[1], det2(b[2], b[0], c[2], c[0]));
  add_product(value, a[2], det2(b[0], b[1], c[0], c[1]));
  return value;
}

/// The determinant of the rows a, b, c, d: Laplace expansion along the first two rows, six products of 2x2 minors.
template <class S>
S det4(const Vec<S, 4>& a, const Vec<S, 4>& b, const Vec<S, 4>& c, const Vec<S, 4>& d) {
  const auto upper = [&](int i, int j) { return det2(a[i], a[j], b[i], b[j]); };
  const auto lower = [&](int i, int j) { return det2(c[i], c[j], d[i], d[j]); };
  S value = upper(0, 1) * lower(2, 3);
  add_product(value, upper(0, 2), lower(3, 1));
  add_product(value, upper(0, 3), lower(1, 2));
  add_product(value, upper(1, 2), lower(0, 3));
  add_product(value, upper(1, 3), lower(2, 0));
  add_product(value, upper(2, 3), lower(0, 1));
  return value;
}

}  // namespace torse
