// JUnit and SARIF as text.
#include "torse/io/report.hpp"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "torse/io/text.hpp"

namespace torse {
namespace {

using Json = nlohmann::ordered_json;

std::string xml(const std::string& text) {
  std::string out;
  for (char c : printable(text)) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string seconds_text(double seconds) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.3f", seconds);
  return buffer;
}

std::string test_case(const ReportCase& c) {
  const std::string open = "  <testcase classname=\"" + xml(c.suite) + "\" name=\"" + xml(c.name) + "\" time=\"" +
                           seconds_text(c.seconds) + '"';
  if (c.outcome == Outcome::passed) return open + "/>\n";
  if (c.outcome == Outcome::skipped) {
    return open + ">\n    <skipped message=\"" + xml(c.message) + "\"/>\n  </testcase>\n";
  }
  const std::string tag = c.outcome == Outcome::failed ? "failure" : "error";
  const std::string type = c.outcome == Outcome::undecided ? "undecided" : c.rule;
  return open + ">\n    <" + tag + " type=\"" + xml(type) + "\" message=\"" + xml(c.message) + "\">" + xml(c.message) +
         "\nreplay: " + xml(c.replay) + "</" + tag + ">\n  </testcase>\n";
}

/// A path as a relative reference of RFC 3986, or a file URI for an absolute one.
std::string uri(const std::string& path) {
  constexpr std::string_view plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";
  constexpr char hex[] = "0123456789ABCDEF";
  std::string out = path.starts_with('/') ? "file://" : "";
  for (char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    if (plain.find(c) != std::string_view::npos) {
      out += c;
    } else {
      out += {'%', hex[byte / 16], hex[byte % 16]};
    }
  }
  return out;
}

/// Standard input has no URI; SARIF lets a location say in words where it is.
Json sarif_place(const ReportCase& c) {
  if (c.file == "-") return {{"message", {{"text", "standard input"}}}};
  Json place{{"artifactLocation", {{"uri", uri(c.file)}}}};
  if (c.line > 0) place["region"] = {{"startLine", c.line}, {"startColumn", c.column}};
  return {{"physicalLocation", place}};
}

Json sarif_result(const ReportCase& c) {
  const char* level = c.outcome == Outcome::skipped ? "none" : c.outcome == Outcome::undecided ? "warning" : "error";
  Json result{{"ruleId", printable(c.rule)},
              {"kind", c.outcome == Outcome::skipped ? "notApplicable" : "fail"},
              {"level", level},
              {"message", {{"text", printable(c.name + ": " + c.message + " (replay: " + c.replay + ")")}}}};
  if (!c.file.empty()) result["locations"] = Json::array({sarif_place(c)});
  return result;
}

}  // namespace

std::string junit_report(const std::vector<ReportCase>& cases) {
  const auto count = [&](Outcome outcome) { return std::ranges::count(cases, outcome, &ReportCase::outcome); };
  double seconds = 0;
  std::string body;
  for (const ReportCase& c : cases) {
    seconds += c.seconds;
    body += test_case(c);
  }
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n <testsuite name=\"torse\" tests=\"" +
         std::to_string(cases.size()) + "\" failures=\"" + std::to_string(count(Outcome::failed)) + "\" errors=\"" +
         std::to_string(count(Outcome::undecided) + count(Outcome::error)) + "\" skipped=\"" +
         std::to_string(count(Outcome::skipped)) + "\" time=\"" + seconds_text(seconds) + "\">\n" + body +
         " </testsuite>\n</testsuites>\n";
}

std::string sarif_report(const std::vector<ReportCase>& cases, const std::string& version) {
  Json rules = Json::array();
  Json results = Json::array();
  for (const ReportCase& c : cases) {
    if (c.outcome == Outcome::passed) continue;
    const std::string id = printable(c.rule);
    const bool known = std::ranges::any_of(rules, [&](const Json& rule) { return rule["id"] == id; });
    if (!known) rules.push_back({{"id", id}, {"shortDescription", {{"text", printable(c.rule_text)}}}});
    results.push_back(sarif_result(c));
  }
  const Json driver{{"name", "torse"}, {"version", version}, {"rules", rules}};
  const Json run{{"tool", {{"driver", driver}}}, {"columnKind", "unicodeCodePoints"}, {"results", results}};
  const Json report{
      {"version", "2.1.0"}, {"$schema", "https://json.schemastore.org/sarif-2.1.0.json"}, {"runs", Json::array({run})}};
  return report.dump(2) + '\n';
}

}  // namespace torse
