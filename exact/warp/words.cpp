// Bounds that stay bounds in six digits.
#include "torse/exact/warp/words.hpp"

#include <algorithm>

#include "torse/exact/decide/words.hpp"

namespace torse {

std::string describe(const WarpEnclosure& warp) {
  const std::string bounds = "the largest warp angle is between " + decimal_below(warp.lower, 6) + " and " +
                             decimal_above(std::min(warp.upper, 90.0), 6) + " degrees";
  if (warp.piece == 0) return bounds;
  return bounds + ", at u = " + short_number(warp.parameter) + " in piece " + std::to_string(warp.piece);
}

}  // namespace torse
