// torse campaign: properties over ranges of seeds, with a database that remembers every unit.
#include "torse/cli/campaign.hpp"

#include <array>
#include <string_view>

#include "torse/cli/command.hpp"

namespace torse::cli {
namespace {

constexpr std::array<Command, 5> words{{
    {"run", "run the units that are missing in a database", define_campaign_run},
    {"show", "what a database holds: cases, failures, distributions", define_campaign_show},
    {"merge", "put the units of several databases into one", define_campaign_merge},
    {"diff", "what the results of two databases differ in", define_campaign_diff},
    {"export", "write the failing cases of a database as files for torse replay", define_campaign_export},
}};

}  // namespace

std::function<int()> define_campaign(CLI::App& app) {
  app.require_subcommand(0, 1);
  std::vector<std::pair<CLI::App*, std::function<int()>>> actions;
  for (const Command& word : words) {
    CLI::App* sub = app.add_subcommand(std::string(word.name), std::string(word.summary));
    actions.emplace_back(sub, word.define(*sub));
  }
  return [actions] {
    for (const auto& [sub, action] : actions) {
      if (sub->parsed()) return action();
    }
    throw UsageError("torse campaign: expected run, show, merge, diff or export");
  };
}

}  // namespace torse::cli
