// JUnit and SARIF reports: what their schemas demand of what we write.
#include "torse/io/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>
#include <string_view>

namespace torse {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

ReportCase case_of(Outcome outcome, const std::string& name) {
  ReportCase c;
  c.suite = "check";
  c.name = name;
  c.outcome = outcome;
  c.message = "the <finding> of " + name;
  c.replay = "torse check " + name;
  c.rule = outcome == Outcome::error ? "readable-input" : "developable";
  c.rule_text = "The rule \"" + c.rule + "\".";
  c.file = "a folder/" + name;
  if (outcome == Outcome::error) c.line = c.column = 3;
  return c;
}

std::vector<ReportCase> all_outcomes() {
  return {case_of(Outcome::passed, "fine"), case_of(Outcome::failed, "bent"), case_of(Outcome::undecided, "open"),
          case_of(Outcome::skipped, "sphere"), case_of(Outcome::error, "broken\x01\xff")};
}

/// An object of the SARIF 2.1.0 schema, which allows no other members than its own (OASIS, section 3).
void expect_object(const json& object, std::initializer_list<std::string_view> needed,
                   std::initializer_list<std::string_view> allowed) {
  for (const std::string_view key : needed) EXPECT_TRUE(object.contains(key)) << key << " in " << object;
  for (const auto& member : object.items()) {
    const bool known = std::ranges::find(needed, member.key()) != needed.end() ||
                       std::ranges::find(allowed, member.key()) != allowed.end();
    EXPECT_TRUE(known) << member.key() << " in " << object;
  }
}

void expect_result(const json& result, const json& rules) {
  expect_object(result, {"message", "ruleId"}, {"kind", "level", "locations"});
  expect_object(result["message"], {"text"}, {});
  EXPECT_EQ(std::ranges::count(rules, result["ruleId"], [](const json& rule) { return rule["id"]; }), 1);
  const std::string kind = result["kind"];
  const std::string level = result["level"];
  EXPECT_TRUE(kind == "fail" || kind == "notApplicable");
  EXPECT_TRUE(kind == "fail" ? level == "error" || level == "warning" : level == "none") << level;
  for (const json& location : result["locations"]) {
    expect_object(location, {"physicalLocation"}, {});
    expect_object(location["physicalLocation"], {"artifactLocation"}, {"region"});
    expect_object(location["physicalLocation"]["artifactLocation"], {"uri"}, {});
    const std::string uri = location["physicalLocation"]["artifactLocation"]["uri"];
    EXPECT_TRUE(std::regex_match(uri, std::regex("([A-Za-z0-9._~/:-]|%[0-9A-F]{2})*"))) << uri;
    if (location["physicalLocation"].contains("region")) {
      expect_object(location["physicalLocation"]["region"], {"startLine", "startColumn"}, {});
      EXPECT_GE(location["physicalLocation"]["region"]["startLine"], 1);
    }
  }
}

TEST(Report, SarifIsWhatItsSchemaAllows) {
  const json report = json::parse(sarif_report(all_outcomes(), "1.2.3"));
  expect_object(report, {"version", "runs"}, {"$schema"});
  EXPECT_EQ(report["version"], "2.1.0");
  ASSERT_EQ(report["runs"].size(), 1U);
  const json& run = report["runs"][0];
  expect_object(run, {"tool", "columnKind", "results"}, {});
  EXPECT_EQ(run["columnKind"], "unicodeCodePoints");
  expect_object(run["tool"], {"driver"}, {});
  expect_object(run["tool"]["driver"], {"name", "version", "rules"}, {});
  for (const json& rule : run["tool"]["driver"]["rules"]) {
    expect_object(rule, {"id"}, {"shortDescription"});
    expect_object(rule["shortDescription"], {"text"}, {});
  }
  ASSERT_EQ(run["results"].size(), 4U);  // all but the one that passed
  for (const json& result : run["results"]) expect_result(result, run["tool"]["driver"]["rules"]);
  EXPECT_EQ(run["results"][0]["message"]["text"], "bent: the <finding> of bent (replay: torse check bent)");
  EXPECT_EQ(run["results"][2]["kind"], "notApplicable");
  EXPECT_EQ(run["results"][3]["locations"][0]["physicalLocation"]["region"]["startLine"], 3);
}

TEST(Report, SarifNamesTheFileByAUri) {
  ReportCase odd = case_of(Outcome::failed, "odd");
  for (const auto& [file, uri] :
       {std::pair{"a%20b c.json", "a%2520b%20c.json"}, {"/a:b\xC3\xA9", "file:///a%3Ab%C3%A9"}}) {
    odd.file = file;
    const json run = json::parse(sarif_report({odd}, "1.2.3"))["runs"][0];
    EXPECT_EQ(run["results"][0]["locations"][0]["physicalLocation"]["artifactLocation"]["uri"], uri);
  }
}

/// "-" would be a file of that name.
TEST(Report, SarifSaysInWordsThatItWasStandardInput) {
  ReportCase piped = case_of(Outcome::error, "piped");
  piped.file = "-";
  piped.line = 3;
  piped.column = 7;
  const json run = json::parse(sarif_report({piped}, "1.2.3"))["runs"][0];
  EXPECT_EQ(run["results"][0]["locations"], json::parse(R"([{"message": {"text": "standard input"}}])"));
}

TEST(Report, SarifHasNoPlaceWhereThereIsNoFile) {
  ReportCase claim = case_of(Outcome::failed, "FJ07.3");
  claim.file = "";
  const json run = json::parse(sarif_report({claim}, "1.2.3"))["runs"][0];
  ASSERT_EQ(run["results"].size(), 1U);
  EXPECT_FALSE(run["results"][0].contains("locations")) << run;
}

TEST(Report, SarifShowsTheRulesThatAreNoUtf8) {
  ReportCase odd = case_of(Outcome::failed, "odd");
  odd.rule = "rule\xFF";
  odd.rule_text = "text\xFF";
  const json run = json::parse(sarif_report({odd, odd}, "1.2.3"))["runs"][0];
  ASSERT_EQ(run["tool"]["driver"]["rules"].size(), 1U);
  EXPECT_EQ(run["tool"]["driver"]["rules"][0]["id"], "rule\\xff");
  EXPECT_EQ(run["tool"]["driver"]["rules"][0]["shortDescription"]["text"], "text\\xff");
  EXPECT_EQ(run["results"][0]["ruleId"], "rule\\xff");
}

TEST(Report, JunitCountsEachOutcomeOnce) {
  const std::string xml = junit_report(all_outcomes());
  EXPECT_THAT(xml, HasSubstr("tests=\"5\" failures=\"1\" errors=\"2\" skipped=\"1\""));
  const auto count = [&](const std::string& tag) {
    const std::regex pattern("<" + tag + "[ >]");
    return std::distance(std::sregex_iterator(xml.begin(), xml.end(), pattern), std::sregex_iterator());
  };
  EXPECT_EQ(count("testcase"), 5);
  EXPECT_EQ(count("failure"), 1);
  EXPECT_EQ(count("error"), 2);
  EXPECT_EQ(count("skipped"), 1);
  EXPECT_THAT(xml, HasSubstr("the &lt;finding&gt; of bent"));
  EXPECT_THAT(xml, HasSubstr("replay: torse check bent"));
  EXPECT_TRUE(std::ranges::all_of(xml, [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); }));
}

}  // namespace
}  // namespace torse
