// error: (no match for .operator|value of type .* is not contextually convertible to|invalid operands)
// `&&` would turn an uncertain answer into a bool; `&` is Kleene's and.
#include "torse/exact/rational/rational.hpp"

torse::Truth f(const torse::Rational& x, const torse::Rational& y) {
#ifdef TORSE_MISUSE
  return torse::truth(torse::is_zero(x) && torse::is_zero(y));  // misuse
#else
  return torse::is_zero(x) & torse::is_zero(y);
#endif
}
