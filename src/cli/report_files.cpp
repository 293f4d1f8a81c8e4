// The options --json, --junit and --sarif.
#include "torse/cli/report_files.hpp"

#include "torse/cli/version.hpp"
#include "torse/io/file.hpp"

namespace torse::cli {

void add_report_options(CLI::App& app, ReportFiles& files) {
  app.add_option("--json", files.json, "write the results as JSON; - is standard output")->type_name("FILE");
  app.add_option("--junit", files.junit, "write a JUnit XML report")->type_name("FILE");
  app.add_option("--sarif", files.sarif, "write a SARIF 2.1.0 report")->type_name("FILE");
}

void write_case_reports(const ReportFiles& files, const std::vector<ReportCase>& cases) {
  if (!files.junit.empty()) write_file(files.junit, junit_report(cases));
  if (!files.sarif.empty()) write_file(files.sarif, sarif_report(cases, version));
}

}  // namespace torse::cli
