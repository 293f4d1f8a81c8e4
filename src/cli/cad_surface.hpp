// Strips of CAD faces in exact arithmetic. Doubles are exact rational numbers; what is a plane, cylinder, cone or
// extrusion by its kind is one exactly, whatever was rounded.
//   surface_of              a strip at its place         curve_file      a curve at its place
//   speeds_are_proportional    whether equal parameters are equal relative arc lengths
#pragma once

#include "torse/exact/rational/rational.hpp"
#include "torse/io/cad.hpp"
#include "torse/io/spline_file.hpp"

namespace torse::cli {

/// The strip, cut as it says and mapped to its place. Throws InvalidInput for numbers that are not finite, lists that
/// do not fit together, and degrees and numbers of points beyond limits.hpp.
RuledFile<Rational> surface_of(const CadStrip& strip, const CadPlacement& placement);

/// The curve, cut as it says and mapped to its place. Throws like surface_of.
CurveFile<Rational> curve_file(const CadRail& rail, const CadPlacement& placement);

/// Whether |c'(t)| / |d'(t)| is constant on the whole surface (the rails are proportional to each other by arc length),
/// so that rulings at equal relative arc lengths are those at equal parameters. Decided exactly.
bool speeds_are_proportional(const RuledFile<Rational>& surface);

}  // namespace torse::cli
