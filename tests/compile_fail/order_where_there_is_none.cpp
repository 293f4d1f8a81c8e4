// error: (no matching function|constraint)
// A prime field has no order.
#include "torse/exact/modular/zp.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/scalar/concepts.hpp"

template <torse::OrderedField S>
torse::Truth positive(const S& x) {
  return torse::less(torse::from_int<S>(0), x);
}

#ifdef TORSE_MISUSE
const torse::Truth t = positive(torse::Zp(1));  // misuse
#else
const torse::Truth t = positive(torse::Rational(1));
#endif
