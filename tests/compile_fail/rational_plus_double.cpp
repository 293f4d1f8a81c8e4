// error: (no match for .operator|invalid operands to binary expression)
// A double enters exact arithmetic by name only.
#include "torse/exact/rational/rational.hpp"

auto f(const torse::Rational& x, const double& y) {
#ifdef TORSE_MISUSE
  return x + y;  // misuse
#else
  return x + torse::Rational::from_double(y);
#endif
}
