// Bounds that stay bounds in six digits.
#include "torse/exact/warp/words.hpp"

#include <algorithm>
#include <cstdio>

#include "torse/exact/decide/words.hpp"

namespace torse {
namespace {

/// Half a unit of the sixth digit is at most 5e-6 of the value. No warp exceeds 90 degrees.
std::string rounded_out(double bound, bool up) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", up ? std::min(bound * (1 + 6e-6), 90.0) : bound * (1 - 6e-6));
  return buffer;
}

}  // namespace

std::string describe(const WarpEnclosure& warp) {
  const std::string bounds = "the largest warp angle is between " + rounded_out(warp.lower, false) + " and " +
                             rounded_out(warp.upper, true) + " degrees";
  if (warp.piece == 0) return bounds;
  return bounds + ", at u = " + short_number(warp.parameter) + " in piece " + std::to_string(warp.piece);
}

}  // namespace torse
