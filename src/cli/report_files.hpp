// The options --json, --junit and --sarif, shared by the subcommands that report.
//   ReportFiles      where the reports go        add_report_options, write_case_reports
#pragma once

#include <CLI/App.hpp>

#include <string>
#include <vector>

#include "torse/io/report.hpp"

namespace torse::cli {

/// The names of the files, empty for none, "-" for standard output.
struct ReportFiles {
  std::string json;
  std::string junit;
  std::string sarif;

  /// Whether a report takes standard output, so that nothing else may.
  bool use_stdout() const { return json == "-" || junit == "-" || sarif == "-"; }
};

/// Adds the three options to a subcommand.
void add_report_options(CLI::App& app, ReportFiles& files);

/// Writes the JUnit and SARIF reports that were asked for. Throws FileError.
void write_case_reports(const ReportFiles& files, const std::vector<ReportCase>& cases);

}  // namespace torse::cli
