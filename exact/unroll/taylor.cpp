// Power series and discs.
#include "torse/exact/unroll/taylor.hpp"

#include <utility>

namespace torse {
namespace {

using Q = Rational;
using arb::Complex;
using arb::ComplexPoly;
using arb::Real;
using arb::RealPoly;

constexpr slong ratio_bits = 4;  // rho = 2^ratio_bits eta

/// A function may not be analytic on the disc.
struct TooLong {};

/// The middle and half of the length of a step.
struct Span {
  Real middle;
  Real half;

  Span(const Q& from, const Q& to, slong bits)
      : middle(arb::real((from + to) / Q(2), bits)), half(arb::real((to - from) / Q(2), bits)) {}
};

/// The values of a polynomial, given as its Taylor series, on the disc of this radius around the middle.
DiscBall on_disc(const RealPoly& f, const Real& radius, slong bits) {
  DiscBall result{{}, bits};
  if (arb_poly_length(f.get()) == 0) return result;
  mag_t reach;
  mag_t spread;
  mag_t size;
  mag_init(reach);
  mag_init(spread);
  mag_init(size);
  arb_get_mag(reach, radius.get());
  for (slong i = arb_poly_length(f.get()) - 1; i > 0; --i) {
    arb_get_mag(size, f.get()->coeffs + i);
    mag_add(spread, spread, size);
    mag_mul(spread, spread, reach);
  }
  acb_set_arb(result.value.get(), f.get()->coeffs);
  acb_add_error_mag(result.value.get(), spread);
  mag_clear(reach);
  mag_clear(spread);
  mag_clear(size);
  return result;
}

/// An upper bound of |z|, as an exact number.
Real magnitude(const DiscBall& z) {
  if (acb_is_finite(z.value.get()) == 0) throw TooLong();
  Real size;
  acb_abs(size.get(), z.value.get(), z.bits);
  arb_get_ubound_arf(arb_midref(size.get()), size.get(), z.bits);
  mag_zero(arb_radref(size.get()));
  return size;
}

/// The primitive of a function at s = eta or -eta (0 at s = 0), from its Taylor series and a bound of its values.
Real primitive_at(const RealPoly& f, const Real& bound, const Real& eta, bool end, slong bits) {
  RealPoly primitive;
  arb_poly_integral(primitive.get(), f.get(), bits);
  Real at = eta;
  if (!end) arb_neg(at.get(), at.get());
  Real value;
  arb_poly_evaluate(value.get(), primitive.get(), at.get(), bits);
  Real rest;
  arb_mul(rest.get(), bound.get(), eta.get(), bits);
  arb_mul_2exp_si(rest.get(), rest.get(), 1 - ratio_bits * BallSeries::order);
  arb_add_error(value.get(), rest.get());
  return value;
}

/// The integral over the step.
Real increase(const RealPoly& f, const Real& bound, const Real& eta, slong bits) {
  Real to = primitive_at(f, bound, eta, true, bits);
  const Real from = primitive_at(f, bound, eta, false, bits);
  arb_sub(to.get(), to.get(), from.get(), bits);
  return to;
}

/// e^{-ix}.
Complex clockwise(const Real& x, slong bits) {
  Complex z;
  arb_sin_cos(acb_imagref(z.get()), acb_realref(z.get()), x.get(), bits);
  acb_conj(z.get(), z.get());
  return z;
}

/// (along - i across) e^{-iT} as a series.
ComplexPoly turned_speed(const StripRates<BallSeries>& rates, slong bits) {
  RealPoly angle;
  arb_poly_integral(angle.get(), rates.turn.value.get(), bits);
  arb_poly_neg(angle.get(), angle.get());
  ComplexPoly rotation;
  acb_poly_set2_arb_poly(rotation.get(), RealPoly().get(), angle.get());
  acb_poly_exp_series(rotation.get(), rotation.get(), BallSeries::order, bits);
  RealPoly down = rates.across_c.value;
  arb_poly_neg(down.get(), down.get());
  ComplexPoly speed;
  acb_poly_set2_arb_poly(speed.get(), rates.along.value.get(), down.get());
  acb_poly_mullow(speed.get(), speed.get(), rotation.get(), BallSeries::order, bits);
  return speed;
}

/// Its integral over the step, turned back by T(-eta): the chord for a ruling along 1 at the beginning.
Complex chord_of(const ComplexPoly& speed, const Real& bound, const Real& turn_before, const Real& eta, slong bits) {
  RealPoly x;
  RealPoly y;
  for (slong i = 0; i < acb_poly_length(speed.get()); ++i) {
    arb_poly_set_coeff_arb(x.get(), i, acb_realref(speed.get()->coeffs + i));
    arb_poly_set_coeff_arb(y.get(), i, acb_imagref(speed.get()->coeffs + i));
  }
  Complex chord;
  acb_set_arb_arb(chord.get(), increase(x, bound, eta, bits).get(), increase(y, bound, eta, bits).get());
  Complex back = clockwise(turn_before, bits);
  acb_conj(back.get(), back.get());
  acb_mul(chord.get(), chord.get(), back.get(), bits);
  return chord;
}

Step step_over(const Stretch& stretch, const Span& span) {
  const slong bits = stretch.bits();
  const Real& eta = span.half;
  const Strip<RealPoly> taylor = stretch.around(span.middle);
  Real rho;
  arb_mul_2exp_si(rho.get(), eta.get(), ratio_bits);
  const StripRates<DiscBall> disc =
      strip_rates(taylor.transformed([&](const RealPoly& f) { return on_disc(f, rho, bits); }));
  const Real turn_bound = magnitude(disc.turn);
  Real angle;
  arb_mul(angle.get(), turn_bound.get(), rho.get(), bits);
  if (arb_le(angle.get(), arb::real(Q(1), bits).get()) == 0) throw TooLong();
  Real speed_bound = magnitude(disc.along);
  arb_add(speed_bound.get(), speed_bound.get(), magnitude(disc.across_c).get(), bits);
  arb_mul_ui(speed_bound.get(), speed_bound.get(), 3, bits);  // e < 3

  const StripRates<BallSeries> series = strip_rates(taylor.transformed([&](const RealPoly& f) {
    BallSeries x{f, bits};
    arb_poly_truncate(x.value.get(), BallSeries::order);
    return x;
  }));
  const Real before = primitive_at(series.turn.value, turn_bound, eta, false, bits);
  Step step;
  step.turn = increase(series.turn.value, turn_bound, eta, bits);
  step.chord = chord_of(turned_speed(series, bits), speed_bound, before, eta, bits);
  step.length_c = increase(series.speed_c.value, magnitude(disc.speed_c), eta, bits);
  step.length_d = increase(series.speed_d.value, magnitude(disc.speed_d), eta, bits);
  step.area = increase(series.swept.value, magnitude(disc.swept), eta, bits);
  return step;
}

}  // namespace

std::optional<Step> taylor_step(const Stretch& stretch, const Q& from, const Q& to) {
  try {
    return step_over(stretch, Span(from, to, stretch.bits()));
  } catch (const TooLong&) {
    return std::nullopt;
  }
}

Step breaking_step(const Stretch& stretch) {
  const slong bits = stretch.bits();
  const Span span(stretch.from(), stretch.to(), bits);
  Complex tau;
  acb_set_arb(tau.get(), span.middle.get());
  arb_add_error(acb_realref(tau.get()), span.half.get());
  const Strip<DiscBall> f = stretch.at(tau);
  const auto at_most = [&](const DiscBall& rate) {
    Real x;
    Real size = magnitude(rate);
    arb_mul(size.get(), size.get(), span.half.get(), bits);
    arb_mul_2exp_si(size.get(), size.get(), 1);
    arb_add_error(x.get(), size.get());
    return x;
  };
  Step step;
  DiscBall spin{{}, bits};
  arb_sqrt(acb_realref(spin.value.get()), magnitude(f.spin2).get(), bits);
  step.turn = at_most(spin / f.ruling2);
  step.length_c = at_most(speed_c(f));
  step.length_d = at_most(speed_d(f));
  step.area = at_most(planar_density(f));
  acb_set_arb_arb(step.chord.get(), step.length_c.get(), step.length_c.get());
  return step;
}

}  // namespace torse
