// The sections of pages with surfaces, docs/report.md.
//   check_section      what torse check found of each face
//   fit_section        what torse fit made of a pair of rails
//   figures_section    figures of the papers with their surfaces
#pragma once

#include <nlohmann/json.hpp>

#include <vector>

#include "torse/cli/checked.hpp"
#include "torse/cli/fitting.hpp"
#include "torse/figures/figure.hpp"

namespace torse::cli {

/// {"kind": "surfaces", "data", "verdicts", "pictures"}: `data` is what --json writes; for each of its surfaces there
/// is a verdict in words and a picture or null.
nlohmann::ordered_json check_section(const std::vector<CheckedFace>& faces, const std::vector<ReportCase>& cases,
                                     nlohmann::ordered_json data);

/// {"kind": "fit", "data", "pictures"}: the picture has two states, T = t and the fitted mapping.
nlohmann::ordered_json fit_section(const RailsFile<Rational>& rails, const FittedStrip& strip,
                                   nlohmann::ordered_json data);

/// {"kind": "figures", "figures": [{"id", "title", "caption", "svg"}], "pictures"}: for each figure the list of its
/// surfaces. Without `drawings` every "svg" is null: they are 85 kilobytes each.
nlohmann::ordered_json figures_section(const std::vector<figures::PaperFigure>& chosen, bool drawings);

}  // namespace torse::cli
