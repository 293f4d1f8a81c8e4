// error: (could not convert|no viable conversion|conversion from)
// Integers are converted explicitly too, so that no function takes an index for a number.
#include "torse/exact/rational/rational.hpp"

torse::Rational f() {
#ifdef TORSE_MISUSE
  return 1;  // misuse
#else
  return torse::Rational(1);
#endif
}
