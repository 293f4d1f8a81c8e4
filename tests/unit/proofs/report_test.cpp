// The status of a claim out of its findings, the reports of it, and what they say of an earlier one.
#include "torse/proofs/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "torse/proofs/runner.hpp"

namespace torse::proofs {
namespace {

using Json = nlohmann::json;
using testing::ElementsAre;
using testing::IsEmpty;

Finding found(const char* engine, Status status) {
  Finding finding;
  finding.claim = "TEST.1";
  finding.engine = engine;
  finding.status = status;
  return finding;
}

ClaimInfo claim(std::vector<Hypothesis> hypotheses = {}) {
  ClaimInfo info;
  info.id = "TEST.1";
  info.hypotheses = std::move(hypotheses);
  return info;
}

Entry entry(std::vector<Finding> findings) {
  static const ClaimInfo info = claim();
  return {&info, std::move(findings)};
}

TEST(Entries, ARefutationOutweighsAProof) {
  const Entry both = entry({found("symbolic", Status::proved), found("rational", Status::refuted)});
  EXPECT_EQ(both.status(), Status::refuted);
  EXPECT_EQ(both.decisive()->engine, "rational");
  EXPECT_EQ(entry({found("rational", Status::refuted), found("symbolic", Status::proved)}).status(), Status::refuted);
}

TEST(Entries, TheStrongestFindingDecides) {
  constexpr std::array<Status, 7> order{Status::not_applicable, Status::gave_up, Status::undecided, Status::bounded,
                                        Status::supported,      Status::proved,  Status::refuted};
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    EXPECT_EQ(entry({found("ball", order[i]), found("numeric", order[i + 1])}).status(), order[i + 1]);
    EXPECT_EQ(entry({found("ball", order[i + 1]), found("numeric", order[i])}).status(), order[i + 1]);
  }
}

TEST(Entries, TheMutationEngineDecidesAlone) {
  const Finding mutation = found("mutation", Status::supported);
  const Entry both = entry({found("ball", Status::bounded), mutation});
  EXPECT_EQ(both.status(), Status::bounded);
  EXPECT_EQ(both.decisive()->engine, "ball");
  EXPECT_EQ(entry({mutation, found("ball", Status::gave_up)}).status(), Status::gave_up);
  EXPECT_EQ(entry({mutation}).status(), Status::supported);
  EXPECT_EQ(entry({}).decisive(), nullptr);
  EXPECT_EQ(entry({}).status(), Status::not_applicable);
}

/// What the JSON report says of a claim with one finding.
Json reported(const Finding& finding, const ClaimInfo& info = claim()) {
  return Json::parse(json_report({{&info, {finding}}}, {})).at("claims").at(0);
}

TEST(Report, AsPrintedIfEveryHypothesisIsStated) {
  const auto as_printed = [](const std::vector<Hypothesis>& hypotheses) {
    return reported(found("symbolic", Status::proved), claim(hypotheses)).at("as_printed").get<bool>();
  };
  EXPECT_TRUE(as_printed({}));
  EXPECT_TRUE(as_printed({{"a", true}, {"b", true}}));
  EXPECT_FALSE(as_printed({{"a", false}, {"b", true}}));
  EXPECT_FALSE(as_printed({{"a", true}, {"b", false}}));
}

TEST(Report, TheErrorIsNeverRoundedDown) {
  Finding finding = found("modular", Status::supported);
  const auto error = [&](double log2) {
    finding.error_log2 = log2;
    return reported(finding).at("error_log2").get<double>();
  };
  EXPECT_EQ(error(-119.75), -119.7);
  EXPECT_EQ(error(-119.79), -119.7);
  EXPECT_EQ(error(-119.71), -119.7);
  EXPECT_EQ(error(-119.5), -119.5);
  EXPECT_TRUE(reported(found("ball", Status::bounded)).at("error_log2").is_null());
}

constexpr std::array<std::pair<const char*, Status>, 7> by_strength{{{"Refuted", Status::refuted},
                                                                     {"NotApplicable", Status::not_applicable},
                                                                     {"GaveUp", Status::gave_up},
                                                                     {"Undecided", Status::undecided},
                                                                     {"Bounded", Status::bounded},
                                                                     {"Supported", Status::supported},
                                                                     {"Proved", Status::proved}}};

std::string earlier(const std::string& status, const char* engine) {
  const Json name = engine == nullptr ? Json() : Json(engine);
  return Json{{"claims", {{{"id", "TEST.1"}, {"status", status}, {"engine", name}}}}}.dump();
}

TEST(Baseline, EveryLossOfStrengthIsWorse) {
  for (std::size_t i = 0; i + 1 < by_strength.size(); ++i) {
    const auto& [low, less] = by_strength.at(i);
    const auto& [high, more] = by_strength.at(i + 1);
    EXPECT_THAT(regressions(earlier(high, "ball"), {entry({found("ball", less)})}, Extent::whole),
                ElementsAre(std::string("TEST.1 was ") + high + " and is " + low));
    EXPECT_THAT(regressions(earlier(low, "ball"), {entry({found("ball", more)})}, Extent::whole), IsEmpty());
    EXPECT_THAT(regressions(earlier(low, "ball"), {entry({found("ball", less)})}, Extent::whole), IsEmpty());
  }
}

TEST(Baseline, InAShardIsComparedWhereTheEngineThatEarnedItRan) {
  const std::string proved = earlier("Proved", "symbolic");
  EXPECT_THAT(regressions(proved, {entry({found("ball", Status::bounded)})}, Extent::shard), IsEmpty());
  EXPECT_THAT(regressions(proved, {entry({found("ball", Status::bounded)})}, Extent::selected),
              ElementsAre("TEST.1 was Proved and is Bounded"));
  EXPECT_THAT(
      regressions(proved, {entry({found("symbolic", Status::gave_up), found("ball", Status::bounded)})}, Extent::shard),
      ElementsAre("TEST.1 was Proved and is Bounded"));
  EXPECT_THAT(
      regressions(proved, {entry({found("ball", Status::bounded), found("symbolic", Status::gave_up)})}, Extent::shard),
      ElementsAre("TEST.1 was Proved and is Bounded"));
  EXPECT_THAT(regressions(proved, {entry({found("ball", Status::refuted)})}, Extent::shard),
              ElementsAre("TEST.1 was Proved and is Refuted"));
  EXPECT_THAT(regressions(earlier("Proved", nullptr), {entry({found("ball", Status::bounded)})}, Extent::shard),
              ElementsAre("TEST.1 was Proved and is Bounded"));
}

}  // namespace
}  // namespace torse::proofs
