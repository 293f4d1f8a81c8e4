// A campaign for other tools: failing cases have their file and their command.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "torse/cli/campaign.hpp"

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
  const CaseFiles files{"runs.db", "runs.db.cases"};
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

}  // namespace
}  // namespace torse::cli
