// A plate of a surface: what torse unroll and torse fit have in common.
//   PlateWriter, plate_writer    of a file, by its name
//   UnrollWishes                 what a plate is to be like
//   Unrolled, unrolled           the plate, or why there is none
//   plate_text, plate_exit       what is said of it
#pragma once

#include <optional>
#include <string>

#include "torse/cli/plate_files.hpp"
#include "torse/cli/terminal.hpp"
#include "torse/cli/warp.hpp"

namespace torse::cli {

/// Makes the bytes of a file.
using PlateWriter = std::string (*)(const PlateSheet&);

/// SVG, DXF or JSON, which "-" is too. Throws UsageError naming `option` for other names.
PlateWriter plate_writer(const std::string& output, const char* option);

/// As many parts as a plate may be marked in, and as many pieces as it may consist of: each takes a ruling at least.
inline constexpr int most_plate_parts = 5'000;

/// The largest warp that is unrolled, unless another one is asked for, and the largest one that may be asked for.
inline constexpr const char* default_plate_warp = "1deg";
inline constexpr const char* most_plate_warp = "45deg";

/// Up to 45 degrees. Throws UsageError naming --max-warp.
Angle read_plate_warp(const std::string& text);

struct UnrollWishes {
  std::string tolerance{};  ///< a number; empty for a share of the size
  int rulings = 10;         ///< parts between marked rulings
  std::string max_warp = default_plate_warp;
  std::string limit_name = "--max-warp ";  ///< what stands before that angle in a refusal
  LengthUnit unit = millimetres();
  bool mirrored = false;
  double most_effort = 0x1p40;  ///< of the surface, effort_of by degree^3 bits^2
};

/// A plate, or the reason why the surface has none and the exit code that this means.
struct Unrolled {
  std::optional<PlateSheet> sheet{};
  std::string refusal{};
  int code;
};

/// Unrolls a face that is ruled. Throws FileError for one that would take too long or whose size doubles cannot carry,
/// UsageError for wishes that do not suit it.
Unrolled unrolled(const Face& face, const UnrollWishes& wishes);

/// Sizes, lengths, bounds and overlap, a line each.
std::string plate_text(const PlateSheet& sheet, const Terminal& terminal);

/// 0 without overlap, 1 with one, 3 where that is not known.
int plate_exit(const PlateSheet& sheet);

}  // namespace torse::cli
