// torse list, explain, verify and example, the real program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "support/program.hpp"

namespace torse::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

/// The ids of the claims, in the order of the stored ledger.
std::vector<std::string> stored_ids() {
  std::vector<std::string> ids;
  const json ledger = json::parse(slurp(TORSE_SOURCE_PATH "/proofs/ledger.json"));
  for (const json& claim : ledger.at("claims")) ids.push_back(claim.at("id"));
  return ids;
}

std::vector<std::string> first_words(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) words.push_back(line.substr(0, line.find(' ')));
  return words;
}

TEST(List, HasTheClaimsOfTheLedger) {
  const ProgramResult list = run_program({"list"});
  EXPECT_EQ(list.exit, 0);
  EXPECT_EQ(first_words(list.out), stored_ids());
  std::vector<std::string> ids;
  const json report = json::parse(run_program({"list", "--json", "-"}).out);
  for (const json& claim : report.at("claims")) ids.push_back(claim.at("id"));
  EXPECT_EQ(ids, stored_ids());
}

TEST(List, OfOnePaperOfEnginesAndOfProperties) {
  const ProgramResult zw06 = run_program({"list", "--paper", "ZW06"});
  for (const std::string& id : first_words(zw06.out)) EXPECT_TRUE(id.starts_with("ZW06.")) << id;
  EXPECT_EQ(first_words(run_program({"list", "--engines"}).out),
            (std::vector<std::string>{"symbolic", "modular", "rational", "ball", "numeric", "mutation"}));
  const std::vector<std::string> properties = first_words(run_program({"list", "--properties"}).out);
  const json report = json::parse(run_program({"list", "--json", "-"}).out);
  std::string engines;
  for (const json& engine : report.at("engines")) {
    engines += engine.at("name").get<std::string>() +
               std::string(9 - engine.at("name").get<std::string>().size(), ' ') + " " +
               engine.at("scalar").get<std::string>() + ": " + engine.at("may_say").get<std::string>() + "\n";
  }
  EXPECT_EQ(engines, run_program({"list", "--engines"}).out);
  std::vector<std::string> names;
  for (const json& property : report.at("properties")) names.push_back(property.at("name"));
  EXPECT_EQ(names, properties);
  EXPECT_THAT(properties, ::testing::Contains("text.number"));
  EXPECT_THAT(properties, Not(::testing::Contains("FJ07.1")));
  const ProgramResult wrong = run_program({"list", "--paper", "FJ08"});
  EXPECT_EQ(wrong.exit, 2);
  EXPECT_THAT(wrong.err, HasSubstr("--paper: unknown name FJ08; did you mean FJ07?"));
}

TEST(Explain, TellsEveryClaimInLinesThatFit) {
  for (const std::string& id : stored_ids()) {
    SCOPED_TRACE(id);
    const ProgramResult told = run_program({"explain", id});
    EXPECT_EQ(told.exit, 0);
    EXPECT_TRUE(told.out.starts_with(id + "  "));
    EXPECT_THAT(told.out, HasSubstr("\n  statement   "));
    EXPECT_TRUE(told.out.ends_with("\n  run it      torse verify --claim " + id + "\n"));
    std::istringstream lines(told.out);
    for (std::string line; std::getline(lines, line);) {
      EXPECT_TRUE(line.size() <= 122 || line.find(' ', line.find_first_not_of(' ')) == std::string::npos) << line;
      EXPECT_EQ(line.find_last_not_of(' ') + 1, line.size()) << line;
    }
  }
}

/// FJ07.16 divides by M* - u_i and by M* - u_{i+n}; neither is said in the paper.
TEST(Explain, HypothesesWithWhatFailsWithoutThem) {
  const std::string told = run_program({"explain", "FJ07.16"}).out;
  EXPECT_THAT(told, HasSubstr("(not stated in the paper)\n      without it: M: expected a value that is not a knot"));
  EXPECT_THAT(told, HasSubstr("\n  wrong variants that must fail\n    L* and M* exchanged\n"));
  const ProgramResult wrong = run_program({"explain", "FJ07.99"});
  EXPECT_EQ(wrong.exit, 2);
  EXPECT_THAT(wrong.err, HasSubstr("CLAIM: unknown name FJ07.99"));
}

class Verify : public ::testing::Test {
 protected:
  std::string file(const std::string& name) const { return (scratch_ / name).string(); }
  static ProgramResult verify(std::vector<std::string> words) {
    words.insert(words.begin(), {"verify", "--effort", "quick"});
    return run_program(words);
  }

 private:
  Scratch scratch_;
};

TEST_F(Verify, ReportsWhatWasAskedFor) {
  const ProgramResult run = verify({"--claim", "FJ07.16", "--json", file("a.json"), "--junit", file("a.xml"), "--sarif",
                                    file("a.sarif"), "--ledger", file("ledger.json")});
  EXPECT_EQ(run.exit, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("\nFJ07.16     Proved"));
  EXPECT_THAT(run.out, HasSubstr("\n1 claims: 1 Proved, 0 surviving mutants\n"));
  const json report = json::parse(slurp(file("a.json")));
  ASSERT_EQ(report.at("claims").size(), 1U);
  EXPECT_EQ(report.at("claims").at(0).at("id"), "FJ07.16");
  EXPECT_THAT(slurp(file("a.xml")), HasSubstr("tests=\"1\""));
  EXPECT_EQ(json::parse(slurp(file("a.sarif"))).at("version"), "2.1.0");
  EXPECT_EQ(json::parse(slurp(file("ledger.json"))).at("claims").size(), 1U);
}

TEST_F(Verify, ShardsShareTheClaims) {
  std::multiset<std::string> ids;
  std::set<std::size_t> sizes;
  for (const char* shard : {"1/3", "2/3", "3/3"}) {
    const ProgramResult run = verify({"--paper", "BZZ19", "--engine", "rational", "--shard", shard, "--json", "-"});
    EXPECT_EQ(run.exit, 0) << run.err;
    const json report = json::parse(run.out);
    for (const json& claim : report.at("claims")) ids.insert(claim.at("id"));
    sizes.insert(report.at("claims").size());
  }
  EXPECT_LE(*sizes.rbegin() - *sizes.begin(), 1U);
  std::multiset<std::string> all;
  for (const std::string& id : stored_ids())
    if (id.starts_with("BZZ19")) all.insert(id);
  EXPECT_EQ(ids, all);
}

TEST_F(Verify, WhatMakesNoSenseIsAnError) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong{
      {{"--claim", "FJ07.99"}, "--claim: unknown name FJ07.99; did you mean FJ07.9?"},
      {{"--engine", "symbol"}, "--engine: unknown name symbol; did you mean symbolic?"},
      {{"--paper", "ZW6"}, "--paper: unknown name ZW6; did you mean ZW06?"},
      {{"--effort", "slow"}, "--effort: unknown name slow"},
      {{"--shard", "4/3"}, "--shard: expected i/k with 1 <= i <= k, found 4/3"},
      {{"--shard", "0/3"}, "--shard: expected i/k with 1 <= i <= k, found 0/3"},
      {{"--shard", "1/3x"}, "--shard: expected i/k with 1 <= i <= k, found 1/3x"},
      {{"--shard", "1"}, "--shard: expected i/k with 1 <= i <= k, found 1"},
      {{"--threads", "0"}, "--threads"},
      {{"--threads", "257"}, "--threads"},
      {{"--json", "-", "--junit", "-"}, "standard output"},
      {{"--baseline", "/nowhere.json"}, "/nowhere.json"}};
  for (const auto& [words, message] : wrong) {
    std::vector<std::string> line{"verify"};
    line.insert(line.end(), words.begin(), words.end());
    const ProgramResult run = run_program(line);
    EXPECT_EQ(run.exit, 2) << message;
    EXPECT_THAT(run.err, HasSubstr("torse: error: ")) << run.err;
    EXPECT_THAT(run.err, HasSubstr(message));
    EXPECT_EQ(run.out, "");
  }
}

/// A baseline in which the claim was Proved by engines that do not run now.
TEST_F(Verify, ABaselineTellsWhatGotWorse) {
  ASSERT_EQ(verify({"--claim", "FJ07.16", "--json", file("before.json")}).exit, 0);
  const ProgramResult worse = verify({"--claim", "FJ07.16", "--engine", "ball", "--baseline", file("before.json")});
  EXPECT_EQ(worse.exit, 1);
  EXPECT_THAT(worse.out, HasSubstr("worse: FJ07.16 was Proved and is Bounded"));
  EXPECT_EQ(verify({"--claim", "FJ07.16", "--baseline", file("before.json"), "--threads", "1"}).exit, 0);
}

TEST_F(Verify, ABaselineMayComeThroughAPipe) {
  const std::string before = R"({"claims": [{"id": "FJ07.16", "status": "Proved"}]})";
  for (const char* pipe : {"-", "/dev/stdin"}) {
    const ProgramResult worse = run_program(
        {"verify", "--claim", "FJ07.16", "--engine", "ball", "--effort", "quick", "--baseline", pipe}, before);
    EXPECT_EQ(worse.exit, 1) << worse.err;
    EXPECT_THAT(worse.out, HasSubstr("worse: FJ07.16 was Proved and is Bounded"));
  }
}

TEST(Example, EveryPrintedValueOfTheWorkedExample) {
  const ProgramResult run = run_program({"example"});
  EXPECT_EQ(run.exit, 0);
  EXPECT_THAT(run.out, HasSubstr("\n50 of 50 printed values reproduced exactly\n"));
  const ProgramResult report = run_program({"example", "--json", "-"});
  EXPECT_EQ(report.exit, 0);
  const json examples = json::parse(report.out).at("examples");
  EXPECT_FALSE(examples.empty());
  EXPECT_EQ(json::parse(report.out).at("torse"), 1);
  EXPECT_THAT(report.out, Not(HasSubstr("false")));
}

}  // namespace
}  // namespace torse::testing
