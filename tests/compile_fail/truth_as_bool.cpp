// error: (could not convert|value of type .* is not contextually convertible to)
// An uncertain answer is not a bool: the caller says what `unknown` means.
#include "torse/exact/rational/rational.hpp"

int f(const torse::Rational& x) {
#ifdef TORSE_MISUSE
  if (torse::is_zero(x)) return 0;  // misuse
#else
  if (definitely(torse::is_zero(x))) return 0;
#endif
  return 1;
}
