// Bounds that stay bounds in six digits.
#include "torse/exact/warp/words.hpp"

#include <cstdio>

#include "torse/exact/decide/words.hpp"

namespace torse {
namespace {

/// Half a unit of the sixth digit is at most 5e-6 of the value.
std::string rounded_out(double bound, bool up) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", bound * (up ? 1 + 6e-6 : 1 - 6e-6));
  return buffer;
}

}  // namespace

std::string describe(const WarpEnclosure& warp) {
  return "the largest warp angle is between " + rounded_out(warp.lower, false) + " and " +
         rounded_out(warp.upper, true) + " degrees, at u = " + short_number(warp.parameter) + " in piece " +
         std::to_string(warp.piece);
}

}  // namespace torse
