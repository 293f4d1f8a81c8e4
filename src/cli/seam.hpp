// Where the second of two closed rails is to begin.
//   closed_rails      whether both are closed
//   Seam, best_seam   the parameter from which a strip between fixed ends warps least
#pragma once

#include <optional>

#include "torse/exact/rational/rational.hpp"
#include "torse/io/spline_file.hpp"
#include "torse/quasi/fit.hpp"

namespace torse::cli {

/// Whether both rails end exactly where they begin.
bool closed_rails(const RailsFile<Rational>& rails);

/// The rails with d from another point on.
struct Seam {
  Rational parameter;  ///< of d, where the ruling from the ends of c goes
  RailsFile<Rational> rails;
};

/// The best of 32 even parameters of d, and of those between by halving five times, by a fit with fixed ends, even
/// knots and at most 20 coefficients; one from which on a control point would lie at infinity is left out. None where d
/// does best from its own begin on, or another gains less than 1 %.
std::optional<Seam> best_seam(const RailsFile<Rational>& rails, quasi::FitOptions options);

}  // namespace torse::cli
