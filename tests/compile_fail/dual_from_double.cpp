// error: (no matching (function|constructor)|call to deleted constructor|conversion from)
// A double literal is not an exact number.
#include "torse/exact/instrumented/dual.hpp"
#include "torse/exact/rational/rational.hpp"

#ifdef TORSE_MISUSE
const torse::Dual<torse::Rational> x(0.1);  // misuse
#else
const torse::Dual<torse::Rational> x(1);
#endif
