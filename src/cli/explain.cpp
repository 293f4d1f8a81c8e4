// torse explain: one claim in full: statement, hypotheses with what fails without them, wrong variants, commands.
#include <fmt/format.h>

#include <memory>
#include <string>

#include "torse/cli/claims.hpp"
#include "torse/cli/command.hpp"
#include "torse/cli/terminal.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/proofs/engines/judge.hpp"
#include "torse/proofs/table.hpp"

namespace torse::cli {
namespace {

std::string kind_text(proofs::Kind kind) {
  switch (kind) {
    case proofs::Kind::identity:
      return "identity";
    case proofs::Kind::equivalence:
      return "equivalence";
    case proofs::Kind::inequality:
      return "inequality";
    case proofs::Kind::example:
      return "worked example";
  }
  return "";
}

/// What happens at the stored inputs that violate hypothesis h alone.
std::string failures_text(const proofs::ClaimCase<Rational>& claim, std::size_t h) {
  std::string text;
  for (const auto& failure : claim.failures()) {
    if (failure.hypothesis != h) continue;
    const std::string what = failure.error.empty() ? proofs::judge(failure.sample.equations).reason : failure.error;
    text += fmt::format("      without it: {}\n", what);
  }
  return text;
}

int run_explain(const std::string& id) {
  require_known("CLAIM", {id}, claim_ids());
  std::size_t index = 0;
  while (proofs::all_claims()[index]->id != id) ++index;
  const proofs::ClaimInfo& info = *proofs::all_claims()[index];
  const proofs::ClaimCase<Rational>& claim = proofs::claim_cases<Rational>()[index];
  std::string text = fmt::format("{}  {}\n  source      {}, {}\n  kind        {}\n  statement   {}\n", info.id,
                                 info.title, info.paper(), info.source, kind_text(info.kind), info.statement);
  text += info.hypotheses.empty() ? "  hypotheses  none\n" : "  hypotheses\n";
  for (std::size_t h = 0; h < info.hypotheses.size(); ++h) {
    text += fmt::format("    {}{}\n", info.hypotheses[h].words,
                        info.hypotheses[h].stated ? "" : " (not stated in the paper)");
    text += failures_text(claim, h);
  }
  if (!info.remark.empty()) text += fmt::format("  remark      {}\n", info.remark);
  if (!info.mutants.empty()) text += "  wrong variants that must fail\n";
  for (const std::string_view mutant : info.mutants) text += fmt::format("    {}\n", mutant);
  text += fmt::format("  run it      torse verify --claim {}\n", info.id);
  Terminal(stdout).print(text);
  return exit_code::success;
}

}  // namespace

std::function<int()> define_explain(CLI::App& app) {
  const auto id = std::make_shared<std::string>();
  app.add_option("CLAIM", *id, "a claim's id, as FJ07.16")->required();
  return [id] { return run_explain(*id); };
}

}  // namespace torse::cli
