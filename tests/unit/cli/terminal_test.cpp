// Words for a shell, colours, the version.
#include "torse/cli/terminal.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <map>
#include <optional>

#include "support/program.hpp"
#include "torse/cli/version.hpp"

namespace torse::cli {
namespace {

TEST(Terminal, CommandLinesSurviveAShell) {
  EXPECT_EQ(command_line({"torse", "check", "a-b/c_1.json"}), "torse check a-b/c_1.json");
  EXPECT_EQ(command_line({"a b", "", "it's", "$x;*"}), "'a b' '' 'it'\\''s' '$x;*'");
}

TEST(Terminal, FilesThatBeginWithADashAreNoOptions) {
  EXPECT_EQ(file_word("-net.json"), "./-net.json");
  EXPECT_EQ(file_word("--"), "./--");
  EXPECT_EQ(file_word("-"), "-") << "standard input";
  EXPECT_EQ(file_word("a/-net.json"), "a/-net.json");
}

TEST(Terminal, NoColoursInAFile) {
  std::FILE* file = std::tmpfile();
  EXPECT_EQ(Terminal(file).painted(Paint::bad, "word"), "word");
  std::fclose(file);
}

/// The other end of a pseudoterminal, which is a terminal to whoever writes there.
class Terminals : public ::testing::Test {
 protected:
  void SetUp() override {
    master_ = posix_openpt(O_RDWR | O_NOCTTY);
    ASSERT_EQ(grantpt(master_), 0);
    ASSERT_EQ(unlockpt(master_), 0);
    file_ = std::fopen(ptsname(master_), "w");
    ASSERT_NE(file_, nullptr);
  }
  void TearDown() override {
    std::fclose(file_);
    close(master_);
    for (const auto& [name, value] : old_) value ? setenv(name.c_str(), value->c_str(), 1) : unsetenv(name.c_str());
  }
  /// Null for a variable that is not there.
  bool coloured(const char* no_color, const char* term) {
    set("NO_COLOR", no_color);
    set("TERM", term);
    return Terminal(file_).painted(Paint::bad, "word") != "word";
  }

 private:
  void set(const char* name, const char* value) {
    const char* old = std::getenv(name);
    old_.try_emplace(name, old == nullptr ? std::nullopt : std::optional<std::string>(old));
    value == nullptr ? unsetenv(name) : setenv(name, value, 1);
  }

  int master_ = -1;
  std::FILE* file_ = nullptr;
  std::map<std::string, std::optional<std::string>> old_;
};

TEST_F(Terminals, HaveColoursUnlessTheVariablesForbidThem) {
  EXPECT_TRUE(coloured(nullptr, "xterm"));
  EXPECT_TRUE(coloured(nullptr, nullptr));
  EXPECT_TRUE(coloured("", "xterm"));
  EXPECT_FALSE(coloured("1", "xterm"));
  EXPECT_FALSE(coloured(nullptr, "dumb"));
}

TEST(Version, IsTheOneOfTheBuild) {
  const std::string build = testing::slurp(std::filesystem::path(TORSE_SOURCE_PATH) / "CMakeLists.txt");
  EXPECT_NE(build.find(std::string("VERSION ") + version + " "), std::string::npos);
}

}  // namespace
}  // namespace torse::cli
