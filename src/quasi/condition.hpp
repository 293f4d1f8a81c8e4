// The developability conditions of BZZ19, section 3.3, at one ruling between C1(t) and C2(T).
//   ruling_determinant      E1 (BZZ19.6)
//   normal_residual         E2 (BZZ19.8)
#pragma once

#include "torse/algebra/determinant.hpp"
#include "torse/algebra/point.hpp"

namespace torse {

/// E1 = [C1(t) - C2(T), C1'(t), C2'(T)] (BZZ19.6) for the ruling w = C1(t) - C2(T) and the tangents a = C1'(t), b =
/// C2'(T). The ruled surface over T = sigma(t) is developable along the ruling iff sigma'(t) E1 = 0.
template <Field S>
S ruling_determinant(const Vec<S, 3>& w, const Vec<S, 3>& a, const Vec<S, 3>& b) {
  return det3(w, a, b);
}

/// E2 = (N.a)^2 + (N.b)^2 + (N.w)^2 (BZZ19.8). Over the unit vectors N its least value is 0 iff E1 is 0.
template <Field S>
S normal_residual(const Vec<S, 3>& normal, const Vec<S, 3>& w, const Vec<S, 3>& a, const Vec<S, 3>& b) {
  S total = from_int<S>(0);
  for (const Vec<S, 3>* x : {&a, &b, &w}) {
    const S product = dot(normal, *x);
    add_product(total, product, product);
  }
  return total;
}

}  // namespace torse
