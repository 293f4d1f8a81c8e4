// error: (no matching (function|constructor)|call to deleted constructor|conversion from)
// A double literal is not an exact number.
#include "torse/exact/ball/ball.hpp"

#ifdef TORSE_MISUSE
const torse::Ball<64> x(0.1);  // misuse
#else
const torse::Ball<64> x(1);
#endif
