// Words for a shell, colours, the version.
#include "torse/cli/terminal.hpp"

#include <gtest/gtest.h>

#include "support/program.hpp"
#include "torse/cli/version.hpp"

namespace torse::cli {
namespace {

TEST(Terminal, CommandLinesSurviveAShell) {
  EXPECT_EQ(command_line({"torse", "check", "a-b/c_1.json"}), "torse check a-b/c_1.json");
  EXPECT_EQ(command_line({"a b", "", "it's", "$x;*"}), "'a b' '' 'it'\\''s' '$x;*'");
}

/// Never below the bound, and at most a unit of the last digit above it.
TEST(Terminal, BoundsAreRoundedUp) {
  EXPECT_EQ(rounded_up(1.26, 2), "1.3");
  EXPECT_EQ(rounded_up(1.21, 2), "1.3");
  EXPECT_EQ(rounded_up(9.94, 2), "10");
  EXPECT_EQ(rounded_up(0.00123401, 4), "0.001235");
  EXPECT_EQ(rounded_up(2, 3), "2");
  EXPECT_EQ(rounded_up(0, 3), "0");
}

TEST(Terminal, NoColoursInAFile) {
  std::FILE* file = std::tmpfile();
  EXPECT_EQ(Terminal(file).painted(Paint::bad, "word"), "word");
  std::fclose(file);
}

TEST(Version, IsTheOneOfTheBuild) {
  const std::string build = testing::slurp(std::filesystem::path(TORSE_SOURCE_PATH) / "CMakeLists.txt");
  EXPECT_NE(build.find(std::string("VERSION ") + version + " "), std::string::npos);
}

}  // namespace
}  // namespace torse::cli
