// Angles and their sines, both ways with certified bounds.
//   Angle                     a rational number of degrees or of radians
//   sine_squared_at_most_90   sin^2 of an angle, enclosed
//   exact_sine_squared        where it is a rational number
//   degrees_of                the angles whose sin^2 lies between two numbers
#pragma once

#include <optional>

#include "torse/exact/rational/rational.hpp"
#include "torse/scalar/interval.hpp"

namespace torse {

/// An angle of at least 0.
struct Angle {
  Rational value;
  bool radians = false;
};

/// An enclosure of 4^scale sin^2 of the angle; for a right angle and more, of 4^scale. An upper end beyond the largest
/// double is infinite.
Interval sine_squared_at_most_90(const Angle& angle, long scale);

/// sin^2 of 0, 30, 45, 60, 90 and more degrees: by Niven's theorem, of no other rational number of degrees in between.
std::optional<Rational> exact_sine_squared(const Angle& angle);

/// The angles in [0, 90] degrees, rounded outwards, with lower <= 4^scale sin^2 <= upper.
Interval degrees_of(double lower, double upper, long scale);

}  // namespace torse
