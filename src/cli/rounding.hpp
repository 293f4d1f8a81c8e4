// A surface in the doubles of a CAD file, and what rounding has done to it.
//   RoundedSurface, round_surface
#pragma once

#include <cstddef>

#include "torse/exact/rational/rational.hpp"
#include "torse/io/cad.hpp"
#include "torse/io/spline_file.hpp"

namespace torse::cli {

/// A surface as a CAD file holds it.
struct RoundedSurface {
  /// Clamped, with positive weights, every number a double.
  RuledFile<Rational> surface;
  /// How many numbers it has, and how many of them rounding has changed.
  std::size_t numbers = 0;
  std::size_t changed = 0;
  /// The largest change of a coordinate, rounded up.
  double shift = 0;
};

/// Clamps the knot list by exact insertion, makes all weights of a rail positive (all 1 where those of both rails are
/// equal) and rounds every number once to the nearest double. Throws InvalidInput naming "weights" for a rail with
/// weights of both signs, "points" for numbers beyond the range of double, "knots" where rounding makes one knot of
/// more than the degree allows.
RoundedSurface round_surface(const RuledFile<Rational>& surface);

/// The surface with the name, for the plugin.
CadSheet sheet_of(const RoundedSurface& rounded, const std::string& name);

}  // namespace torse::cli
