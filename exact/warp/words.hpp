// A warp enclosure in words.
//   describe       bounds and place of the largest warp angle
#pragma once

#include <string>

#include "torse/exact/warp/max_warp.hpp"

namespace torse {

/// "the largest warp angle is between 8.13006 and 8.13014 degrees, at u = 1/2 in piece 1": six digits, rounded away
/// from the enclosure. For a surface that is not developable.
std::string describe(const WarpEnclosure& warp);

}  // namespace torse
