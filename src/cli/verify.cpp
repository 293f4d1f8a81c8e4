// torse verify: the ledger, every claim in every engine.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "torse/cli/claims.hpp"
#include "torse/cli/command.hpp"
#include "torse/cli/examples.hpp"
#include "torse/cli/html_report.hpp"
#include "torse/cli/ledger_report.hpp"
#include "torse/cli/page_sections.hpp"
#include "torse/cli/report_files.hpp"
#include "torse/cli/terminal.hpp"
#include "torse/io/file.hpp"
#include "torse/io/text.hpp"
#include "torse/proofs/report.hpp"
#include "torse/proofs/runner.hpp"

namespace torse::cli {
namespace {

using proofs::Entry;
using proofs::Finding;

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

  proofs::Extent extent() const {
    if (selection.shards > 1) return proofs::Extent::shard;
    const bool all = selection.claims.empty() && selection.papers.empty() && selection.engines.empty();
    return all ? proofs::Extent::whole : proofs::Extent::selected;
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
    throw UsageError("--shard: expected i/k with 1 <= i <= k, found " + printable(text));
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
}

proofs::Progress progress_line(bool shown) {
  if (!shown) return {};
  return [](std::size_t done, std::size_t all, const Finding& latest) {
    std::fprintf(stderr, "\r\033[K[%zu/%zu] %s %s", done, all, latest.claim.c_str(), latest.engine.c_str());
    if (done == all) std::fputs("\r\033[K", stderr);
  };
}

/// `baseline`: what is in that file, which may be a pipe.
std::vector<std::string> compare(const VerifyOptions& options, const std::string& baseline,
                                 const std::vector<Entry>& entries) {
  if (options.baseline.empty()) return {};
  try {
    return proofs::regressions(baseline, entries, options.extent());
  } catch (const Error& error) {
    throw UsageError(printable(options.baseline) + ": " + error.what());
  }
}

/// The ledger and, unless the run is about some claims only, the worked examples and the surfaces of the
/// papers' figures.
nlohmann::ordered_json html_sections(const VerifyOptions& options, const std::string& json) {
  nlohmann::ordered_json sections{{{"kind", "ledger"}, {"data", nlohmann::ordered_json::parse(json)}}};
  if (options.extent() != proofs::Extent::whole) return sections;
  sections.push_back(examples_section());
  sections.push_back(figures_section(figures::all_figures(), false));
  return sections;
}

int run_verify(VerifyOptions& options) {
  check_options(options);
  require_viewer(options.html);
  const std::string baseline = options.baseline.empty() ? "" : read_file(options.baseline);
  const auto start = std::chrono::steady_clock::now();
  const std::vector<Entry> entries =
      proofs::run_all(options.selection, options.plan, options.threads, progress_line(isatty(STDERR_FILENO) != 0));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const std::vector<std::string> worse = compare(options, baseline, entries);

  const std::string json = proofs::json_report(entries, options.plan);
  if (!options.reports.json.empty()) write_file(options.reports.json, json);
  if (!options.ledger.empty()) write_file(options.ledger, proofs::ledger(entries, options.plan));
  std::vector<ReportCase> cases;
  for (const Entry& entry : entries) cases.push_back(ledger_case(entry, options.plan));
  write_case_reports(options.reports, cases);
  if (options.html.wanted()) write_html(options.html, "The papers' claims", html_sections(options, json));
  const int code = ledger_code(entries, !worse.empty(), options.extent() != proofs::Extent::shard);
  if (options.reports.use_stdout()) return code;

  const Terminal terminal(stdout);
  terminal.print(ledger_text(entries, options.plan, terminal));
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
