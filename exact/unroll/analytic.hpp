// Two scalars that carry the formulas of unroll.hpp along an interval, for .cpp files only.
//   DiscBall       values on a complex neighbourhood: what they have in common bounds the Taylor coefficients
//   BallSeries     the first Taylor coefficients of a real function, each enclosed
#pragma once

#include <algorithm>
#include <utility>

#include "torse/exact/unroll/arb_types.hpp"
#include "torse/scalar/traits.hpp"

namespace torse {

/// A complex ball with the precision of its operations. A quotient by a ball around zero is not finite, nor is the root
/// of a ball that meets the real numbers below zero: then the function may not be analytic there.
struct DiscBall {
  arb::Complex value;
  slong bits = 64;

  friend DiscBall operator+(const DiscBall& x, const DiscBall& y) { return x.with(acb_add, y); }
  friend DiscBall operator*(const DiscBall& x, const DiscBall& y) { return x.with(acb_mul, y); }
  friend DiscBall operator/(const DiscBall& x, const DiscBall& y) { return x.with(acb_div, y); }

 private:
  using Operation = void (*)(acb_struct*, const acb_struct*, const acb_struct*, slong);

  DiscBall with(Operation operation, const DiscBall& y) const {
    DiscBall z{{}, std::max(bits, y.bits)};
    operation(z.value.get(), value.get(), y.value.get(), z.bits);
    return z;
  }
};

template <>
struct ScalarTraits<DiscBall> {
  static DiscBall sqrt(const DiscBall& x) {
    DiscBall root{{}, x.bits};
    acb_sqrt_analytic(root.value.get(), x.value.get(), 1, x.bits);
    return root;
  }
};

/// A power series modulo s^order whose coefficients are balls. The constant coefficient of a denominator is not zero,
/// that of a radicand is positive, else coefficients are not finite.
struct BallSeries {
  static constexpr slong order = 20;

  arb::RealPoly value;
  slong bits = 64;

  friend BallSeries operator+(const BallSeries& x, const BallSeries& y) {
    BallSeries z = x.beside(y);
    arb_poly_add(z.value.get(), x.value.get(), y.value.get(), z.bits);
    return z;
  }
  friend BallSeries operator*(const BallSeries& x, const BallSeries& y) {
    BallSeries z = x.beside(y);
    arb_poly_mullow(z.value.get(), x.value.get(), y.value.get(), order, z.bits);
    return z;
  }
  friend BallSeries operator/(const BallSeries& x, const BallSeries& y) {
    BallSeries z = x.beside(y);
    arb_poly_div_series(z.value.get(), x.value.get(), y.value.get(), order, z.bits);
    return z;
  }

 private:
  BallSeries beside(const BallSeries& y) const { return {{}, std::max(bits, y.bits)}; }
};

template <>
struct ScalarTraits<BallSeries> {
  static BallSeries sqrt(const BallSeries& x) {
    BallSeries root{{}, x.bits};
    arb_poly_sqrt_series(root.value.get(), x.value.get(), BallSeries::order, x.bits);
    return root;
  }
};

}  // namespace torse
