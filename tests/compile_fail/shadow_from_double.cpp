// error: (no matching (function|constructor)|call to deleted constructor|conversion from)
// An input has a name.
#include "torse/exact/instrumented/shadow.hpp"

#ifdef TORSE_MISUSE
const torse::Shadow x(0.1);  // misuse
#else
const torse::Shadow x(1);
#endif
