// Words for a shell, short numbers, the version.
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

TEST(Terminal, ShortNumbersAreExactOrSayAbout) {
  EXPECT_EQ(short_number(Rational::from_text("-123456789/1000")), "-123456789/1000");
  EXPECT_EQ(short_number(Rational::from_text("1/1000000000000000000000000000000")), "about 1e-30");
  Rational huge(-3);
  for (int i = 0; i < 12; ++i) huge *= Rational(huge);
  EXPECT_EQ(short_number(huge).substr(0, 8), "about 2^");
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
