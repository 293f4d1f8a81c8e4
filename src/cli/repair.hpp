// torse check --repair: the nearest exactly developable net, as a file.
//   RepairedSurface                what was found
//   repair_surface                 finds and writes it
//   repair_json, repair_text       for other programs, in words
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "torse/developable/classify.hpp"
#include "torse/exact/repair/nearest.hpp"
#include "torse/io/spline_file.hpp"

namespace torse::cli {

/// An exactly developable surface near a given one, and the name of its file.
struct RepairedSurface {
  std::string file;
  NearestNet net;
  Classification<Rational> classification;
};

/// Finds the nearest net (exact/repair/nearest.hpp) and writes it as a ruled file, "-" for standard output. Nothing,
/// and nothing written, where none was found. Throws FileError where it cannot be written.
std::optional<RepairedSurface> repair_surface(const RuledFile<Rational>& surface, const std::string& file);

/// The member "repair" of a surface in the report of check, docs/formats.md.
nlohmann::ordered_json repair_json(const RepairedSurface& repaired);

/// "tangent, Lambda -4/3, M -2; control points move by at most 1.5e-15 (4 ulps)".
std::string repair_text(const RepairedSurface& repaired);

}  // namespace torse::cli
