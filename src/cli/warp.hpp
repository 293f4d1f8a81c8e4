// The warp angle in the program.
//   read_angle        "0.5", "0.5deg", "1/100rad"
//   WarpVerdict       the enclosure, and the answer to --max-warp
//   judge_warp        both, of a surface that is not developable
#pragma once

#include <optional>
#include <string>

#include "torse/exact/warp/max_warp.hpp"
#include "torse/io/spline_file.hpp"

namespace torse::cli {

/// An angle of at least 0: a number, then nothing or "deg" for degrees, "rad" for radians. Throws UsageError naming
/// --max-warp.
Angle read_angle(const std::string& text);

/// What is known of a surface's warp; without a limit `within_limit` is unknown.
struct WarpVerdict {
  WarpEnclosure enclosure;
  Truth within_limit = Truth::unknown;
};

/// Encloses the largest warp angle and compares it with the limit.
WarpVerdict judge_warp(const RuledFile<Rational>& surface, const std::optional<Angle>& limit);

}  // namespace torse::cli
