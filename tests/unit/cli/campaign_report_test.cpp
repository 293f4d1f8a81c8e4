// A campaign for other tools: failing cases have their file and their command.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>

#include "support/program.hpp"
#include "torse/cli/campaign.hpp"
#include "torse/io/document.hpp"

namespace torse::cli {
namespace {

SeriesReport series(std::uint64_t failed) {
  SeriesReport report;
  report.series = {"text.number", "quick"};
  report.units = 2;
  report.tally.cases = 1000;
  report.tally.failed = failed;
  report.seconds = 0.5;
  if (failed > 0) report.failures.push_back({report.series, {7, 3, "differs", "{}"}, "here"});
  return report;
}

TEST(CampaignReport, AFailureHasItsFileAndItsCommand) {
  const CaseFiles files{"runs.db", "runs.db.cases", {"runs.db.cases/text.number-quick-7-3.json"}};
  const std::vector<ReportCase> cases = cases_of({series(0), series(4)}, files);
  ASSERT_EQ(cases.size(), 2U);
  EXPECT_EQ(cases[0].outcome, Outcome::passed);
  EXPECT_EQ(cases[0].message, "1000 cases of 2 seeds hold");
  EXPECT_EQ(cases[0].file, "");
  EXPECT_EQ(cases[1].outcome, Outcome::failed);
  EXPECT_EQ(cases[1].message, "4 of 1000 cases fail; seed 7: differs");
  EXPECT_EQ(cases[1].file, "runs.db.cases/text.number-quick-7-3.json");
  EXPECT_THAT(cases[1].replay, ::testing::HasSubstr("torse replay runs.db.cases/text.number-quick-7-3.json"));
  EXPECT_EQ(cases[1].seconds, 0.5);
}

TEST(CampaignReport, NothingFoundOutIsAFailure) {
  SeriesReport vacuous = series(0);
  vacuous.vacuous = "no case has weights";
  const ReportCase found = cases_of({vacuous}, {"runs.db", ""}).front();
  EXPECT_EQ(found.outcome, Outcome::failed);
  EXPECT_EQ(found.message, "vacuous: no case has weights");
}

/// What is printed, in a file instead of a terminal.
template <class Print>
std::string printed(Print print) {
  std::FILE* file = std::tmpfile();
  print(Terminal(file));
  std::string text(static_cast<std::size_t>(std::ftell(file)), ' ');
  std::rewind(file);
  EXPECT_EQ(std::fread(text.data(), 1, text.size(), file), text.size());
  std::fclose(file);
  return text;
}

TEST(CampaignReport, NamesOfADatabaseThatAreNoUtf8AreWrittenWithEscapes) {
  SeriesReport odd = series(4);
  odd.series = {"p\xFF", "q\xFF"};
  odd.vacuous = "no case has weights";
  odd.failures.front().series = odd.series;
  const CaseFiles files{"d\xFF", ""};
  const std::string text = printed([&](const Terminal& terminal) { print_failures(terminal, {odd}, files); });
  EXPECT_EQ(text,
            "vacuous: p\\xff, q\\xff effort: no case has weights\n"
            "failed: p\\xff, seed 7, q\\xff effort: differs\n  replay: torse replay 'd\\xff'\n");
  nlohmann::ordered_json json;
  add_reports(json, {odd}, files);
  EXPECT_EQ(nlohmann::ordered_json::parse(json.dump())["failures"][0]["property"], "p\\xff");
}

/// Values with 1, 2, ... cases each, named by their numbers of cases.
void add_values(fuzz::Distribution& distribution, const std::string& key, std::uint64_t count) {
  for (std::uint64_t i = 1; i <= count; ++i) distribution.add(key, "v" + std::to_string(i), i);
}

TEST(CampaignReport, SharesOfTwelveValuesAreShown) {
  SeriesReport report = series(0);
  add_values(report.tally.labels, "degree", 3);
  add_values(report.tally.labels, "few", 12);
  add_values(report.tally.labels, "many", 13);
  report.tally.discarded = 4;
  report.tally.discards.add("reason", "a knot", 3);
  report.tally.discards.add("reason", "no plane", 1);
  EXPECT_EQ(printed([&](const Terminal& terminal) { print_reports(terminal, {report}); }),
            "property                 effort        seeds        cases   failed  discarded   cases/s core\n"
            "text.number              quick             2         1000        0          4           2000\n"
            "  degree                 v3 3 (50.0%), v2 2 (33.3%), v1 1 (16.7%)\n"
            "  few                    v12 12 (15.4%), v11 11 (14.1%), v10 10 (12.8%), v9 9 (11.5%), v8 8 (10.3%), "
            "v7 7 (9.0%), v6 6 (7.7%), v5 5 (6.4%), v4 4 (5.1%), v3 3 (3.8%), v2 2 (2.6%), v1 1 (1.3%)\n"
            "  many                   v13 13 (14.3%), v12 12 (13.2%), v11 11 (12.1%), v10 10 (11.0%), v9 9 (9.9%), "
            "v8 8 (8.8%), v7 7 (7.7%), v6 6 (6.6%), v5 5 (5.5%), v4 4 (4.4%), v3 3 (3.3%), v2 2 (2.2%), and 1 more\n"
            "  discarded              a knot 3 (75.0%), no plane 1 (25.0%)\n");
  report.seconds = 0;
  EXPECT_EQ(report.speed(), 0);
}

TEST(CampaignReport, FailuresWithTheirCommands) {
  SeriesReport failing = series(2);
  failing.vacuous = "no case has weights";
  const CaseFiles files{"runs.db", "cases", {"cases/text.number-quick-7-3.json"}};
  const std::string one =
      "failed: text.number, seed 7, quick effort: differs\n  case: cases/text.number-quick-7-3.json\n"
      "  replay: torse replay cases/text.number-quick-7-3.json\n";
  const auto text = [&](std::size_t count, const CaseFiles& where) {
    failing.failures.resize(count, failing.failures.front());
    return printed([&](const Terminal& terminal) { print_failures(terminal, {failing}, where); });
  };
  const std::string vacuous = "vacuous: text.number, quick effort: no case has weights\n";
  EXPECT_EQ(text(1, files), vacuous + one);
  EXPECT_EQ(text(1, {"runs.db", ""}),
            vacuous + "failed: text.number, seed 7, quick effort: differs\n  replay: torse replay runs.db\n");
  std::string twenty = vacuous;
  for (int i = 0; i < 20; ++i) twenty += one;
  EXPECT_EQ(text(20, files), twenty);
  EXPECT_EQ(text(22, files), twenty + "and 2 failing cases more\n");
}

/// Of three failing cases two are written: the third is in the database only.
TEST(CampaignReport, NamesTheFilesThatThereAre) {
  const testing::Scratch scratch;
  SeriesReport failing = series(3);
  for (const std::uint64_t seed : {8U, 9U}) {
    failing.failures.push_back(failing.failures.front());
    failing.failures.back().saved.seed = seed;
  }
  CaseFiles files{"-runs.db", (scratch / "cases").string()};
  write_cases({failing}, files, 2);
  nlohmann::ordered_json json;
  add_reports(json, {failing}, files);
  ASSERT_EQ(json["failures"].size(), 3U);
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string file = json["failures"][i]["file"];
    EXPECT_EQ(testing::slurp(file), "{}");
    EXPECT_EQ(json["failures"][i]["replay"], "torse replay " + file);
  }
  EXPECT_EQ(json["failures"][2]["file"], nullptr);
  EXPECT_EQ(json["failures"][2]["replay"], "torse replay ./-runs.db");

  SeriesReport last = series(1);
  last.failures.front().saved.seed = 9;
  const ReportCase c = cases_of({last}, files).front();
  EXPECT_EQ(c.file, "");
  EXPECT_EQ(c.replay, "torse replay ./-runs.db");
}

TEST(CampaignReport, NamesThatAreNoFilesAreRefused) {
  SeriesReport strange = series(1);
  strange.failures[0].series.property = "../text";
  EXPECT_EQ(CaseFiles({"runs.db", ""}).file(strange.failures[0]), "");
  try {
    CaseFiles({"runs.db", "cases"}).path(strange.failures[0]);
    FAIL() << "a folder above";
  } catch (const FileError& error) {
    EXPECT_STREQ(error.what(), "runs.db: expected the name of a property and an effort, found \"../text\"");
  }
}

TEST(CampaignReport, EveryMemberOfTheJson) {
  SeriesReport report = series(4);
  report.tally.discarded = 1;
  report.tally.labels.add("degree", "2", 600);
  report.tally.discards.add("reason", "a knot", 1);
  nlohmann::ordered_json json;
  add_reports(json, {report}, {"runs.db", "cases", {"cases/text.number-quick-7-3.json"}});
  EXPECT_EQ(json, nlohmann::ordered_json::parse(R"({"properties": [{"property": "text.number", "effort": "quick",
    "seeds": 2, "cases": 1000, "failed": 4, "discarded": 1, "vacuous": null, "seconds": 0.5, "cases_per_second": 2000.0,
    "labels": {"degree": {"2": 600}}, "discards": {"reason": {"a knot": 1}}}],
    "failures": [{"property": "text.number", "effort": "quick", "seed": 7, "case": 3, "message": "differs",
    "file": "cases/text.number-quick-7-3.json", "replay": "torse replay cases/text.number-quick-7-3.json"}]})"));
}

}  // namespace
}  // namespace torse::cli
