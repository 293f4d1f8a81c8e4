// What the subcommands about claims share.
//   require_known        every name is one of the known ones, or a UsageError with a suggestion
//   claim_ids, paper_ids, engine_names
#pragma once

#include <string>
#include <vector>

namespace torse::cli {

std::vector<std::string> claim_ids();
std::vector<std::string> paper_ids();
std::vector<std::string> engine_names();

/// Throws UsageError naming `option`, the first unknown name and the nearest known one.
void require_known(const char* option, const std::vector<std::string>& names, const std::vector<std::string>& known);

}  // namespace torse::cli
