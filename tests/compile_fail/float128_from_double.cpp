// error: (no matching (function|constructor)|call to deleted constructor|conversion from)
// A double enters by name only.
#include "torse/exact/bigfloat/float128.hpp"

#ifdef TORSE_MISUSE
const torse::Float128 x(0.1);  // misuse
#else
const torse::Float128 x(1);
#endif
