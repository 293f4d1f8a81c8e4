// Points are not scalars: an algorithm takes the scalar S and the point type P apart and touches points only through
//   add(y, x)   y += x    subtract(y, x)   y -= x    add_scaled(y, a, x)   y += a x    scale(y, a)   y *= a divide(y,
//   a)   y /= a combine(a, x, b, y)   a x + b y        scaled(a, x)   a x        sum(x, y)   x + y        difference(x,
//   y)   x - y
// P is Vec<S, D> (coordinates) or Form<S> (a free module: every control point a generator, see free_module.hpp).
#pragma once

#include <concepts>
#include <type_traits>
#include <utility>

#include "torse/algebra/eigen.hpp"

namespace torse {

template <class S, int D>
void add(Vec<S, D>& y, const Vec<S, D>& x) {
  for (int i = 0; i < D; ++i) y[i] += x[i];
}

template <class S, int D>
void subtract(Vec<S, D>& y, const Vec<S, D>& x) {
  for (int i = 0; i < D; ++i) y[i] -= x[i];
}

template <class S, int D>
void add_scaled(Vec<S, D>& y, const std::type_identity_t<S>& a, const Vec<S, D>& x) {
  for (int i = 0; i < D; ++i) add_product(y[i], a, x[i]);
}

template <class S, int D>
void scale(Vec<S, D>& y, const std::type_identity_t<S>& a) {
  for (int i = 0; i < D; ++i) y[i] *= a;
}

/// y /= a. Throws DivisionByZero for a known zero in an exact field.
template <class S, int D>
void divide(Vec<S, D>& y, const std::type_identity_t<S>& a) {
  if constexpr (D > 1 && ScalarTraits<S>::prefers_reciprocal) {
    scale(y, from_int<S>(1) / a);
  } else {
    for (int i = 0; i < D; ++i) y[i] /= a;
  }
}

/// The scalar of a point type and its zero.
template <class P>
struct PointTraits;

template <class S, int D>
struct PointTraits<Vec<S, D>> {
  using Scalar = S;
  static Vec<S, D> zero() { return Vec<S, D>::Constant(from_int<S>(0)); }
};

/// A module over S whose elements stand for points, vectors or homogeneous rows.
template <class P, class S>
concept Point = std::copyable<P> && std::same_as<typename PointTraits<P>::Scalar, S> &&
    requires(P& y, const P& x, const S& a) {
  add(y, x);
  subtract(y, x);
  add_scaled(y, a, x);
  scale(y, a);
  divide(y, a);
  { PointTraits<P>::zero() } -> std::same_as<P>;
};

template <class P>
using ScalarOf = typename PointTraits<P>::Scalar;

/// a x + b y.
template <class P>
P combine(const ScalarOf<P>& a, P x, const ScalarOf<P>& b, const P& y) {
  scale(x, a);
  add_scaled(x, b, y);
  return x;
}

/// a x.
template <class P>
P scaled(const ScalarOf<P>& a, P x) {
  scale(x, a);
  return x;
}

/// x - y.
template <class P>
P difference(P x, const P& y) {
  subtract(x, y);
  return x;
}

/// x + y.
template <class P>
P sum(P x, const P& y) {
  add(x, y);
  return x;
}

}  // namespace torse
