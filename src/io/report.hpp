// Reports for other tools, from one list of cases.
//   ReportCase       one thing that was checked and what came out
//   junit_report     JUnit XML          sarif_report     SARIF 2.1.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace torse {

/// What came out of a case: it holds, it does not, it is undecided, it does not apply, or it could not be read.
enum class Outcome { passed, failed, undecided, skipped, error };

/// One case of a report.
struct ReportCase {
  /// The suite, such as "check", and the name of the case in it.
  std::string suite;
  std::string name;
  Outcome outcome = Outcome::passed;
  /// What was found, in one line.
  std::string message;
  /// The command that shows it again.
  std::string replay;
  /// For SARIF: the rule that does not hold, its text, the file or nothing; line and character in it from 1, or 0.
  std::string rule;
  std::string rule_text;
  std::string file;
  std::size_t line = 0;
  std::size_t column = 0;
  double seconds = 0;
};

/// One test case for each case: <failure> for failed, <error> for undecided and error, <skipped> for skipped.
std::string junit_report(const std::vector<ReportCase>& cases);

/// A run with one result for each case that has not passed: level "error", or "warning" for undecided, or kind
/// "notApplicable" for skipped.
std::string sarif_report(const std::vector<ReportCase>& cases, const std::string& version);

}  // namespace torse
