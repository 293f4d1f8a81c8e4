#include "torse/fuzz/draw/numbers.hpp"

namespace torse::fuzz {
namespace {

/// A natural number of at most `bits` bits, most often a short one.
Rational draw_natural(Choices& choices, int bits) {
  int left = choices.between(1, bits);
  Rational number;
  for (; left > 0; left -= 32) {
    const int step = left < 32 ? left : 32;
    number = number * power_of_two(step) + Rational(choices.below(std::uint64_t{1} << step));
  }
  return number;
}

}  // namespace

Rational power_of_two(int e) {
  Rational power(1);
  Rational base(2);
  for (int left = e < 0 ? -e : e; left > 0; left /= 2) {
    if (left % 2 == 1) power *= base;
    base *= Rational(base);
  }
  return e < 0 ? Rational(1) / power : power;
}

Rational draw_integer(Choices& choices, int bits) {
  const Rational number = draw_natural(choices, bits);
  return choices.once_in(2) ? -number : number;
}

Rational draw_fraction(Choices& choices, int bits) {
  const Rational numerator = draw_integer(choices, bits);
  return numerator / (draw_natural(choices, bits) + Rational(1));
}

Rational draw_dyadic(Choices& choices, int bits, int exponent) {
  const Rational mantissa = draw_integer(choices, bits);
  const int e = choices.between(0, exponent);
  return mantissa * power_of_two(choices.once_in(2) ? e : -e);
}

Rational draw_number(Choices& choices, const Scale& scale) {
  switch (choices.below(8)) {
    case 0:
    case 1:
    case 2:
      return draw_integer(choices, 3);
    case 3:
    case 4:
      return draw_fraction(choices, 4);
    case 5:
      return draw_dyadic(choices, 10, 10);
    case 6:
      return draw_fraction(choices, scale.bits);
    default:
      return draw_dyadic(choices, scale.bits, scale.bits);
  }
}

Rational draw_positive(Choices& choices, const Scale& scale) {
  const Rational number = draw_number(choices, scale);
  if (number.sign() == 0) return Rational(1);
  return number.sign() < 0 ? -number : number;
}

Rational draw_nonzero(Choices& choices, const Scale& scale) {
  const Rational number = draw_number(choices, scale);
  return number.sign() == 0 ? Rational(1) : number;
}

}  // namespace torse::fuzz
