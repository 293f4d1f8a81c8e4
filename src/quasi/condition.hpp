// The developability conditions of BZZ19, section 3.3, at one ruling between C1(t) and C2(T).
//   ruling_determinant                 E1 (BZZ19.6)
//   NormalProducts, normal_products    what E2 is made of (BZZ19.7)     normal_residual    E2 (BZZ19.8)
//   unit_penalty                       what keeps the normal from vanishing
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

/// The three products that BZZ19.7 makes zero.
template <class S>
struct NormalProducts {
  S with_a;
  S with_b;
  S with_w;
};

/// N . a, N . b, N . w.
template <Field S>
NormalProducts<S> normal_products(const Vec<S, 3>& normal, const Vec<S, 3>& w, const Vec<S, 3>& a, const Vec<S, 3>& b) {
  return {dot(normal, a), dot(normal, b), dot(normal, w)};
}

/// E2 = (N.a)^2 + (N.b)^2 + (N.w)^2 (BZZ19.8). Over the unit vectors N its least value is 0 iff E1 is 0.
template <Field S>
S normal_residual(const NormalProducts<S>& products) {
  S total = from_int<S>(0);
  for (const S* product : {&products.with_a, &products.with_b, &products.with_w}) {
    add_product(total, *product, *product);
  }
  return total;
}

template <Field S>
S normal_residual(const Vec<S, 3>& normal, const Vec<S, 3>& w, const Vec<S, 3>& a, const Vec<S, 3>& b) {
  return normal_residual<S>(normal_products<S>(normal, w, a, b));
}

/// (|N|^2 - 1)^2 (BZZ19, section 3.3, F_Reg).
template <Field S>
S unit_penalty(const Vec<S, 3>& normal) {
  const S excess = dot(normal, normal) - from_int<S>(1);
  return excess * excess;
}

}  // namespace torse
