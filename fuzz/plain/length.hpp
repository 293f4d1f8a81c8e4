// Lengths with bounds.
//   root_below, root_above         of a square root
//   squared_distance               of two points
//   point_of                       of a homogeneous row
#pragma once

#include "torse/fuzz/plain/ruling.hpp"

namespace torse::fuzz::plain {

using Point = Vec<Rational, 3>;

/// Bounds of the square root of x >= 0, a relative 2^-150 apart.
Rational root_below(const Rational& x);
Rational root_above(const Rational& x);

Rational squared_distance(const Point& x, const Point& y);

/// The point of a row whose weight is not 0.
Point point_of(const Row& x);

}  // namespace torse::fuzz::plain
