// error: (no matching (function|constructor)|call to deleted constructor|conversion from)
// A double literal is not an exact number.
#include "torse/exact/rational/cpp_rational.hpp"

#ifdef TORSE_MISUSE
const torse::CppRational x(0.1);  // misuse
#else
const torse::CppRational x(1);
#endif
