// torse campaign run.
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <random>
#include <thread>

#include "torse/cli/build_id.hpp"
#include "torse/cli/campaign.hpp"
#include "torse/cli/campaign_ranks.hpp"
#include "torse/cli/claims.hpp"
#include "torse/cli/command.hpp"
#include "torse/cli/json_report.hpp"
#include "torse/cli/report_files.hpp"
#include "torse/cli/version.hpp"
#include "torse/fuzz/campaign/campaign.hpp"
#include "torse/fuzz/campaign/crash.hpp"
#include "torse/fuzz/properties.hpp"
#include "torse/io/text.hpp"
#include "torse/proofs/report.hpp"

namespace torse::cli {
namespace {

using Json = nlohmann::ordered_json;

/// The files of failing cases that a run writes; torse campaign export writes them all.
constexpr std::size_t files_of_a_run = 100;

struct RunOptions {
  std::string database;
  std::string seeds;
  std::string effort = "standard";
  std::vector<std::string> properties;
  std::optional<unsigned> jobs;
  std::optional<double> minutes;
  ReportFiles reports;
};

/// What came of a run, for its reports.
struct Results {
  fuzz::Ran ran;
  std::uint64_t stored = 0;  ///< units of the plan in the database
  std::vector<SeriesReport> reports;

  bool failed() const { return std::ranges::any_of(reports, &SeriesReport::failed); }
};

std::vector<std::string> property_names() {
  std::vector<std::string> names;
  for (const fuzz::Property* property : fuzz::properties()) names.emplace_back(property->info().name);
  return names;
}

fuzz::Seeds seeds_of(const RunOptions& options) {
  if (options.seeds.empty()) return options.minutes ? fuzz::Seeds{} : fuzz::Seeds{1, 100};
  fuzz::Seeds seeds;
  try {
    seeds = fuzz::Seeds::from_text(options.seeds);
  } catch (const Error& error) {
    throw UsageError(std::string("--seeds: ") + error.what());
  }
  if (seeds.endless() && !options.minutes) throw UsageError("--seeds: a range without an end needs --minutes");
  return seeds;
}

fuzz::Plan plan_of(const RunOptions& options) {
  require_known("--property", options.properties, property_names());
  require_known("--effort", {options.effort}, {"quick", "standard", "deep"});
  fuzz::Plan plan;
  for (const fuzz::Property* property : fuzz::properties()) {
    const bool wanted = options.properties.empty() ||
                        std::ranges::find(options.properties, property->info().name) != options.properties.end();
    if (wanted) plan.properties.push_back(property);
  }
  plan.effort = options.effort == "quick"      ? proofs::Effort::quick
                : options.effort == "standard" ? proofs::Effort::standard
                                               : proofs::Effort::deep;
  plan.seeds = seeds_of(options);
  plan.shard = fuzz::shard_of_environment();
  return plan;
}

/// One thread for every processor, but one for each process of several.
unsigned jobs_of(const RunOptions& options, const fuzz::Ranks* ranks) {
  if (options.jobs) return *options.jobs;
  return ranks != nullptr && ranks->size() > 1 ? 1 : std::max(1U, std::thread::hardware_concurrency());
}

fuzz::RunInfo run_info(const RunOptions& options, const fuzz::Plan& plan, const fuzz::Ranks* ranks) {
  fuzz::RunInfo run;
  std::random_device random;
  run.token = fmt::format("{:08x}{:08x}", random(), random());
  run.started = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}",
                            fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
  run.version = version;
  run.build = build_id();
  run.options =
      fmt::format("{} effort, seeds {}, {} properties", options.effort, plan.seeds.text(), plan.properties.size());
  if (plan.shard.total > 1) run.options += fmt::format(", shard {} of {}", plan.shard.index, plan.shard.total);
  if (ranks != nullptr) run.options += fmt::format(", {} processes", ranks->size());
  return run;
}

std::function<void(const fuzz::Advance&)> progress_line(bool shown) {
  if (!shown) return {};
  return [](const fuzz::Advance& advance) {
    const bool countable = advance.left < fuzz::Seeds::most / 2;
    std::fprintf(stderr, "\r\033[K[%s%s] %s cases, %s failed", fmt::format("{}", advance.units).c_str(),
                 countable ? fmt::format("/{}", advance.left).c_str() : "", fmt::format("{}", advance.cases).c_str(),
                 fmt::format("{}", advance.failed).c_str());
  };
}

/// Stopped before anything was stored.
bool nothing_judged(const Results& results) { return !results.ran.complete && results.stored == 0; }

int exit_code_of(const Results& results) {
  if (results.failed()) return exit_code::refuted;
  return nothing_judged(results) ? exit_code::undecided : exit_code::success;
}

std::string closing_line(const Results& results, const RunOptions& options, const fuzz::Plan& plan) {
  std::uint64_t cases = 0;
  std::uint64_t failed = 0;
  for (const SeriesReport& report : results.reports) {
    cases += report.tally.cases;
    failed += report.tally.failed;
  }
  const auto vacuous =
      std::ranges::count_if(results.reports, [](const auto& report) { return !report.vacuous.empty(); });
  std::string line = fmt::format("{} properties, {} units, {} cases: {} failed", results.reports.size(), results.stored,
                                 cases, failed);
  if (vacuous > 0) line += fmt::format(", {} properties vacuous", vacuous);
  line += fmt::format(" ({} effort, seeds {}; {} cases in this run, {:.1f} s)\n", options.effort, plan.seeds.text(),
                      results.ran.advance.cases, results.ran.seconds);
  if (!results.ran.complete) line += "stopped by --minutes: the same command goes on from here\n";
  if (nothing_judged(results)) line += "nothing was judged: no unit began in this time\n";
  return line;
}

Json json_of(const Results& results, const RunOptions& options, const fuzz::Plan& plan, const CaseFiles& files) {
  Json json{{"torse", 1},
            {"campaign", printable(options.database)},
            {"effort", options.effort},
            {"seeds", plan.seeds.text()},
            {"complete", results.ran.complete},
            {"units", {{"stored", results.stored}, {"run", results.ran.advance.units}}},
            {"seconds", results.ran.seconds}};
  add_reports(json, results.reports, files);
  return json;
}

int report(const Results& results, const RunOptions& options, const fuzz::Plan& plan) {
  CaseFiles files{options.database, options.database + ".cases"};
  write_cases(results.reports, files, files_of_a_run);
  const int code = exit_code_of(results);
  write_json(options.reports.json, json_of(results, options, plan, files));
  write_case_reports(options.reports, cases_of(results.reports, files));
  if (options.reports.use_stdout()) return code;
  const Terminal terminal(stdout);
  print_reports(terminal, results.reports);
  print_failures(terminal, results.reports, files);
  terminal.print(closing_line(results, options, plan));
  return code;
}

/// Ends the program, whose threads cannot be ended: all that was finished is stored.
[[noreturn]] void end_overdue(const std::string& names) {
  print_error("does not end, a minute after the time of --minutes: " + names);
  std::_Exit(exit_code::refuted);
}

int run_campaign(const RunOptions& options) {
  const fuzz::Plan plan = plan_of(options);
  fuzz::Ranks* const ranks = ranks_of_environment();
  fuzz::Work work;
  work.jobs = jobs_of(options, ranks);
  if (options.minutes) work.time = std::chrono::duration<double>(*options.minutes * 60);
  work.overdue = end_overdue;
  fuzz::report_crashes();
  if (ranks != nullptr && ranks->rank() > 0) {
    fuzz::follow(*ranks, plan, build_id(), work.jobs);
    return exit_code::success;
  }
  fuzz::Store store(options.database, fuzz::Database::Open::create);
  const bool shows = isatty(STDERR_FILENO) != 0;
  Results results;
  results.ran = fuzz::run_campaign(store, plan, run_info(options, plan, ranks), work, progress_line(shows), ranks);
  if (shows) std::fputs("\r\033[K", stderr);
  for (std::size_t i = 0; i < plan.properties.size(); ++i) {
    results.reports.push_back(series_report(store, plan.series(i), plan.seeds));
    results.stored += results.reports.back().units;
  }
  return report(results, options, plan);
}

}  // namespace

std::function<int()> define_campaign_run(CLI::App& app) {
  const auto options = std::make_shared<RunOptions>();
  app.add_option("--db", options->database, "the database: made where there is none, continued otherwise")
      ->required()
      ->type_name("FILE");
  app.add_option("--seeds", options->seeds, "A..B, or A.. without an end [1..100, with --minutes 1..]");
  app.add_option("--effort", options->effort, "quick, standard or deep: how large the cases are")
      ->capture_default_str();
  app.add_option("--property", options->properties, "only this property (repeatable)");
  app.add_option("--jobs", options->jobs, "how many threads; the results do not depend on it")
      ->check(CLI::Range(1U, 1024U));
  app.add_option("--minutes", options->minutes, "begin no more units after this time")->check(CLI::Range(0.0, 1e6));
  add_report_options(app, options->reports);
  return [options] { return run_campaign(*options); };
}

}  // namespace torse::cli
