// Warp angles by definition, and bounds of angles by directed rounding.
//   sine_squared           sin^2 of the angle between the tangent planes at the two ends of a ruling
//   sine_squared_below, sine_squared_above      of an angle in degrees
#pragma once

#include <optional>

#include "torse/fuzz/plain/ruling.hpp"

namespace torse::fuzz::plain {

/// With a = c', b = d', w = d - c: |w|^2 [a, w, b]^2 / (|a x w|^2 |b x w|^2) (BZZ19). None where a weight is 0 or a
/// normal vanishes.
std::optional<Rational> sine_squared(const Ruling& at);

/// Lower and upper bounds of sin^2 of an angle of 0 to 90 degrees, some 200 digits apart; of more degrees that of 90.
Rational sine_squared_below(const Rational& degrees);
Rational sine_squared_above(const Rational& degrees);

}  // namespace torse::fuzz::plain
