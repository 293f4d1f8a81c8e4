// error: (no match for .operator|invalid operands to binary expression)
// Two arithmetics do not mix, even where both are Q.
#include "torse/exact/rational/cpp_rational.hpp"
#include "torse/exact/rational/rational.hpp"

auto f(const torse::Rational& x, const torse::CppRational& y) {
#ifdef TORSE_MISUSE
  return x + y;  // misuse
#else
  return x + torse::Rational::from_text(y.text());
#endif
}
