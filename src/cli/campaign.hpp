// torse campaign: its words, and what they share.
//   define_campaign_run, ...  the words, a file each
//   CaseFiles                 where failing cases are, and the words that run them again
//   SeriesReport              what a database holds of a property at an effort
//   series_report, print_reports, print_failures, reports_json, cases_of, write_cases
#pragma once

#include <CLI/App.hpp>

#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "torse/cli/terminal.hpp"
#include "torse/fuzz/campaign/store.hpp"
#include "torse/io/report.hpp"

namespace torse::cli {

std::function<int()> define_campaign_run(CLI::App& app);
std::function<int()> define_campaign_show(CLI::App& app);
std::function<int()> define_campaign_merge(CLI::App& app);
std::function<int()> define_campaign_diff(CLI::App& app);
std::function<int()> define_campaign_export(CLI::App& app);

/// Where the failing cases of a database are.
struct CaseFiles {
  std::string database;
  std::string folder;               ///< empty: in the database only
  std::set<std::string> written{};  ///< the paths of the cases that have a file

  /// Where the file of a failure belongs, as "text.number-standard-7-0.json" in the folder. Throws FileError for a
  /// property whose name is none.
  std::string path(const fuzz::Failure& failure) const;
  /// The same where it has been written, else empty.
  std::string file(const fuzz::Failure& failure) const;
  /// The command that runs it again, printable.
  std::string replay(const fuzz::Failure& failure) const;
};

/// The units of a series with some seeds.
struct SeriesReport {
  fuzz::Series series;
  std::uint64_t units = 0;
  fuzz::Tally tally;
  double seconds = 0;   ///< of one processor
  std::string vacuous;  ///< why it proves nothing, or empty
  std::vector<fuzz::Failure> failures;

  bool failed() const { return tally.failed > 0 || !vacuous.empty(); }
  /// Cases per second of one processor.
  double speed() const { return seconds > 0 ? static_cast<double>(tally.cases) / seconds : 0; }
};

SeriesReport series_report(fuzz::Store& store, const fuzz::Series& series, const fuzz::Seeds& seeds);

/// A line for each series with the distribution of its labels and reasons below.
void print_reports(const Terminal& terminal, const std::vector<SeriesReport>& reports);

/// Vacuous series, and failing cases with their commands.
void print_failures(const Terminal& terminal, const std::vector<SeriesReport>& reports, const CaseFiles& files);

/// Adds "properties" and "failures" to a report.
void add_reports(nlohmann::ordered_json& json, const std::vector<SeriesReport>& reports, const CaseFiles& files);

/// A case for each series.
std::vector<ReportCase> cases_of(const std::vector<SeriesReport>& reports, const CaseFiles& files);

/// Writes failing cases, up to `most` of them. Throws FileError.
void write_cases(const std::vector<SeriesReport>& reports, CaseFiles& files, std::size_t most);

}  // namespace torse::cli
