// Numbers: integers, dyadic and other fractions, tiny and huge ones. 0 and small integers are the simplest.
//   draw_integer, draw_fraction, draw_dyadic, draw_number, draw_positive, draw_nonzero
#pragma once

#include "torse/exact/rational/rational.hpp"
#include "torse/fuzz/choices.hpp"
#include "torse/fuzz/scale.hpp"

namespace torse::fuzz {

/// An integer of at most `bits` bits, either sign: 0, 1, -1, 2, ... from the simplest on.
Rational draw_integer(Choices& choices, int bits);
/// A fraction whose numerator and denominator have at most `bits` bits.
Rational draw_fraction(Choices& choices, int bits);
/// k 2^e with |k| < 2^bits and |e| <= exponent.
Rational draw_dyadic(Choices& choices, int bits, int exponent);
/// Any of these: mostly small, sometimes of scale.bits bits.
Rational draw_number(Choices& choices, const Scale& scale);
Rational draw_positive(Choices& choices, const Scale& scale);
Rational draw_nonzero(Choices& choices, const Scale& scale);

/// 2^e for any sign of e.
Rational power_of_two(int e);

}  // namespace torse::fuzz
