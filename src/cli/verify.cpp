// torse verify: the ledger, every claim in every engine.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "torse/cli/claims.hpp"
#include "torse/cli/command.hpp"
#include "torse/cli/examples.hpp"
#include "torse/cli/html_report.hpp"
#include "torse/cli/page_sections.hpp"
#include "torse/cli/report_files.hpp"
#include "torse/cli/terminal.hpp"
#include "torse/io/file.hpp"
#include "torse/proofs/report.hpp"
#include "torse/proofs/runner.hpp"
#include "torse/proofs/table.hpp"

namespace torse::cli {
namespace {

using proofs::Entry;
using proofs::Finding;
using proofs::Status;

struct VerifyOptions {
  proofs::Selection selection;
  proofs::Plan plan;
  std::string effort = "standard";
  std::string shard;
  std::string baseline;
  std::string ledger;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  ReportFiles reports;
  HtmlOption html;

  bool whole() const {
    return selection.claims.empty() && selection.papers.empty() && selection.engines.empty() && selection.shards == 1;
  }
};

/// "i/k" with 1 <= i <= k.
void read_shard(const std::string& text, proofs::Selection& selection) {
  if (text.empty()) return;
  int i = 0;
  int k = 0;
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, i);
  const bool slash = first.ec == std::errc() && first.ptr != end && *first.ptr == '/';
  const auto second = slash ? std::from_chars(first.ptr + 1, end, k) : first;
  if (!slash || second.ec != std::errc() || second.ptr != end || i < 1 || k < i) {
    throw UsageError("--shard: expected i/k with 1 <= i <= k, found " + text);
  }
  selection.shard = i - 1;
  selection.shards = k;
}

void check_options(VerifyOptions& options) {
  require_known("--claim", options.selection.claims, claim_ids());
  require_known("--paper", options.selection.papers, paper_ids());
  require_known("--engine", options.selection.engines, engine_names());
  require_known("--effort", {options.effort}, {"quick", "standard", "deep"});
  options.plan.effort = options.effort == "quick"      ? proofs::Effort::quick
                        : options.effort == "standard" ? proofs::Effort::standard
                                                       : proofs::Effort::deep;
  read_shard(options.shard, options.selection);
  require_one_output(options.reports);
}

/// What the ledger says of an entry, in the words of the exit codes.
Outcome outcome_of(const Entry& entry) {
  const Status status = entry.status();
  if (status == Status::refuted || entry.mutants().survived + entry.faults().survived > 0) return Outcome::failed;
  return status == Status::gave_up || status == Status::undecided ? Outcome::undecided : Outcome::passed;
}

Paint paint_of(const Entry& entry) {
  switch (outcome_of(entry)) {
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

/// The finding that a failing entry should be replayed with.
const Finding& culprit(const Entry& entry) {
  for (const Finding& finding : entry.findings) {
    if (finding.status == Status::refuted || !finding.survivors.empty()) return finding;
  }
  for (const Finding& finding : entry.findings) {
    if (finding.status == Status::gave_up || finding.status == Status::undecided) return finding;
  }
  return entry.findings.front();
}

std::string message_of(const Entry& entry) {
  const Finding& finding = outcome_of(entry) == Outcome::passed ? *entry.decisive() : culprit(entry);
  return fmt::format("{} ({}): {}", proofs::status_name(finding.status), finding.engine, finding.detail);
}

ReportCase case_of(const Entry& entry, const proofs::Plan& plan) {
  ReportCase c;
  c.suite = "verify";
  c.name = entry.info->id;
  c.outcome = outcome_of(entry);
  c.message = message_of(entry);
  c.replay = proofs::replay_command(culprit(entry), plan);
  c.rule = std::string(entry.info->id);
  c.rule_text = std::string(entry.info->title);
  for (const Finding& finding : entry.findings) c.seconds += finding.seconds;
  return c;
}

std::string score_text(const proofs::Score& score) {
  const long all = score.killed + score.survived;
  return all == 0 ? "-" : fmt::format("{}/{}", score.killed, all);
}

void print_entry(const Terminal& terminal, const Entry& entry, const proofs::Plan& plan) {
  const Finding* modular = finding_of(entry, "modular");
  const std::string bound =
      modular != nullptr && modular->error_log2 ? fmt::format("2^{:.0f}", *modular->error_log2) : "-";
  const bool printed_is_wrong = std::ranges::any_of(entry.info->hypotheses, [](const auto& h) { return !h.stated; });
  const std::string status = fmt::format("{}{}", proofs::status_name(entry.status()), printed_is_wrong ? "*" : "");
  terminal.print(fmt::format("{:<11} {} {:<22} {:>7} {:>6} {:>11}  {}\n", entry.info->id,
                             terminal.painted(paint_of(entry), fmt::format("{:<10}", status)),
                             proofs::sizes_text(entry.decisive()->sizes), bound, score_text(entry.mutants()),
                             score_text(entry.faults()), entry.info->title));
  if (outcome_of(entry) == Outcome::passed) return;
  terminal.print(fmt::format("{:<11} {}\n", "", message_of(entry)));
  for (const std::string& survivor : culprit(entry).survivors) {
    terminal.print(fmt::format("{:<11} survived: {}\n", "", survivor));
  }
  terminal.print(fmt::format("{:<11} {}\n", "",
                             terminal.painted(Paint::dim, "replay: " + proofs::replay_command(culprit(entry), plan))));
}

void print_ledger(const std::vector<Entry>& entries, const VerifyOptions& options) {
  const Terminal terminal(stdout);
  terminal.print(
      terminal.painted(Paint::dim, fmt::format("{:<11} {:<10} {:<22} {:>7} {:>6} {:>11}  {}\n", "claim", "status",
                                               "sizes", "error", "mutant", "faults", "statement")));
  for (const Entry& entry : entries) print_entry(terminal, entry, options.plan);
}

/// "40 proved, 5 supported, ..." in the order of strength.
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

proofs::Progress progress_line(bool shown) {
  if (!shown) return {};
  return [](std::size_t done, std::size_t all, const Finding& latest) {
    std::fprintf(stderr, "\r\033[K[%zu/%zu] %s %s", done, all, latest.claim.c_str(), latest.engine.c_str());
    if (done == all) std::fputs("\r\033[K", stderr);
    std::fflush(stderr);
  };
}

int code_of(const std::vector<Entry>& entries, bool regressed) {
  const auto any = [&](Outcome outcome) {
    return std::ranges::any_of(entries, [&](const Entry& entry) { return outcome_of(entry) == outcome; });
  };
  if (regressed || any(Outcome::failed)) return exit_code::refuted;
  return any(Outcome::undecided) ? exit_code::undecided : exit_code::success;
}

std::vector<std::string> compare(const VerifyOptions& options, const std::vector<Entry>& entries) {
  if (options.baseline.empty()) return {};
  try {
    return proofs::regressions(read_file(options.baseline), entries, options.whole());
  } catch (const FileError&) {
    throw;
  } catch (const Error& error) {
    throw UsageError(options.baseline + ": " + error.what());
  }
}

/// The ledger and, unless the run is about some claims only, the worked examples and the surfaces of the
/// papers' figures.
nlohmann::ordered_json html_sections(const VerifyOptions& options, const std::string& json) {
  nlohmann::ordered_json sections{{{"kind", "ledger"}, {"data", nlohmann::ordered_json::parse(json)}}};
  if (!options.whole()) return sections;
  sections.push_back(examples_section());
  sections.push_back(figures_section(figures::all_figures(), false));
  return sections;
}

int run_verify(VerifyOptions& options) {
  check_options(options);
  require_viewer(options.html);
  if (!options.baseline.empty()) static_cast<void>(read_file(options.baseline));
  const auto start = std::chrono::steady_clock::now();
  const std::vector<Entry> entries =
      proofs::run_all(options.selection, options.plan, options.threads, progress_line(isatty(STDERR_FILENO) != 0));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const std::vector<std::string> worse = compare(options, entries);

  const std::string json = proofs::json_report(entries, options.plan);
  if (!options.reports.json.empty()) write_file(options.reports.json, json);
  if (!options.ledger.empty()) write_file(options.ledger, proofs::ledger(entries, options.plan));
  std::vector<ReportCase> cases;
  for (const Entry& entry : entries) cases.push_back(case_of(entry, options.plan));
  write_case_reports(options.reports, cases);
  if (options.html.wanted()) write_html(options.html, "The papers' claims", html_sections(options, json));
  const int code = code_of(entries, !worse.empty());
  if (options.reports.use_stdout()) return code;

  const Terminal terminal(stdout);
  print_ledger(entries, options);
  for (const std::string& line : worse) terminal.print(terminal.painted(Paint::bad, "worse: ") + line + "\n");
  terminal.print(fmt::format("{} ({} effort, seed {}, {:.0f} s)\n", tally_of(entries), options.effort,
                             options.plan.seed, seconds));
  return code;
}

}  // namespace

std::function<int()> define_verify(CLI::App& app) {
  const auto options = std::make_shared<VerifyOptions>();
  app.add_option("--paper", options->selection.papers, "only this paper's claims (repeatable)");
  app.add_option("--claim", options->selection.claims, "only this claim (repeatable)");
  app.add_option("--engine", options->selection.engines, "only this engine (repeatable)");
  app.add_option("--effort", options->effort, "quick, standard or deep")->capture_default_str();
  app.add_option("--seed", options->plan.seed, "the seed of all random choices")->capture_default_str();
  app.add_option("--shard", options->shard, "i/k: the i-th of k parts of the run");
  app.add_option("--baseline", options->baseline, "an earlier --json report: exit 1 if a claim lost its status");
  app.add_option("--ledger", options->ledger, "write what does not change from run to run, as proofs/ledger.json")
      ->type_name("FILE");
  app.add_option("--threads", options->threads, "how many threads; the findings do not depend on it")
      ->check(CLI::Range(1U, 256U))
      ->capture_default_str();
  add_report_options(app, options->reports);
  add_html_option(app, options->html);
  return [options] { return run_verify(*options); };
}

}  // namespace torse::cli
