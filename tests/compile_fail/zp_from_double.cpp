// error: (no matching (function|constructor)|call to deleted constructor|conversion from)
// A double literal is not an exact number.
#include "torse/exact/modular/zp.hpp"

#ifdef TORSE_MISUSE
const torse::Zp x(0.1);  // misuse
#else
const torse::Zp x(1);
#endif
