#include "torse/cli/json_report.hpp"

#include "torse/io/file.hpp"

namespace torse::cli {

std::string json_text(const nlohmann::ordered_json& report) { return report.dump(2) + '\n'; }

void write_json(const std::string& path, const nlohmann::ordered_json& report) {
  if (!path.empty()) write_file(path, json_text(report));
}

}  // namespace torse::cli
