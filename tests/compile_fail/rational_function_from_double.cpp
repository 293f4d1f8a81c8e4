// error: (no matching (function|constructor)|call to deleted constructor|conversion from)
// A double literal is not an exact number.
#include "torse/exact/symbolic/rational_function.hpp"

#ifdef TORSE_MISUSE
const torse::RationalFunction x(0.1);  // misuse
#else
const torse::RationalFunction x(1);
#endif
