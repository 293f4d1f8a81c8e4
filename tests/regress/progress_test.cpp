// The line that tells on a terminal how far a long run is: it counts up to the end, says what was last, and is gone
// when the run is over. A file gets none of it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "support/program.hpp"
#include "support/terminal.hpp"

namespace torse::testing {
namespace {

using ::testing::HasSubstr;

/// To the begin of the line, which is emptied.
const std::string anew = "\r\033[K";

/// What the line said, one after the other; the last one is the empty line.
std::vector<std::string> lines_of(const std::string& screen) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < screen.size();) {
    EXPECT_EQ(screen.compare(at, anew.size(), anew), 0) << screen.substr(at, 40);
    const std::size_t end = screen.find(anew, at + 1);
    lines.push_back(screen.substr(at + anew.size(), end == std::string::npos ? end : end - at - anew.size()));
    at = end == std::string::npos ? screen.size() : end;
  }
  return lines;
}

/// Both numbers of "[i/n]".
std::pair<int, int> counts(const std::string& line) {
  std::smatch found;
  EXPECT_TRUE(std::regex_search(line, found, std::regex("^\\[(\\d+)/(\\d+)\\]"))) << line;
  return found.empty() ? std::pair(0, 0) : std::pair(std::stoi(found[1]), std::stoi(found[2]));
}

/// From 1 to the number of all, and then nothing.
void expect_counted(const std::vector<std::string>& lines) {
  ASSERT_GE(lines.size(), 2U);
  const int all = static_cast<int>(lines.size()) - 1;
  for (int i = 0; i < all; ++i) EXPECT_EQ(counts(lines[static_cast<std::size_t>(i)]), std::pair(i + 1, all));
  EXPECT_EQ(lines.back(), "");
}

TEST(Progress, OfVerifyNamesClaimAndEngine) {
  const std::vector<std::string> words{"verify", "--claim", "FJ07.13", "--effort", "quick", "--threads", "1"};
  const TerminalResult run = run_on_terminal(words);
  EXPECT_EQ(run.exit, 0);
  const std::vector<std::string> lines = lines_of(run.screen);
  expect_counted(lines);
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    EXPECT_TRUE(std::regex_match(lines[i], std::regex("\\[\\d+/\\d+\\] FJ07\\.13 [a-z0-9-]+"))) << lines[i];
  }
  EXPECT_EQ(run.out.find('\033'), std::string::npos);
  EXPECT_EQ(run_program(words).err, "");
}

TEST(Progress, OfAStudyCountsItsCases) {
  const std::vector<std::string> words{"study", "bezier", "--effort", "quick", "--threads", "1"};
  const TerminalResult run = run_on_terminal(words);
  EXPECT_EQ(run.exit, 0);
  expect_counted(lines_of(run.screen));
  EXPECT_EQ(run_program(words).err, "");
}

/// Units of a property, of how many, and the cases in them.
TEST(Progress, OfACampaignCountsUnitsAndCases) {
  const Scratch scratch;
  const auto words = [&](const std::string& name) -> std::vector<std::string> {
    return {"campaign",   "run",         "--db",     (scratch / name).string(),
            "--seeds",    "1..3",        "--effort", "quick",
            "--property", "text.number", "--jobs",   "1"};
  };
  const TerminalResult run = run_on_terminal(words("a.db"));
  EXPECT_EQ(run.exit, 0);
  const std::vector<std::string> lines = lines_of(run.screen);
  ASSERT_GE(lines.size(), 2U);
  EXPECT_EQ(lines.back(), "");
  const std::string last = lines[lines.size() - 2];
  std::smatch found;
  ASSERT_TRUE(std::regex_match(last, found, std::regex("\\[3/3\\] (\\d+) cases, 0 failed"))) << last;
  EXPECT_THAT(run.out, HasSubstr(found[1].str() + " cases: 0 failed"));
  EXPECT_EQ(run_program(words("b.db")).err, "");
}

/// Seeds without an end have no number that is left.
TEST(Progress, OfAnEndlessCampaignHasNoEnd) {
  const Scratch scratch;
  const TerminalResult run =
      run_on_terminal({"campaign", "run", "--db", (scratch / "a.db").string(), "--seeds", "1..", "--minutes", "0.005",
                       "--effort", "quick", "--property", "text.number", "--jobs", "1"});
  EXPECT_EQ(run.exit, 0);
  const std::vector<std::string> lines = lines_of(run.screen);
  ASSERT_GE(lines.size(), 2U);
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    EXPECT_TRUE(std::regex_match(lines[i], std::regex("\\[\\d+\\] \\d+ cases, 0 failed"))) << lines[i];
  }
}

}  // namespace
}  // namespace torse::testing
