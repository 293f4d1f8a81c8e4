#include "torse/cli/claims.hpp"

#include <algorithm>

#include "torse/cli/command.hpp"
#include "torse/cli/suggest.hpp"
#include "torse/io/text.hpp"
#include "torse/proofs/engines/engine.hpp"
#include "torse/proofs/table.hpp"

namespace torse::cli {

std::vector<std::string> claim_ids() {
  std::vector<std::string> ids;
  for (const proofs::ClaimInfo* info : proofs::all_claims()) ids.emplace_back(info->id);
  return ids;
}

std::vector<std::string> paper_ids() {
  std::vector<std::string> ids;
  for (const proofs::ClaimInfo* info : proofs::all_claims()) {
    if (std::ranges::find(ids, info->paper()) == ids.end()) ids.emplace_back(info->paper());
  }
  return ids;
}

std::vector<std::string> engine_names() {
  std::vector<std::string> names;
  for (const proofs::Engine& engine : proofs::engines()) names.emplace_back(engine.name);
  return names;
}

void require_known(const char* option, const std::vector<std::string>& names, const std::vector<std::string>& known) {
  for (const std::string& name : names) {
    if (std::ranges::find(known, name) == known.end()) {
      throw UsageError(std::string(option) + ": unknown name " + printable(name) + suggestion(name, known));
    }
  }
}

}  // namespace torse::cli
