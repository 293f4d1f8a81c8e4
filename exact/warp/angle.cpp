// Sines and arc sines through Arb.
#include "torse/exact/warp/angle.hpp"

#include <gmp.h>

#include <flint/fmpq.h>

#include <arb.h>

#include <algorithm>

namespace torse {
namespace {

constexpr slong precision = 128;

/// A real ball.
class Real {
 public:
  Real() { arb_init(x_); }
  Real(const Real&) = delete;
  Real& operator=(const Real&) = delete;
  ~Real() { arb_clear(x_); }

  arb_ptr get() { return x_; }

  /// The ends, rounded outwards; they may be infinite.
  Interval enclosure() {
    arf_t end;
    arf_init(end);
    arb_get_lbound_arf(end, x_, 2 * precision);
    const double lower = arf_get_d(end, ARF_RND_FLOOR);
    arb_get_ubound_arf(end, x_, 2 * precision);
    const double upper = arf_get_d(end, ARF_RND_CEIL);
    arf_clear(end);
    return Interval::hull(lower, upper);
  }

 private:
  arb_t x_;
};

void set_rational(Real& x, const Rational& q) {
  fmpq_t f;
  fmpq_init(f);
  fmpq_set_mpq(f, q.mpq());
  arb_set_fmpq(x.get(), f, precision);
  fmpq_clear(f);
}

/// asin(sqrt(sine2 / 4^scale)) in degrees.
void set_degrees(Real& angle, double sine2, long scale) {
  Real pi;
  arb_set_d(angle.get(), sine2);
  arb_mul_2exp_si(angle.get(), angle.get(), -2 * scale);
  arb_sqrt(angle.get(), angle.get(), precision);
  arb_asin(angle.get(), angle.get(), precision);
  arb_mul_ui(angle.get(), angle.get(), 180, precision);
  arb_const_pi(pi.get(), precision);
  arb_div(angle.get(), angle.get(), pi.get(), precision);
}

bool right_or_more(const Angle& angle) {
  if (!angle.radians) return angle.value >= Rational(90);
  Real x;
  Real half_turn;
  set_rational(x, angle.value);
  arb_mul_2exp_si(x.get(), x.get(), 1);
  arb_const_pi(half_turn.get(), precision);
  return arb_ge(x.get(), half_turn.get()) != 0;
}

}  // namespace

Interval sine_squared_at_most_90(const Angle& angle, long scale) {
  Real x;
  if (const std::optional<Rational> exact = exact_sine_squared(angle)) {
    set_rational(x, *exact);
  } else {
    set_rational(x, angle.value);
    if (angle.radians) {
      arb_sin(x.get(), x.get(), precision);
    } else {
      arb_div_ui(x.get(), x.get(), 180, precision);
      arb_sin_pi(x.get(), x.get(), precision);
    }
    arb_mul(x.get(), x.get(), x.get(), precision);
  }
  arb_mul_2exp_si(x.get(), x.get(), 2 * scale);
  const Interval enclosure = x.enclosure();
  return Interval::hull(std::clamp(enclosure.lower(), 0.0, std::numeric_limits<double>::max()), enclosure.upper());
}

std::optional<Rational> exact_sine_squared(const Angle& angle) {
  if (angle.value.sign() == 0) return Rational(0);
  if (right_or_more(angle)) return Rational(1);
  if (angle.radians) return std::nullopt;
  if (angle.value == Rational(30)) return Rational(1) / Rational(4);
  if (angle.value == Rational(45)) return Rational(1) / Rational(2);
  if (angle.value == Rational(60)) return Rational(3) / Rational(4);
  return std::nullopt;
}

Interval degrees_of(double lower, double upper, long scale) {
  Real low;
  Real high;
  set_degrees(low, lower, scale);
  if (scale == 0 && upper >= 1) return Interval::hull(std::clamp(low.enclosure().lower(), 0.0, 90.0), 90);
  set_degrees(high, upper, scale);
  return Interval::hull(std::clamp(low.enclosure().lower(), 0.0, 90.0),
                        arb_is_finite(high.get()) != 0 ? std::clamp(high.enclosure().upper(), 0.0, 90.0) : 90.0);
}

}  // namespace torse
