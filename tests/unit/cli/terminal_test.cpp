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
