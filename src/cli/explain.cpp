// torse explain: one claim in full: statement, hypotheses with what fails without them, wrong variants, commands.
#include <fmt/format.h>

#include <memory>
#include <string>
#include <string_view>

#include "torse/cli/claims.hpp"
#include "torse/cli/command.hpp"
#include "torse/cli/terminal.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/proofs/engines/judge.hpp"
#include "torse/proofs/table.hpp"

namespace torse::cli {
namespace {

/// The text in lines of at most 108 characters, the later ones indented by `indent` blanks.
std::string wrapped(std::string_view text, std::size_t indent) {
  std::string result;
  std::size_t column = indent;
  std::string word;
  const auto flush = [&] {
    if (word.empty()) return;
    if (column + word.size() > 108 && column > indent) {
      result += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (column > indent) {
      result += ' ';
      ++column;
    }
    result += word;
    column += word.size();
    word.clear();
  };
  for (const char letter : text) {
    if (letter == ' ' || letter == '\n') {
      flush();
    } else {
      word += letter;
    }
  }
  flush();
  return result;
}

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
    text += fmt::format("      without it: {}\n", wrapped(what, 18));
  }
  return text;
}

int run_explain(const std::string& id) {
  require_known("CLAIM", {id}, claim_ids());
  std::size_t index = 0;
  while (proofs::all_claims()[index]->id != id) ++index;
  const proofs::ClaimInfo& info = *proofs::all_claims()[index];
  const proofs::ClaimCase<Rational>& claim = proofs::claim_cases<Rational>()[index];
  std::string text =
      fmt::format("{}  {}\n  source      {}, {}\n  kind        {}\n  statement   {}\n", info.id, info.title,
                  info.paper(), info.source, kind_text(info.kind), wrapped(info.statement, 14));
  text += info.hypotheses.empty() ? "  hypotheses  none\n" : "  hypotheses\n";
  for (std::size_t h = 0; h < info.hypotheses.size(); ++h) {
    const std::string note = info.hypotheses[h].stated ? "" : " (not stated in the paper)";
    text += fmt::format("    {}\n", wrapped(std::string(info.hypotheses[h].words) + note, 4));
    text += failures_text(claim, h);
  }
  if (!info.remark.empty()) text += fmt::format("  remark      {}\n", wrapped(info.remark, 14));
  if (!info.mutants.empty()) text += "  wrong variants that must fail\n";
  for (const std::string_view mutant : info.mutants) text += fmt::format("    {}\n", wrapped(mutant, 4));
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
