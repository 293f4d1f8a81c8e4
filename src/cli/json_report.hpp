// JSON reports.
//   json_text        a report as it is written        write_json       into the file of --json
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace torse::cli {

/// Indented by two blanks a level, with a line break at the end.
std::string json_text(const nlohmann::ordered_json& report);

/// Writes the report, to the standard output for "-", or nothing for a name that is empty. Throws FileError.
void write_json(const std::string& path, const nlohmann::ordered_json& report);

}  // namespace torse::cli
