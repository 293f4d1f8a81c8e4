// error: (no matching (function|constructor)|call to deleted constructor|conversion from)
// A double literal is not an exact number.
#include "torse/exact/instrumented/degree.hpp"

#ifdef TORSE_MISUSE
const torse::Degree x(0.1);  // misuse
#else
const torse::Degree x(1);
#endif
