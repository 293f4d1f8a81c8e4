// error: (no match for .operator|invalid operands to binary expression)
// Comparing with a double would hide its rounding.
#include "torse/exact/rational/rational.hpp"

auto f(const torse::Rational& x, const double& y) {
#ifdef TORSE_MISUSE
  return x == y;  // misuse
#else
  return x == torse::Rational::from_double(y);
#endif
}
