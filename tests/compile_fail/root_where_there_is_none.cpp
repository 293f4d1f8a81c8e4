// error: (no matching function|constraint)
// The rational numbers have no square roots.
#include "torse/exact/bigfloat/bigfloat.hpp"
#include "torse/scalar/concepts.hpp"

template <torse::RealField S>
S root(const S& x) {
  return torse::ScalarTraits<S>::sqrt(x);
}

#ifdef TORSE_MISUSE
const torse::Rational x = root(torse::Rational(4));  // misuse
#else
const torse::BigFloat<113> x = root(torse::BigFloat<113>(4));
#endif
