// torse campaign, the real program: killed and resumed, sharded, shown, merged, compared; errors.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <memory>
#include <random>

#include "support/process.hpp"
#include "torse/fuzz/properties.hpp"

namespace torse::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;
using Variables = std::map<std::string, std::string>;

class Campaign : public ::testing::Test {
 protected:
  ProgramResult run(const std::vector<std::string>& words, const Variables& variables = {}) const {
    Process process(words, variables, runs_.scratch() / "output");
    const int exit = process.wait();
    return {exit, process.output(), ""};
  }
  ProgramResult torse(std::vector<std::string> words, const Variables& variables = {}) const {
    words.insert(words.begin(), TORSE_PROGRAM_PATH);
    return run(words, variables);
  }
  /// One thread, in one go: what all other ways must come to.
  void expect_like_one_go(const std::string& name) const {
    ASSERT_TRUE(runs_.sound(name));
    const std::string seeds = "1.." + std::to_string(runs_.last_seed(name));
    const ProgramResult rest = run(runs_.run(name, seeds, "2"));
    ASSERT_EQ(rest.exit, 0) << rest.out;
    ASSERT_EQ(run(runs_.run("one-go", seeds, "1")).exit, 0);
    EXPECT_EQ(runs_.units(name), runs_.last_seed(name));
    const ProgramResult diff = torse({"campaign", "diff", runs_.file("one-go"), runs_.file(name)});
    EXPECT_EQ(diff.exit, 0) << diff.out;
    EXPECT_THAT(diff.out, HasSubstr("equal\n"));
  }
  /// A database whose seed 3 fails, by this program if `own`, otherwise by another build.
  void make_failing(const std::string& name, bool own) const {
    ASSERT_EQ(run(runs_.run(name, "1..2", "1")).exit, 0);
    fuzz::Store store(runs_.file(name), fuzz::Database::Open::existing);
    fuzz::RunInfo info = store.runs().begin()->second;
    info.token = "made up";
    if (!own) info.build = "another";
    fuzz::UnitResult unit{{runs_.property, "quick"}, 3, {}, 10};
    unit.tally.cases = 500;
    unit.tally.failed = 4;
    unit.tally.failures.push_back(
        {3, 17, "made up", R"({"torse": 1, "type": "case", "property": "text.number", "input": {"x": "2/3"}})"});
    fuzz::Transaction transaction(store.database());
    store.put(unit, store.put_run(info));
    transaction.commit();
  }

  CampaignRuns runs_;
};

TEST_F(Campaign, KilledAtAnyMomentLosesNothingStoredAndCountsNothingTwice) {
  std::mt19937 random(1);
  std::uint64_t stored = 0;
  for (int i = 0; i < 24; ++i) {
    Process process(runs_.run("killed", "1..1000000", "2"), {}, runs_.scratch() / "output");
    // Every third one is killed when it has stored something, the others at their beginning.
    const bool has_stored = i % 3 != 0 || wait_for([&] { return runs_.units("killed") > stored; });
    ASSERT_TRUE(has_stored) << process.output();
    std::this_thread::sleep_for(std::chrono::milliseconds(random() % 60));
    process.send(SIGKILL);
    EXPECT_EQ(process.wait(), 128 + SIGKILL);
    const std::uint64_t left = runs_.units("killed");
    EXPECT_GE(left, stored);
    stored = left;
  }
  EXPECT_GT(stored, 0U);
  expect_like_one_go("killed");
}

TEST_F(Campaign, ShardsShareADatabaseOrHaveTheirOwn) {
  std::vector<std::unique_ptr<Process>> processes;
  std::vector<std::string> merge{"campaign", "merge", runs_.file("merged")};
  for (const std::string index : {"0", "1", "2"}) {
    const Variables shard{{"GTEST_TOTAL_SHARDS", "3"},
                          {"GTEST_SHARD_INDEX", index},
                          {"GTEST_SHARD_STATUS_FILE", runs_.file("status" + index)}};
    for (const std::string& name : {std::string("shared"), "own" + index}) {
      processes.push_back(
          std::make_unique<Process>(runs_.run(name, "1..90", "1"), shard, runs_.scratch() / (name + index)));
    }
    merge.push_back(runs_.file("own" + index));
  }
  for (const auto& process : processes) EXPECT_EQ(process->wait(), 0) << process->output();
  EXPECT_TRUE(std::filesystem::exists(runs_.scratch() / "status2"));
  EXPECT_EQ(runs_.units("own1"), 30U);
  EXPECT_EQ(runs_.units("shared"), 90U);
  expect_like_one_go("shared");
  const ProgramResult merged = torse(merge);
  EXPECT_EQ(merged.exit, 0);
  EXPECT_THAT(merged.out, HasSubstr("90 units added"));
  EXPECT_EQ(torse({"campaign", "diff", runs_.file("shared"), runs_.file("merged")}).exit, 0);
  const ProgramResult part = torse({"campaign", "diff", runs_.file("own1"), runs_.file("merged")});
  EXPECT_EQ(part.exit, 3);
  EXPECT_THAT(part.out, HasSubstr("only in B"));
}

TEST_F(Campaign, ProcessesThatDoTheSameCountItOnce) {
  std::vector<std::unique_ptr<Process>> processes;
  for (int i = 0; i < 3; ++i) {
    processes.push_back(
        std::make_unique<Process>(runs_.run("same", "1..60", "1"), Variables(), runs_.scratch() / std::to_string(i)));
  }
  for (const auto& process : processes) EXPECT_EQ(process->wait(), 0) << process->output();
  expect_like_one_go("same");
}

TEST_F(Campaign, ADiskWithoutRoomIsAnErrorAndNothingIsLost) {
  std::vector<std::string> words{"sh", "-c", "trap '' XFSZ; ulimit -f 400; exec \"$@\"", "sh"};
  for (const std::string& word : runs_.run("full", "1..1000000", "1")) words.push_back(word);
  const ProgramResult full = run(words);
  EXPECT_EQ(full.exit, 2);
  EXPECT_THAT(full.out, HasSubstr("torse: error: " + runs_.file("full") + ": the database cannot be used: "));
  EXPECT_GT(runs_.units("full"), 0U);
  expect_like_one_go("full");
}

TEST_F(Campaign, ATimeLimitIsNoFailure) {
  std::vector<std::string> words = runs_.run("time", "5..", "1");
  words.insert(words.end(), {"--minutes", "0.005", "--json", "-"});
  const ProgramResult first = run(words);
  EXPECT_EQ(first.exit, 0);
  const json report = json::parse(first.out);
  EXPECT_EQ(report["complete"], false);
  EXPECT_EQ(report["seeds"], "5..");
  const std::uint64_t stored = runs_.units("time");
  EXPECT_EQ(report["units"]["stored"], stored);
  EXPECT_EQ(run(words).exit, 0);
  EXPECT_GT(runs_.units("time"), stored);
  EXPECT_EQ(runs_.last_seed("time"), runs_.units("time") + 4);  // no seed was left out or run twice
  words.resize(words.size() - 2);
  EXPECT_THAT(run(words).out, HasSubstr("stopped by --minutes"));
}

TEST_F(Campaign, NothingJudgedIsNoSuccess) {
  std::vector<std::string> words = runs_.run("a", "1..", "1");
  words.insert(words.end(), {"--minutes", "0"});
  const ProgramResult none = run(words);
  EXPECT_EQ(none.exit, 3);
  EXPECT_THAT(none.out, HasSubstr("nothing was judged"));
  ASSERT_EQ(run(runs_.run("a", "1", "1")).exit, 0);
  EXPECT_EQ(run(words).exit, 0);
}

TEST_F(Campaign, ReportsSayWhatWasCovered) {
  std::vector<std::string> words = runs_.run("a", "1..40", "2");
  words.insert(words.end(), {"--json", runs_.file("json"), "--junit", runs_.file("junit")});
  const ProgramResult result = run(words);
  EXPECT_EQ(result.exit, 0);
  EXPECT_THAT(result.out, HasSubstr("40 units, 20000 cases: 0 failed"));
  EXPECT_THAT(result.out, Not(HasSubstr("\r")));
  EXPECT_THAT(result.out, Not(HasSubstr("vacuous")));
  const json report = json::parse(slurp(runs_.scratch() / "json"));
  EXPECT_EQ(report["complete"], true);
  const json& property = report["properties"][0];
  EXPECT_EQ(property["property"], runs_.property);
  EXPECT_EQ(property["seeds"], 40);
  EXPECT_EQ(property["cases"], 20000);
  EXPECT_EQ(property["vacuous"], nullptr);
  EXPECT_EQ(property["labels"]["kind"]["integer"].get<int>() + property["labels"]["kind"]["fraction"].get<int>(),
            20000);
  EXPECT_THAT(slurp(runs_.scratch() / "junit"), HasSubstr("tests=\"1\""));
  const ProgramResult shown = torse({"campaign", "show", runs_.file("a"), "--json", "-"});
  EXPECT_EQ(shown.exit, 0);
  const json all = json::parse(shown.out);
  EXPECT_EQ(all["properties"][0]["labels"], property["labels"]);
  EXPECT_EQ(all["runs"][0]["version"], "0.1.0");
  EXPECT_EQ(all["runs"][0]["build"].get<std::string>().size(), 40U);
  EXPECT_THAT(torse({"campaign", "show", runs_.file("a")}).out, HasSubstr("integer"));
  EXPECT_THAT(torse({"replay", runs_.file("a")}).out, HasSubstr("nothing failed"));
}

TEST_F(Campaign, FailuresAreFilesThatReplayRuns) {
  make_failing("a", true);
  std::vector<std::string> words = runs_.run("a", "1..5", "1");
  words.insert(words.end(),
               {"--json", runs_.file("json"), "--junit", runs_.file("junit"), "--sarif", runs_.file("sarif")});
  const ProgramResult result = run(words);
  EXPECT_EQ(result.exit, 1);
  const std::string path = runs_.file("a.cases/text.number-quick-3-17.json");
  EXPECT_THAT(result.out, HasSubstr("failed: text.number, seed 3, quick effort: made up\n  case: " + path +
                                    "\n  replay: torse replay " + path + "\n"));
  EXPECT_EQ(torse({"replay", path}).exit, 0);
  const json report = json::parse(slurp(runs_.scratch() / "json"));
  EXPECT_EQ(report["failures"][0]["file"], path);
  EXPECT_EQ(report["failures"][0]["seed"], 3);
  EXPECT_EQ(report["properties"][0]["failed"], 4);
  EXPECT_THAT(slurp(runs_.scratch() / "junit"), HasSubstr("failures=\"1\""));
  const json found = json::parse(slurp(runs_.scratch() / "sarif"))["runs"][0]["results"];
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0]["locations"][0]["physicalLocation"]["artifactLocation"]["uri"], "file://" + path);
  EXPECT_EQ(torse({"campaign", "show", runs_.file("a")}).exit, 1);
  EXPECT_EQ(torse({"campaign", "show", runs_.file("a"), "--json", "-"}).exit, 1);
  EXPECT_EQ(torse({"campaign", "export", runs_.file("a"), "-o", runs_.file("x/y")}).exit, 0);
  EXPECT_EQ(slurp(runs_.scratch() / "x/y/text.number-quick-3-17.json"), slurp(path));
  const ProgramResult replayed = torse({"replay", runs_.file("a")});
  EXPECT_EQ(replayed.exit, 0);
  EXPECT_THAT(replayed.out, HasSubstr("seed 3, quick effort\ntext.number: holds"));
}

TEST_F(Campaign, AFailureOfAnotherBuildIsRunAgain) {
  make_failing("a", false);
  std::filesystem::copy_file(runs_.file("a"), runs_.file("before"));
  EXPECT_EQ(run(runs_.run("a", "1..3", "1")).exit, 0);
  const ProgramResult diff = torse({"campaign", "diff", runs_.file("before"), runs_.file("a")});
  EXPECT_EQ(diff.exit, 1);
  EXPECT_THAT(diff.out, HasSubstr("fails in A only: 1 seeds: 3\n"));
  const json report =
      json::parse(torse({"campaign", "diff", runs_.file("before"), runs_.file("a"), "--json", "-"}).out);
  EXPECT_EQ(report["torse"], 1);
  EXPECT_EQ(report["a"], runs_.file("before"));
  EXPECT_EQ(report["b"], runs_.file("a"));
  EXPECT_EQ(report["equal"], false);
  ASSERT_EQ(report["properties"].size(), 1U);
  const json& property = report["properties"][0];
  EXPECT_EQ(property["property"], "text.number");
  EXPECT_EQ(property["effort"], "quick");
  EXPECT_EQ(property["fixed"], json::parse("[[3, 3]]"));
  EXPECT_EQ(property["shifts"]["failed"], json({{"a", 4}, {"b", 0}}));
  std::uint64_t seeds = property["same"];
  for (const char* list : {"broken", "fixed", "changed", "only_in_a", "only_in_b"}) {
    for (const json& interval : property[list])
      seeds += interval[1].get<std::uint64_t>() - interval[0].get<std::uint64_t>() + 1;
  }
  EXPECT_EQ(seeds, 3U);
  EXPECT_EQ(torse({"campaign", "diff", runs_.file("before"), runs_.file("a"), "--json", runs_.file("diff.json")}).out,
            diff.out);
  EXPECT_EQ(json::parse(slurp(runs_.file("diff.json"))), report);
  EXPECT_THAT(torse({"campaign", "diff", runs_.file("a"), runs_.file("before")}).out,
              HasSubstr("fails in B only: 1 seeds: 3\n"));
}

/// A database holds more than a run is about.
TEST_F(Campaign, ARunTellsOfItsOwnSeeds) {
  make_failing("a", true);
  const ProgramResult first = run(runs_.run("a", "1..2", "1"));
  EXPECT_EQ(first.exit, 0) << first.out;
  EXPECT_THAT(first.out, Not(HasSubstr("made up")));
  EXPECT_THAT(first.out, Not(HasSubstr("seed 3")));
  const ProgramResult all = run(runs_.run("a", "1..3", "1"));
  EXPECT_EQ(all.exit, 1);
  EXPECT_THAT(all.out, HasSubstr("made up"));
}

/// Two databases that differ in why a case was discarded, and in nothing else.
TEST_F(Campaign, ReasonsOfDiscardsAreCompared) {
  for (const char* name : {"a", "b"}) {
    ASSERT_EQ(run(runs_.run(name, "1..2", "1")).exit, 0);
    fuzz::Store store(runs_.file(name), fuzz::Database::Open::existing);
    fuzz::RunInfo info = store.runs().begin()->second;
    info.token = "made up";
    fuzz::UnitResult unit{{runs_.property, "quick"}, 3, {}, 10};
    unit.tally.cases = 10;
    unit.tally.discarded = 1;
    unit.tally.discards.add("reason", std::string("because ") + name, 1);
    fuzz::Transaction transaction(store.database());
    store.put(unit, store.put_run(info));
    transaction.commit();
  }
  const ProgramResult diff = torse({"campaign", "diff", runs_.file("a"), runs_.file("b")});
  EXPECT_EQ(diff.exit, 3) << diff.out;
  EXPECT_THAT(diff.out, HasSubstr("because a"));
  EXPECT_THAT(diff.out, HasSubstr("because b"));
}

TEST_F(Campaign, ContradictionsAreNotMerged) {
  make_failing("a", true);
  EXPECT_EQ(run(runs_.run("b", "1..3", "1")).exit, 0);
  const ProgramResult merged = torse({"campaign", "merge", runs_.file("c"), runs_.file("a"), runs_.file("b")});
  EXPECT_EQ(merged.exit, 2);
  EXPECT_THAT(merged.out, HasSubstr("text.number, seed 3, quick effort"));
  EXPECT_FALSE(std::filesystem::exists(runs_.scratch() / "c"));
}

TEST_F(Campaign, AMergeThatFailsLeavesEverythingAsItWas) {
  make_failing("a", true);
  EXPECT_EQ(run(runs_.run("b", "1..3", "1")).exit, 0);
  EXPECT_EQ(run(runs_.run("more", "4..5", "1")).exit, 0);
  spill(runs_.scratch() / "empty", "");
  const auto bytes = [&](const std::string& name) { return slurp(runs_.scratch() / name); };
  const std::string a = bytes("a");
  const std::string b = bytes("b");
  const auto merged = [&](const std::string& into, const std::vector<std::string>& from) {
    std::vector<std::string> words{"campaign", "merge", runs_.file(into)};
    for (const std::string& name : from) words.push_back(runs_.file(name));
    return torse(words);
  };
  for (const auto& [into, from] : std::vector<std::pair<std::string, std::vector<std::string>>>{
           {"a", {"more", "b"}}, {"b", {"more", "a"}}, {"empty", {"more", "a", "b"}}}) {
    const ProgramResult result = merged(into, from);
    EXPECT_EQ(result.exit, 2);
    EXPECT_THAT(result.out, HasSubstr("contradicts what was merged before: text.number, seed 3, quick effort"));
  }
  for (const std::string own : {"a", "./a"}) {
    const ProgramResult result = merged("a", {"more", own});
    EXPECT_EQ(result.exit, 2);
    EXPECT_THAT(result.out, HasSubstr("expected another database than the one to merge into"));
  }
  EXPECT_TRUE(bytes("a") == a);
  EXPECT_TRUE(bytes("b") == b);
  EXPECT_TRUE(bytes("empty").empty());
  EXPECT_EQ(merged("empty", {"more", "a"}).exit, 0);
  EXPECT_EQ(runs_.units("empty"), 5U);
}

TEST_F(Campaign, NamesThatAreNoUtf8AreWrittenWithEscapes) {
  const std::string name = "n\xFF";
  const std::string shown = runs_.file("n\\xff");
  const std::string path = shown + ".cases/text.number-quick-3-17.json";
  make_failing(name, true);
  const std::vector<std::string> words = runs_.run(name, "1..3", "1");
  const ProgramResult text = run(words);
  EXPECT_EQ(text.exit, 1);
  EXPECT_THAT(text.out, HasSubstr("\n  case: " + path + "\n  replay: torse replay '" + path + "'\n"));
  std::vector<std::string> reports = words;
  reports.insert(reports.end(), {"--json", "-", "--junit", runs_.file("junit"), "--sarif", runs_.file("sarif")});
  const ProgramResult result = run(reports);
  EXPECT_EQ(result.exit, 1);
  const json report = json::parse(result.out);
  EXPECT_EQ(report["campaign"], shown);
  EXPECT_EQ(report["failures"][0]["file"], path);
  EXPECT_EQ(report["failures"][0]["replay"], "torse replay '" + path + "'");
  EXPECT_THAT(slurp(runs_.scratch() / "junit"), HasSubstr("replay: torse replay '" + path + "'"));
  const json found = json::parse(slurp(runs_.scratch() / "sarif"))["runs"][0]["results"][0];
  EXPECT_EQ(found["locations"][0]["physicalLocation"]["artifactLocation"]["uri"],
            "file://" + runs_.file("n%FF.cases/text.number-quick-3-17.json"));

  const json all = json::parse(torse({"campaign", "show", runs_.file(name), "--json", "-"}).out);
  EXPECT_EQ(all["campaign"], shown);
  EXPECT_EQ(all["failures"][0]["replay"], "torse replay '" + shown + "'");
  const json diff = json::parse(torse({"campaign", "diff", runs_.file(name), runs_.file(name), "--json", "-"}).out);
  EXPECT_EQ(diff["a"], shown);
  EXPECT_EQ(diff["b"], shown);
  EXPECT_EQ(torse({"campaign", "merge", runs_.file("m\xFF"), runs_.file(name)}).out,
            runs_.file("m\\xff") + ": 3 units added, 0 were there already\n");
  EXPECT_THAT(torse({"replay", runs_.file(name)}).out, HasSubstr(shown + ", text.number, seed 3, quick effort\n"));
}

TEST_F(Campaign, NamesThatAreTooLongAreErrorsOfTheirFile) {
  make_failing("a", true);
  const std::string longest = runs_.file(std::string(300, 'x'));
  const ProgramResult merged = torse({"campaign", "merge", longest, runs_.file("a")});
  EXPECT_EQ(merged.exit, 2);
  EXPECT_EQ(merged.out, "torse: error: " + longest + ": the database cannot be used: unable to open database file\n");
  const ProgramResult exported = torse({"campaign", "export", runs_.file("a"), "-o", longest});
  EXPECT_EQ(exported.exit, 2);
  EXPECT_EQ(exported.out, "torse: error: " + longest + ": cannot be made: File name too long\n");
}

TEST_F(Campaign, WhatMakesNoSenseIsAnError) {
  spill(runs_.scratch() / "text", "no database");
  const std::string other = runs_.file("new");
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong{
      {{"run"}, "--db is required"},
      {{"run", "--db", other, "--seeds", "5..3"}, "--seeds: expected A..B"},
      {{"run", "--db", other, "--seeds", "5.."}, "needs --minutes"},
      {{"run", "--db", other, "--property", "text.numbr"}, "did you mean text.number?"},
      {{"run", "--db", other, "--effort", "deeep"}, "did you mean deep?"},
      {{"run", "--db", other, "--jobs", "0"}, "--jobs"},
      {{"run", "--db", other, "--minutes", "-1"}, "--minutes"},
      {{"run", "--db", other, "--seds", "1"}, "did you mean --seeds?"},
      {{"rum"}, "unexpected word rum; did you mean run?"},
      {{}, "expected run, show, merge, diff or export"},
      {{"run", "--db", runs_.file("text"), "--seeds", "1"}, "expected a database of torse campaign"},
      {{"run", "--db", runs_.file("none/x"), "--seeds", "1"}, "unable to open database file"},
      {{"run", "--db", runs_.scratch().path().string(), "--seeds", "1"}, "found a folder"},
      {{"show", runs_.file("text")}, "expected a database of torse campaign"},
      {{"show", other}, "unable to open database file"},
      {{"diff", other, other}, "unable to open database file"},
      {{"merge", other, other}, "unable to open database file"},
      {{"export", runs_.file("text"), "-o", runs_.file("x")}, "expected a database of torse campaign"}};
  for (const auto& [words, message] : wrong) {
    std::vector<std::string> line{"campaign"};
    line.insert(line.end(), words.begin(), words.end());
    const ProgramResult result = torse(line);
    EXPECT_EQ(result.exit, 2) << result.out;
    EXPECT_THAT(result.out, HasSubstr(message));
  }
  EXPECT_FALSE(std::filesystem::exists(other));
  const ProgramResult shard = torse({"campaign", "run", "--db", other}, {{"GTEST_TOTAL_SHARDS", "3"}});
  EXPECT_EQ(shard.exit, 2);
  EXPECT_THAT(shard.out, HasSubstr("GTEST_SHARD_INDEX"));
}

}  // namespace
}  // namespace torse::testing
