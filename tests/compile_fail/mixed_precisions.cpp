// error: (no match for .operator|invalid operands to binary expression)
// Two precisions do not mix.
#include "torse/exact/bigfloat/bigfloat.hpp"

auto f(const torse::BigFloat<53>& x, const torse::BigFloat<113>& y) {
#ifdef TORSE_MISUSE
  return x - y;  // misuse
#else
  return torse::BigFloat<113>::from_rational(x.to_rational()) - y;
#endif
}
