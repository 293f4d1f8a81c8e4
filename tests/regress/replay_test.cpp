// torse replay of reports, surfaces and constructions, the real program. tests/regress/campaign_test.cpp has databases,
// saved_cases_test.cpp saved cases.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/program.hpp"

namespace torse::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

class Replay : public ::testing::Test {
 protected:
  ProgramResult replay(const std::string& text) const {
    spill(scratch_ / "file.json", text);
    return run_program({"replay", path()});
  }
  std::string path() const { return (scratch_ / "file.json").string(); }
  /// A report of torse verify with these findings of one claim.
  static std::string report(const json& findings) {
    return json{
        {"torse", 1}, {"effort", "quick"}, {"seed", 7}, {"claims", {{{"id", "FJ07.16"}, {"engines", findings}}}}}
        .dump();
  }
  /// The commands that were run, without what they printed.
  static std::string commands(const std::string& out) {
    std::string list;
    std::istringstream lines(out);
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("torse ")) list += line + "\n";
    }
    return list;
  }

 private:
  Scratch scratch_;
};

std::string verify(const std::string& engine) {
  return "torse verify --claim FJ07.16 --engine " + engine + " --effort quick --seed 7\n";
}

TEST_F(Replay, OfAReportWhateverFailedOrStayedOpen) {
  const ProgramResult some = replay(report({{{"engine", "rational"}, {"status", "Refuted"}},
                                            {{"engine", "symbolic"}, {"status", "Proved"}},
                                            {{"engine", "modular"}, {"status", "GaveUp"}},
                                            {{"engine", "ball"}, {"status", "Undecided"}}}));
  EXPECT_EQ(some.exit, 0) << some.err;  // they hold now
  EXPECT_EQ(commands(some.out), verify("rational") + verify("modular") + verify("ball"));
  EXPECT_THAT(some.out, HasSubstr("1 claims: "));
  const ProgramResult survived =
      replay(report({{{"engine", "rational"}, {"status", "Supported"}, {"survivors", {"a sign"}}},
                     {{"engine", "modular"}, {"status", "Supported"}, {"survivors", json::array()}}}));
  EXPECT_EQ(commands(survived.out), verify("rational"));
}

TEST_F(Replay, OfAReportInWhichNothingFailed) {
  const ProgramResult none = replay(report({{{"engine", "rational"}, {"status", "Supported"}}, {{"engine", "ball"}}}));
  EXPECT_EQ(none.exit, 0);
  EXPECT_EQ(none.out, "nothing failed in this report\n");
}

TEST_F(Replay, OfAReportThatIsNone) {
  for (const char* text : {R"({"claims": [{"id": "FJ07.16"}]})", R"({"claims": 1})", R"({"claims": [1]})"}) {
    const ProgramResult broken = replay(text);
    EXPECT_EQ(broken.exit, 2) << text;
    EXPECT_THAT(broken.err, HasSubstr(path() + ": expected a report of torse verify --json, found"));
    EXPECT_EQ(broken.out, "");
  }
}

TEST_F(Replay, TheWorstExitCodeCounts) {
  json engines = json::array();
  for (const char* engine : {"nothing", "rational"}) engines.push_back({{"engine", engine}, {"status", "Refuted"}});
  const ProgramResult result = replay(report(engines));
  EXPECT_EQ(result.exit, 2);
  EXPECT_EQ(commands(result.out), verify("nothing") + verify("rational"));
}

TEST_F(Replay, OfASurfaceChecksIt) {
  const ProgramResult twisted = replay(R"({"torse": 1, "type": "ruled", "degree": 1,
    "c": {"points": [[0,0,0],[1,0,0]]}, "d": {"points": [[0,1,0],[1,1,1]]}})");
  EXPECT_EQ(twisted.exit, 1);
  EXPECT_TRUE(twisted.out.starts_with("torse check " + path() + "\n" + path())) << twisted.out;
  EXPECT_THAT(twisted.out, HasSubstr("not developable"));
}

/// A pipe can be read only once.
TEST_F(Replay, OfWhatComesThroughAPipe) {
  for (const char* pipe : {"-", "/dev/stdin"}) {
    const ProgramResult twisted = run_program({"replay", pipe}, R"({"torse": 1, "type": "ruled", "degree": 1,
      "c": {"points": [[0,0,0],[1,0,0]]}, "d": {"points": [[0,1,0],[1,1,1]]}})");
    EXPECT_EQ(twisted.exit, 1) << twisted.err;
    EXPECT_TRUE(twisted.out.starts_with("torse check -\n-  not developable")) << twisted.out;
    const ProgramResult made = run_program({"replay", pipe}, R"({"torse": 1, "type": "construct", "method": "cone",
      "degree": 1, "c": {"points": [[0,0,0],[1,0,0]]}, "d0": [0,0,2], "Lambda": "1/2"})");
    EXPECT_EQ(made.exit, 0) << made.err;
    EXPECT_EQ(commands(made.out), "torse construct cone - -o -\n");
    const ProgramResult again = run_program({"replay", pipe}, report({{{"engine", "ball"}, {"status", "Refuted"}}}));
    EXPECT_EQ(again.exit, 0) << again.err;
    EXPECT_EQ(commands(again.out), verify("ball"));
  }
}

TEST_F(Replay, OfAConstructionMakesItAgain) {
  const ProgramResult made = replay(R"({"torse": 1, "type": "construct", "method": "cone", "degree": 1,
    "c": {"points": [[0,0,0],[1,0,0]]}, "d0": [0,0,2], "Lambda": "1/2"})");
  EXPECT_EQ(commands(made.out), "torse construct cone " + path() + " -o -\n");
  const ProgramResult strange = replay(R"({"torse": 1, "type": "rails"})");
  EXPECT_EQ(strange.exit, 2);
  EXPECT_THAT(strange.err, HasSubstr("\"case\", \"ruled\", \"construct\" or a report of torse verify"));
}

}  // namespace
}  // namespace torse::testing
