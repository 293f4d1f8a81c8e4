// torse study: what its results are written as.
//   study_lines, study_csv       the results for programs
//   Spread, StudySummary         medians and maxima by route, scalar and level
//   summary_of, print_study, study_svg, study_section
//   print_autopsy                torse study autopsy FILE
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>
#include <vector>

#include "torse/cli/terminal.hpp"
#include "torse/studies/routes.hpp"
#include "torse/studies/run.hpp"
#include "torse/studies/verdicts.hpp"

namespace torse::cli {

/// A line for each case.
std::string study_lines(const std::vector<std::string>& records);

/// A row for each result; the header is in the first shard only, so that shards can be joined.
std::string study_csv(const studies::Task& task, const std::vector<std::string>& records);

/// Some numbers of like kind.
struct Spread {
  std::vector<double> values;

  double median() const;
  double most() const;
};

/// The results of a route in an arithmetic.
struct RouteSummary {
  Spread ulps;
  Spread units;
  Spread conditioned;
  Spread backward;
  Spread warp;
  Spread bound;
  std::size_t failed = 0;  ///< cases with something not finite
};

/// Naive verdicts.
struct TestSummary {
  std::size_t cases = 0;
  std::size_t false_yes = 0;  ///< "developable" of a net that is not
  std::size_t false_no = 0;
};

struct StudySummary {
  std::vector<std::pair<std::string, std::string>> order;  ///< route, scalar
  std::map<std::pair<std::string, std::string>, RouteSummary> routes;
  /// By route, scalar and level of the factor: the `units` of the cases.
  std::map<std::tuple<std::string, std::string, studies::Factor, double>, Spread> levels;
  std::map<std::string, TestSummary> tests;
  /// By test, factor and level: cases, wrong ones.
  std::map<std::tuple<std::string, studies::Factor, double>, TestSummary> test_levels;
  std::size_t above_bound = 0;  ///< results whose error exceeds the proved bound
};

StudySummary summary_of(const studies::Task& task, const std::vector<std::string>& records);
void print_study(const Terminal& terminal, const studies::Task& task, const StudySummary& summary);

/// Medians of `units` in double, or in the first arithmetic, over each factor that varies, a line for each route.
std::string study_svg(const studies::Task& task, const StudySummary& summary);

/// The section of a page, docs/report.md: a plot for each factor that varies, and a table.
nlohmann::ordered_json study_section(const studies::Task& task, const StudySummary& summary);

/// Prints where the digits of a construction, or of a surface's determinant, are lost; `json` may name a file. Returns
/// the exit code. Throws FileError.
int print_autopsy(const std::string& file, const std::string& route, const std::string& json);

}  // namespace torse::cli
