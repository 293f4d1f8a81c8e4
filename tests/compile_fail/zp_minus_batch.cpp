// error: (no match for .operator|invalid operands to binary expression)
// One lane and 64 lanes do not mix.
#include "torse/exact/modular/batch.hpp"
#include "torse/exact/modular/zp.hpp"

auto f(const torse::Zp& x, const torse::Batch& y) {
#ifdef TORSE_MISUSE
  return x - y;  // misuse
#else
  return x - torse::Zp(*y.modulus(), y.value(0));
#endif
}
