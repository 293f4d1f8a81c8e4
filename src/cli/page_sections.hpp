// The sections of pages with surfaces, docs/report.md.
//   check_section      what torse check found of each face
//   fit_section        what torse fit made of a pair of rails
#pragma once

#include <nlohmann/json.hpp>

#include <vector>

#include "torse/cli/checked.hpp"
#include "torse/cli/fitting.hpp"

namespace torse::cli {

/// {"kind": "surfaces", "data", "verdicts", "pictures"}: `data` is what --json writes; for each of its surfaces there
/// is a verdict in words and a picture or null.
nlohmann::ordered_json check_section(const std::vector<CheckedFace>& faces, const std::vector<ReportCase>& cases,
                                     nlohmann::ordered_json data);

/// {"kind": "fit", "data", "pictures"}: the picture has two states, T = t and the fitted mapping.
nlohmann::ordered_json fit_section(const RailsFile<Rational>& rails, const FittedStrip& strip,
                                   nlohmann::ordered_json data);

}  // namespace torse::cli
