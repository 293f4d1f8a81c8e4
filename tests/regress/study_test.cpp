// torse study, the real program: equal files from equal runs, shards and resumed runs; every case within the proved
// bound; the autopsy; every refusal.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "support/program.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/io/spline_file.hpp"

namespace torse::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

const char* const small_design = R"({"torse": 1, "type": "study", "name": "small", "kind": "routes", "seed": 5,
  "title": "a small one", "routes": ["FJ07.13", "FJ07.13.rulings", "FJ07.11"], "scalars": ["float", "float128"],
  "factors": {"degree": [2, 3], "pieces": [1, 3], "before": [0.5]},
  "repetitions": {"quick": 3, "standard": 4, "deep": 5}})";

class Study : public ::testing::Test {
 public:
  Study() { spill(path("small.json"), small_design); }
  std::string path(const std::string& name) const { return (scratch / name).string(); }
  ProgramResult run(std::vector<std::string> words) const {
    words.insert(words.begin(), "study");
    return run_program(words);
  }
  std::vector<json> lines(const std::string& name) const {
    std::vector<json> list;
    std::istringstream text(slurp(scratch / name));
    for (std::string line; std::getline(text, line);) list.push_back(json::parse(line));
    return list;
  }

  Scratch scratch;
};

TEST_F(Study, EqualRunsGiveEqualFiles) {
  ASSERT_EQ(run({path("small.json"), "--json", path("a"), "--csv", path("a.csv"), "--effort", "quick"}).exit, 0);
  ASSERT_EQ(
      run({path("small.json"), "--json", path("b"), "--csv", path("b.csv"), "--effort", "quick", "--threads", "1"})
          .exit,
      0);
  EXPECT_FALSE(slurp(scratch / "a").empty());
  EXPECT_EQ(slurp(scratch / "a"), slurp(scratch / "b"));
  EXPECT_EQ(slurp(scratch / "a.csv"), slurp(scratch / "b.csv"));
  EXPECT_FALSE(std::filesystem::exists(scratch / "a.part"));
  EXPECT_EQ(lines("a").size(), 12U);
  ASSERT_EQ(run({path("small.json"), "--json", path("c"), "--effort", "quick", "--seed", "6"}).exit, 0);
  ASSERT_EQ(run({path("small.json"), "--json", path("zero"), "--effort", "quick", "--seed", "0"}).exit, 0);
  EXPECT_NE(slurp(scratch / "a"), slurp(scratch / "c"));
  EXPECT_NE(slurp(scratch / "a"), slurp(scratch / "zero"));
}

TEST_F(Study, ShardsJoinToTheWhole) {
  std::string joined;
  std::string rows;
  for (const char* shard : {"1/5", "2/5", "3/5", "4/5", "5/5"}) {
    ASSERT_EQ(
        run({path("small.json"), "--json", path("s"), "--csv", path("s.csv"), "--effort", "quick", "--shard", shard})
            .exit,
        0);
    joined += slurp(scratch / "s");
    rows += slurp(scratch / "s.csv");
  }
  ASSERT_EQ(run({path("small.json"), "--json", path("a"), "--csv", path("a.csv"), "--effort", "quick"}).exit, 0);
  EXPECT_EQ(joined, slurp(scratch / "a"));
  EXPECT_EQ(rows, slurp(scratch / "a.csv"));
}

/// Kills the program as soon as its journal is there, at several moments.
TEST_F(Study, AKilledRunGoesOn) {
  ASSERT_EQ(run({path("small.json"), "--json", path("a"), "--effort", "quick"}).exit, 0);
  for (int attempt = 0; attempt < 3; ++attempt) {
    const pid_t child = fork();
    if (child == 0) {
      const std::string out = path("k");
      const std::string design = path("small.json");
      execl(TORSE_PROGRAM_PATH, "torse", "study", design.c_str(), "--json", out.c_str(), "--effort", "quick",
            "--resume", static_cast<char*>(nullptr));
      _exit(127);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20 + 10 * attempt));
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
  }
  ASSERT_EQ(run({path("small.json"), "--json", path("k"), "--effort", "quick", "--resume"}).exit, 0);
  EXPECT_EQ(slurp(scratch / "k"), slurp(scratch / "a"));
  EXPECT_FALSE(std::filesystem::exists(scratch / "k.part"));
}

TEST_F(Study, AnotherRunsJournalIsRefused) {
  const pid_t child = fork();
  if (child == 0) {
    const std::string out = path("k");
    execl(TORSE_PROGRAM_PATH, "torse", "study", "routes", "--json", out.c_str(), "--effort", "deep",
          static_cast<char*>(nullptr));
    _exit(127);
  }
  for (int i = 0; i < 6000 && !std::filesystem::exists(scratch / "k.part"); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  const ProgramResult other = run({path("small.json"), "--json", path("k"), "--effort", "quick", "--resume"});
  EXPECT_EQ(other.exit, 2);
  EXPECT_THAT(other.err, HasSubstr("k.part"));
  EXPECT_FALSE(std::filesystem::exists(scratch / "k"));
}

/// The design is small enough for every case of every built-in study to be looked at here.
TEST_F(Study, NoCaseOfAnyStudyExceedsTheBound) {
  double most = 0;
  std::size_t seen = 0;
  for (const char* name : {"growth", "near-knot", "gap", "offset", "knots"}) {
    ASSERT_EQ(run({name, "--json", path(name), "--effort", "quick"}).exit, 0) << name;
    for (const json& record : lines(name)) {
      for (const json& result : record["results"]) {
        if (!result["finite"].get<bool>() || result["bound"].is_null()) continue;
        ++seen;
        EXPECT_LE(result["bound"].get<double>(), 1) << record.dump();
        most = std::max(most, result["bound"].get<double>());
      }
    }
  }
  EXPECT_GT(seen, 50U);
  EXPECT_GT(most, 0.05);
}

/// A line's input is a file for torse construct.
TEST_F(Study, InputsCanBeUsedAgain) {
  ASSERT_EQ(run({path("small.json"), "--json", path("a"), "--effort", "quick"}).exit, 0);
  spill(path("in.json"), lines("a")[4]["input"].dump());
  ASSERT_EQ(run_program({"construct", "bspline", path("in.json"), "-o", path("net.json")}).exit, 0);
  EXPECT_EQ(run_program({"check", path("net.json")}).exit, 0);
  EXPECT_EQ(run({"autopsy", path("in.json")}).exit, 0);
}

TEST_F(Study, NaiveTestsAreCounted) {
  ASSERT_EQ(run({"verdicts", "--json", path("v"), "--effort", "quick"}).exit, 0);
  bool checked = false;
  for (const json& record : lines("v")) {
    const bool moved = record["factors"]["moved"].get<double>() > 0;
    EXPECT_EQ(record["developable"].get<bool>(), !moved);
    for (const json& result : record["results"]) {
      EXPECT_EQ(result["wrong"].get<bool>(), result["says_developable"] != record["developable"]);
    }
    if (moved && !checked) {  // the file of the net says the same
      spill(path("net.json"), record["input"].dump());
      EXPECT_EQ(run_program({"check", path("net.json")}).exit, 1);
      checked = true;
    }
  }
  EXPECT_TRUE(checked);
}

TEST_F(Study, AutopsyNamesThePlantedOperation) {
  // In y: r_1 = ((4 - 1) 0.7 + 0.3) / (4 - 0) = 0.6, then (4 - 2) r_1 = 1.2 against c_2 - c_1 = -1.2 + 2^-40.
  spill(path("planted.json"),
        R"({"torse":1,"type":"construct","method":"bspline","degree":2,"knots":[0,0,1,2,3,3],"c":{"points":
        [[0,0,0],[1,0.3,1],[2,"-4947802324987/5497558138880",2],[3,5,4],[5,8,4]]},"Lambda":5,"M":4,"d0":[1,0.7,1]})");
  const ProgramResult result = run({"autopsy", path("planted.json"), "--json", "-"});
  ASSERT_EQ(result.exit, 0) << result.err;
  const json loss = json::parse(result.out)["lost"][0];
  EXPECT_EQ(loss["formula"], "FJ07.13.rulings");
  EXPECT_EQ(loss["row"], "d");
  EXPECT_EQ(loss["index"], 2);
  EXPECT_EQ(loss["coordinate"], "y");
  EXPECT_THAT(run({"autopsy", path("planted.json")}).out, HasSubstr("d[2].y"));
  std::filesystem::copy_file(path("planted.json"), path("p\xFF.json"));
  const ProgramResult named = run({"autopsy", path("p\xFF.json"), "--json", "-"});
  EXPECT_EQ(named.exit, 0) << named.err;
  EXPECT_EQ(json::parse(named.out)["file"], path("p\\xff.json"));
  EXPECT_THAT(run({"autopsy", path("p\xFF.json")}).out, HasSubstr(path("p\\xff.json") + ": "));
}

TEST_F(Study, RefusesWhatItCannotUse) {
  const auto refused = [&](const std::vector<std::string>& words, const std::string& message) {
    const ProgramResult result = run(words);
    EXPECT_EQ(result.exit, 2) << message;
    EXPECT_THAT(result.err, HasSubstr(message));
  };
  refused({"rotues"}, "did you mean routes?");
  refused({path("absent.json")}, "absent.json");
  refused({"routes", "--shard", "3/2"}, "--shard");
  refused({"routes", "--effort", "much"}, "--effort");
  refused({"routes", "--resume"}, "--resume");
  refused({"autopsy"}, "expected a file");
  refused({"routes", "--json", "-", "--csv", "-"}, "only one");
  const auto design = [&](const std::string& from, const std::string& to) {
    std::string text = small_design;
    text.replace(text.find(from), from.size(), to);
    spill(path("bad.json"), text);
  };
  design("FJ07.11", "FJ07.99");
  refused({path("bad.json")}, "routes[2]");
  design("\"before\": [0.5]", "\"before\": [0.5], \"after\": [1]");
  refused({path("bad.json")}, "expected one of before, after and inside, which are places of the same M*, found 2\n");
  design("FJ07.11", "FJ07.13");
  refused({path("bad.json")}, "expected each name once, found \"FJ07.13\" again\n");
  design("[\"float\", \"float128\"]", "[]");
  refused({path("bad.json")}, "expected at least one name, found an array of 0\n");
  design("[0.5]", "[]");
  refused({path("bad.json")}, "expected at least one level, found an array of 0\n");
  std::string many = "[0.5";
  for (int i = 0; i < 25'000; ++i) many += ",1";
  design("[0.5]", many + "]");
  refused({path("bad.json")}, "expected at most 100000 combinations, found 100004\n");
  design("[1, 3]", "[1, 1000]");
  refused({path("bad.json")}, "factors.pieces[1]");
  design("\"seed\"", "\"sede\"");
  refused({path("bad.json")}, "sede");
  EXPECT_EQ(run({"list"}).exit, 0);
  EXPECT_THAT(run({"list"}).out, HasSubstr("near-knot"));
}

}  // namespace
}  // namespace torse::testing
