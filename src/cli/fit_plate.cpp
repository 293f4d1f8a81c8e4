#include "torse/cli/fit_plate.hpp"

#include <utility>

#include "torse/cli/command.hpp"
#include "torse/io/file.hpp"
#include "torse/io/text.hpp"

namespace torse::cli {
namespace {

using Json = nlohmann::ordered_json;

/// Fitted surfaces have long numbers in many pieces, but forms that are quickly seen to have no zeros.
constexpr double most_effort = 0x1p45;

Json bounds(const Interval& x) { return {{"lo", x.lower()}, {"hi", x.upper()}}; }

}  // namespace

void require_plate_files(const std::vector<std::string>& files) {
  for (const std::string& file : files) {
    if (file == "-") throw UsageError("--unroll: expected a file, found -");
    plate_writer(file, "--unroll");
  }
}

std::optional<Unrolled> fitted_plate(const std::vector<std::string>& files, const Face& face, const LengthUnit& unit) {
  if (files.empty()) return std::nullopt;
  return unrolled(face, {.max_warp = most_plate_warp, .limit_name = "", .unit = unit, .most_effort = most_effort});
}

void write_plates(const std::vector<std::string>& files, const Unrolled& plate) {
  if (!plate.sheet) return;
  for (const std::string& file : files) write_file(file, plate_writer(file, "--unroll")(*plate.sheet));
}

std::string fit_plate_text(const Unrolled& plate, const Terminal& terminal) {
  if (plate.sheet) return "plate: " + plate_text(*plate.sheet, terminal);
  return terminal.painted(Paint::bad, "no plate") + ": " + plate.refusal + '\n';
}

Json fit_plate_json(const std::vector<std::string>& files, const Unrolled& result) {
  if (!result.sheet) return {{"unrolled", false}, {"reason", result.refusal}};
  const Plate& plate = result.sheet->plate;
  const Truth overlap = plate.overlap.verdict;
  Json names = Json::array();
  for (const std::string& file : files) names.push_back(printable(file));
  return {{"unrolled", true},
          {"files", std::move(names)},
          {"unit", result.sheet->unit.name},
          {"width", plate.width},
          {"height", plate.height},
          {"length", {{"c", bounds(plate.c.before)}, {"d", bounds(plate.d.before)}}},
          {"error", {{"boundary", plate.deviation}, {"ruling", plate.ruling_error}, {"inside", plate.stretch}}},
          {"overlap", overlap == Truth::unknown ? Json() : Json(overlap == Truth::yes)}};
}

}  // namespace torse::cli
