#include "torse/cli/ledger_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "torse/cli/command.hpp"
#include "torse/proofs/report.hpp"
#include "torse/proofs/table.hpp"

namespace torse::cli {
namespace {

using proofs::Entry;
using proofs::Finding;
using proofs::Status;

Paint paint_of(const Entry& entry) {
  switch (ledger_outcome(entry)) {
    case Outcome::passed:
      return entry.status() == Status::proved ? Paint::good : Paint::dim;
    case Outcome::undecided:
      return Paint::doubtful;
    default:
      return Paint::bad;
  }
}

const Finding* finding_of(const Entry& entry, std::string_view engine) {
  const auto found = std::ranges::find(entry.findings, engine, &Finding::engine);
  return found == entry.findings.end() ? nullptr : &*found;
}

std::string message_of(const Entry& entry) {
  const Finding& finding = ledger_outcome(entry) == Outcome::passed ? *entry.decisive() : culprit(entry);
  return fmt::format("{} ({}): {}", proofs::status_name(finding.status), finding.engine, finding.detail);
}

std::string score_text(const proofs::Score& score) {
  const long all = score.killed + score.survived;
  return all == 0 ? "-" : fmt::format("{}/{}", score.killed, all);
}

std::string entry_text(const Entry& entry, const proofs::Plan& plan, const Terminal& terminal) {
  const Finding* modular = finding_of(entry, "modular");
  const std::string bound =
      modular != nullptr && modular->error_log2 ? fmt::format("2^{:.0f}", std::ceil(*modular->error_log2)) : "-";
  const bool printed_is_wrong = std::ranges::any_of(entry.info->hypotheses, [](const auto& h) { return !h.stated; });
  const std::string status = fmt::format("{}{}", proofs::status_name(entry.status()), printed_is_wrong ? "*" : "");
  std::string text = fmt::format("{:<11} {} {:<22} {:>7} {:>6} {:>11}  {}\n", entry.info->id,
                                 terminal.painted(paint_of(entry), fmt::format("{:<10}", status)),
                                 proofs::sizes_text(entry.decisive()->sizes), bound, score_text(entry.mutants()),
                                 score_text(entry.faults()), entry.info->title);
  if (ledger_outcome(entry) == Outcome::passed) return text;
  const Finding& found = culprit(entry);
  text += fmt::format("{:<11} {}\n", "", message_of(entry));
  for (const std::string& survivor : found.survivors) text += fmt::format("{:<11} survived: {}\n", "", survivor);
  const std::string replay = "replay: " + proofs::replay_command(found, plan);
  return text + fmt::format("{:<11} {}\n", "", terminal.painted(Paint::dim, replay));
}

}  // namespace

Outcome ledger_outcome(const Entry& entry) {
  const Status status = entry.status();
  if (status == Status::refuted || entry.mutants().survived + entry.faults().survived > 0) return Outcome::failed;
  return status == Status::gave_up || status == Status::undecided ? Outcome::undecided : Outcome::passed;
}

int ledger_code(const std::vector<Entry>& entries, bool regressed, bool whole) {
  const auto any = [&](Outcome outcome) {
    return std::ranges::any_of(entries, [&](const Entry& entry) { return ledger_outcome(entry) == outcome; });
  };
  if (regressed || any(Outcome::failed)) return exit_code::refuted;
  const bool judged = !whole || std::ranges::any_of(entries, [](const Entry& entry) {
    return entry.status() != Status::not_applicable;
  });
  return any(Outcome::undecided) || !judged ? exit_code::undecided : exit_code::success;
}

const Finding& culprit(const Entry& entry) {
  for (const Finding& finding : entry.findings) {
    if (finding.status == Status::refuted || !finding.survivors.empty()) return finding;
  }
  for (const Finding& finding : entry.findings) {
    if (finding.status == Status::gave_up || finding.status == Status::undecided) return finding;
  }
  return entry.findings.front();
}

std::string ledger_text(const std::vector<Entry>& entries, const proofs::Plan& plan, const Terminal& terminal) {
  std::string text =
      terminal.painted(Paint::dim, fmt::format("{:<11} {:<10} {:<22} {:>7} {:>6} {:>11}  {}\n", "claim", "status",
                                               "sizes", "error", "mutant", "faults", "statement"));
  for (const Entry& entry : entries) text += entry_text(entry, plan, terminal);
  return text;
}

std::string tally_of(const std::vector<Entry>& entries) {
  std::map<Status, int> counts;
  long survivors = 0;
  bool starred = false;
  for (const Entry& entry : entries) {
    ++counts[entry.status()];
    survivors += entry.mutants().survived + entry.faults().survived;
    starred = starred || std::ranges::any_of(entry.info->hypotheses, [](const auto& h) { return !h.stated; });
  }
  std::string text = fmt::format("{} claims:", entries.size());
  for (const auto& [status, count] : counts) text += fmt::format(" {} {},", count, proofs::status_name(status));
  text += fmt::format(" {} surviving mutants", survivors);
  if (starred) text += "\n* needs a hypothesis that the paper does not state: torse explain CLAIM";
  return text;
}

ReportCase ledger_case(const Entry& entry, const proofs::Plan& plan) {
  ReportCase c;
  c.suite = "verify";
  c.name = entry.info->id;
  c.outcome = ledger_outcome(entry);
  c.message = message_of(entry);
  c.replay = proofs::replay_command(culprit(entry), plan);
  c.rule = std::string(entry.info->id);
  c.rule_text = std::string(entry.info->title);
  for (const Finding& finding : entry.findings) c.seconds += finding.seconds;
  return c;
}

}  // namespace torse::cli
