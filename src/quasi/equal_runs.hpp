// Coefficients of a mapping that are equal.
//   RunLimits      how many in a row are too many
//   part_equal     moves them apart
#pragma once

#include <cstddef>
#include <vector>

namespace torse::quasi {

/// From so many equal coefficients in a row on they are moved apart: at an end of the list, and elsewhere. 2 or more.
struct RunLimits {
  std::size_t at_end;
  std::size_t inside;
};

/// Moves runs of equal coefficients apart, each in even steps upwards from its first coefficient, which stays, or, at
/// the end of the list, downwards from its last one. A run rises by less than 1e-6 and by less than half of the gap to
/// the coefficient beyond it, so that the order stays. `beta` does not decrease; a list of equal coefficients alone has
/// no such gap and stays as it is.
void part_equal(std::vector<double>& beta, const RunLimits& limits);

}  // namespace torse::quasi
