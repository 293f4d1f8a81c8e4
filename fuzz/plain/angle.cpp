#include "torse/fuzz/plain/angle.hpp"

#include <mpfr.h>

#include "torse/fuzz/plain/length.hpp"

namespace torse::fuzz::plain {
namespace {

using Vector = Vec<Rational, 3>;

Rational scalar(const Vector& x, const Vector& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; }

Vector vector(const Vector& x, const Vector& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}

/// The derivative of the point of a row by the quotient rule.
Vector speed_of(const Row& x, const Row& dx) {
  Vector v;
  for (int j = 0; j < 3; ++j) v[j] = (dx[j + 1] * x[0] - dx[0] * x[j + 1]) / (x[0] * x[0]);
  return v;
}

/// sin^2 with every step rounded in one direction; 0 to 90 degrees, where the sine grows.
Rational sine_squared_rounded(const Rational& degrees, mpfr_rnd_t direction) {
  if (degrees >= Rational(90)) return Rational(1);
  constexpr mpfr_prec_t precision = 700;
  mpfr_t x;
  mpfr_t pi;
  mpfr_inits2(precision, x, pi, static_cast<mpfr_ptr>(nullptr));
  mpfr_const_pi(pi, direction);
  mpfr_mul_q(x, pi, (degrees / Rational(180)).mpq(), direction);
  mpfr_sin(x, x, direction);
  mpfr_sqr(x, x, direction);
  mpq_t q;
  mpq_init(q);
  mpfr_get_q(q, x);
  const Rational result = Rational::from_mpq(q);
  mpq_clear(q);
  mpfr_clears(x, pi, static_cast<mpfr_ptr>(nullptr));
  return result;
}

}  // namespace

std::optional<Rational> sine_squared(const Ruling& at) {
  if (at.p[0].sign() == 0 || at.q[0].sign() == 0) return std::nullopt;
  const Vector a = speed_of(at.p, at.dp);
  const Vector b = speed_of(at.q, at.dq);
  const Vector c = point_of(at.p);
  Vector w = point_of(at.q);
  for (int j = 0; j < 3; ++j) w[j] -= c[j];
  const Vector m = vector(a, w);
  const Vector n = vector(b, w);
  const Rational below = scalar(m, m) * scalar(n, n);
  if (below.sign() == 0) return std::nullopt;
  const Rational volume = scalar(m, b);
  return scalar(w, w) * volume * volume / below;
}

Rational sine_squared_below(const Rational& degrees) { return sine_squared_rounded(degrees, MPFR_RNDD); }
Rational sine_squared_above(const Rational& degrees) { return sine_squared_rounded(degrees, MPFR_RNDU); }

}  // namespace torse::fuzz::plain
