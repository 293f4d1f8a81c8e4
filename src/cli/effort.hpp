// Estimates of work, which the limits of docs/formats.md are about.
//   effort_of        of a ruled surface        require_effort   an error for surfaces beyond the limit of all commands
#pragma once

#include <string>

#include "torse/exact/rational/rational.hpp"
#include "torse/io/spline_file.hpp"

namespace torse::cli {

/// The sum over all pieces of degree^degree_power bits^bits_power, where a piece's bits are those of the numerators and
/// denominators of the coordinates and weights that act on it.
double effort_of(const RuledFile<Rational>& surface, double degree_power, double bits_power);

/// Throws FileError where effort_of(surface, 2, 1.5) exceeds 2^40: the exact decision may take some seconds below that.
void require_effort(const std::string& file, const RuledFile<Rational>& surface);

}  // namespace torse::cli
