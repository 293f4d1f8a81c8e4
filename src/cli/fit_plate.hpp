// torse fit --unroll: the fitted surface as a flat plate.
//   require_plate_files    their names
//   fitted_plate           the plate, if it is wanted
//   fit_plate_text, fit_plate_json
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "torse/cli/unrolling.hpp"

namespace torse::cli {

/// Throws UsageError for a name that no plate is written to.
void require_plate_files(const std::vector<std::string>& files);

/// The plate of the surface, or why there is none; nothing where no file is wanted. What is warped by up to 45 degrees
/// is unrolled too, docs/decisions/0008-unroll.md. Throws FileError for numbers that would take too long.
std::optional<Unrolled> fitted_plate(const std::vector<std::string>& files, const Face& face, const LengthUnit& unit);

/// Writes all files, where there is a plate.
void write_plates(const std::vector<std::string>& files, const Unrolled& plate);

std::string fit_plate_text(const Unrolled& plate, const Terminal& terminal);

/// docs/formats.md.
nlohmann::ordered_json fit_plate_json(const std::vector<std::string>& files, const Unrolled& plate);

}  // namespace torse::cli
