#include "torse/fuzz/plain/length.hpp"

#include <mpfr.h>

namespace torse::fuzz::plain {
namespace {

Rational root(const Rational& x, mpfr_rnd_t direction) {
  constexpr mpfr_prec_t precision = 160;
  mpfr_t value;
  mpfr_init2(value, precision);
  mpfr_set_q(value, x.mpq(), direction);
  mpfr_sqrt(value, value, direction);
  mpq_t q;
  mpq_init(q);
  mpfr_get_q(q, value);
  const Rational result = Rational::from_mpq(q);
  mpq_clear(q);
  mpfr_clear(value);
  return result;
}

}  // namespace

Rational root_below(const Rational& x) { return root(x, MPFR_RNDD); }
Rational root_above(const Rational& x) { return root(x, MPFR_RNDU); }

Rational squared_distance(const Point& x, const Point& y) {
  Rational sum;
  for (int j = 0; j < 3; ++j) sum += (x[j] - y[j]) * (x[j] - y[j]);
  return sum;
}

Point point_of(const Row& x) { return {x[1] / x[0], x[2] / x[0], x[3] / x[0]}; }

}  // namespace torse::fuzz::plain
