// What torse fit says besides its numbers: the command that shows an error again, and how long it took.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>

#include "support/program.hpp"

namespace torse::testing {
namespace {

using ::testing::HasSubstr;

TEST(FitText, AnErrorCanBeSeenAgainWithEveryOption) {
  const std::string options =
      "nowhere.json --method same --measure rms --ends extended --degree 3 --coefficients 7 --extend 1/5 --within 1/5 "
      "--simplest degree --c 1 --d 2 --even-knots --regular --reverse --max-warp 3 -o x.json --unroll p.svg";
  std::vector<std::string> words{"fit"};
  std::istringstream list(options);
  for (std::string word; list >> word;) words.push_back(word);
  const ProgramResult run = run_program(words);
  EXPECT_EQ(run.exit, 2);
  EXPECT_THAT(run.err, HasSubstr("\n  replay: torse fit " + options + "\n"));
}

TEST(FitText, TheTimeOfTheFitIsPartOfTheProgramsTime) {
  const Scratch scratch;
  const std::string rails = TORSE_SOURCE_PATH "/examples/cubics.json";
  const auto start = std::chrono::steady_clock::now();
  const ProgramResult run = run_program({"fit", rails, "-o", (scratch / "a.json").string(), "--coefficients", "5"});
  const std::chrono::duration<double, std::milli> whole = std::chrono::steady_clock::now() - start;
  ASSERT_EQ(run.exit, 0) << run.err;
  const std::size_t at = run.out.find("  fitted in ");
  ASSERT_NE(at, std::string::npos) << run.out;
  const double fitted = std::strtod(run.out.c_str() + at + 12, nullptr);
  EXPECT_GT(fitted, 0);
  EXPECT_LT(fitted, whole.count());
  EXPECT_THAT(run.out.substr(at), ::testing::EndsWith(" ms\n"));
}

}  // namespace
}  // namespace torse::testing
