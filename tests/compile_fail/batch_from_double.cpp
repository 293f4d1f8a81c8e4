// error: (no matching (function|constructor)|call to deleted constructor|conversion from)
// A double literal is not an exact number.
#include "torse/exact/modular/batch.hpp"

#ifdef TORSE_MISUSE
const torse::Batch x(0.1);  // misuse
#else
const torse::Batch x(1);
#endif
