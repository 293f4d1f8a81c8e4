// torse list: the claims, the engines or the properties, with their titles.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "torse/cli/claims.hpp"
#include "torse/cli/command.hpp"
#include "torse/cli/json_report.hpp"
#include "torse/cli/terminal.hpp"
#include "torse/fuzz/properties.hpp"
#include "torse/proofs/engines/engine.hpp"
#include "torse/proofs/table.hpp"

namespace torse::cli {
namespace {

using Json = nlohmann::ordered_json;

struct ListOptions {
  bool engines = false;
  bool properties = false;
  std::vector<std::string> papers;
  std::string json;
};

bool chosen(const ListOptions& options, const proofs::ClaimInfo& info) {
  if (options.papers.empty()) return true;
  for (const std::string& paper : options.papers) {
    if (info.paper() == paper) return true;
  }
  return false;
}

int run_list(const ListOptions& options) {
  require_known("--paper", options.papers, paper_ids());
  Json claims = Json::array();
  Json engines = Json::array();
  Json properties = Json::array();
  std::string text;
  std::size_t id_width = 0;
  std::size_t source_width = 0;
  for (const proofs::ClaimInfo* info : proofs::all_claims()) {
    id_width = std::max(id_width, std::string_view(info->id).size());
    source_width = std::max(source_width, std::string_view(info->source).size());
  }
  for (const proofs::ClaimInfo* info : proofs::all_claims()) {
    if (!chosen(options, *info)) continue;
    claims.push_back({{"id", info->id}, {"paper", info->paper()}, {"source", info->source}, {"title", info->title}});
    if (!options.engines && !options.properties) {
      text += fmt::format("{:<{}}  {:<{}}  {}\n", info->id, id_width, info->source, source_width, info->title);
    }
  }
  for (const proofs::Engine& engine : proofs::engines()) {
    engines.push_back({{"name", engine.name}, {"scalar", engine.scalar}, {"may_say", engine.may_say}});
    if (options.engines) text += fmt::format("{:<9} {}: {}\n", engine.name, engine.scalar, engine.may_say);
  }
  for (const fuzz::Property* property : fuzz::properties()) {
    const fuzz::PropertyInfo& info = property->info();
    properties.push_back({{"name", info.name}, {"statement", info.statement}, {"cases_per_seed", info.batch}});
    if (options.properties) text += fmt::format("{:<24} {}\n", info.name, info.statement);
  }
  if (!options.json.empty()) {
    const Json report{{"torse", 1}, {"claims", claims}, {"engines", engines}, {"properties", properties}};
    write_json(options.json, report);
  }
  if (options.json != "-") Terminal(stdout).print(text);
  return exit_code::success;
}

}  // namespace

std::function<int()> define_list(CLI::App& app) {
  const auto options = std::make_shared<ListOptions>();
  app.add_flag("--engines", options->engines, "the engines instead of the claims");
  app.add_flag("--properties", options->properties, "the properties of torse campaign instead of the claims");
  app.add_option("--paper", options->papers, "only this paper's claims (repeatable)");
  app.add_option("--json", options->json, "write the list as JSON, - for standard output")->type_name("FILE");
  return [options] { return run_list(*options); };
}

}  // namespace torse::cli
