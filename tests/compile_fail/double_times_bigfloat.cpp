// error: (no match for .operator|invalid operands to binary expression)
// A double literal carries 53 bits into a computation of 113.
#include "torse/exact/bigfloat/bigfloat.hpp"

auto f(const double& x, const torse::BigFloat<113>& y) {
#ifdef TORSE_MISUSE
  return x * y;  // misuse
#else
  return torse::BigFloat<113>::from_double(x) * y;
#endif
}
