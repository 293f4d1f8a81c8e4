// error: (no matching (function|constructor)|call to deleted constructor|conversion from)
// A double literal is not an exact number.
#include "torse/exact/bigfloat/bigfloat.hpp"

#ifdef TORSE_MISUSE
const torse::BigFloat<113> x(0.1);  // misuse
#else
const torse::BigFloat<113> x(1);
#endif
