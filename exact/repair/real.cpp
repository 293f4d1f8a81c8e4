// Rounding by GMP, simplest fractions by FLINT.
#include "torse/exact/repair/real.hpp"

#include <flint/fmpq.h>

namespace torse::repair {

Real magnitude(const Real& x) { return x < Real(0) ? -x : x; }

Rational power_of_two(long exponent) {
  mpq_t q;
  mpq_init(q);
  mpq_set_ui(q, 1, 1);
  if (exponent >= 0) {
    mpq_mul_2exp(q, q, static_cast<mp_bitcnt_t>(exponent));
  } else {
    mpq_div_2exp(q, q, static_cast<mp_bitcnt_t>(-exponent));
  }
  Rational power = Rational::from_mpq(q);
  mpq_clear(q);
  return power;
}

long exponent_of(const Real& x) { return mpfr_zero_p(x.mpfr()) != 0 ? mpfr_get_emin() : mpfr_get_exp(x.mpfr()); }

Rational rounded(const Real& x, long exponent) { return rounded(x.to_rational(), exponent); }

Rational rounded(const Rational& x, long exponent) {
  const Rational unit = power_of_two(exponent);
  const Rational units = x / unit + ratio<Rational>(1, 2);
  mpq_t whole;
  mpq_init(whole);
  mpz_fdiv_q(mpq_numref(whole), mpq_numref(units.mpq()), mpq_denref(units.mpq()));
  Rational result = Rational::from_mpq(whole) * unit;
  mpq_clear(whole);
  return result;
}

Rational simplest_near(const Real& x, const Real& tolerance) {
  const Rational low = (x - tolerance).to_rational();
  const Rational high = (x + tolerance).to_rational();
  if (low.sign() <= 0 && high.sign() >= 0) return Rational(0);
  fmpq_t a, b, simplest;
  fmpq_init(a);
  fmpq_init(b);
  fmpq_init(simplest);
  fmpq_set_mpq(a, low.mpq());
  fmpq_set_mpq(b, high.mpq());
  fmpq_simplest_between(simplest, a, b);
  mpq_t q;
  mpq_init(q);
  fmpq_get_mpq(q, simplest);
  Rational result = Rational::from_mpq(q);
  mpq_clear(q);
  fmpq_clear(a);
  fmpq_clear(b);
  fmpq_clear(simplest);
  return result;
}

}  // namespace torse::repair
