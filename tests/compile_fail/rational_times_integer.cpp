// error: (no match for .operator|invalid operands to binary expression)
// Not even an integer converts silently.
#include "torse/exact/rational/rational.hpp"

auto f(const torse::Rational& x, const int& y) {
#ifdef TORSE_MISUSE
  return x * y;  // misuse
#else
  return x * torse::Rational(y);
#endif
}
