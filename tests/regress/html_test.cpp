// The option --html: where the page goes, and what happens where it cannot go there.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "support/program.hpp"
#include "torse/cli/viewer.hpp"

namespace torse::testing {
namespace {

class Html : public ::testing::Test {
 protected:
  void SetUp() override {
    if (cli::viewer().empty()) GTEST_SKIP() << "built without the viewer";
  }
  Scratch scratch_;
};

TEST_F(Html, GoesIntoAFile) {
  const std::string file = scratch_ / "page.html";
  const ProgramResult result = run_program({"example", "--html", file});
  EXPECT_EQ(result.exit, 0) << result.err;
  EXPECT_TRUE(slurp(file).starts_with("<!doctype html>"));
}

TEST_F(Html, GoesIntoAFolderThatIsMade) {
  const std::filesystem::path folder = scratch_ / "a/b";
  EXPECT_EQ(run_program({"example", "--html", folder}).exit, 0);
  EXPECT_TRUE(std::filesystem::exists(folder / "index.html"));
  EXPECT_EQ(run_program({"example", "--html", folder}).exit, 0) << "once more into the same folder";
}

TEST_F(Html, IsTheSameTwice) {
  const std::string file = scratch_ / "page.html";
  run_program({"example", "--html", file});
  const std::string first = slurp(file);
  run_program({"example", "--html", file});
  EXPECT_EQ(slurp(file), first);
}

TEST_F(Html, AFileInTheWayIsOneError) {
  spill(scratch_ / "taken", "mine");
  for (const char* place : {"taken", "taken/page.html", "none/page.html"}) {
    const ProgramResult result = run_program({"example", "--html", scratch_ / place});
    EXPECT_EQ(result.exit, 2) << place;
    EXPECT_NE(result.err.find(place), std::string::npos) << result.err;
  }
  EXPECT_EQ(slurp(scratch_ / "taken"), "mine");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(scratch_.path()), {}), 1);
}

/// A program without the viewer says so before it writes anything; with it, everything is written.
TEST(HtmlOption, ThePageAndTheOtherFilesAreWrittenOrNone) {
  const Scratch scratch;
  const std::string rails = (scratch / "rails.json").string();
  const std::string net = (scratch / "net.json").string();
  spill(rails, R"({"torse": 1, "type": "rails", "c": {"degree": 1, "points": [[0,0,0],[1,0,0]]},
    "d": {"degree": 1, "points": [[0,0,1],[1,0,1]]}})");
  spill(net, R"({"torse": 1, "type": "ruled", "degree": 1, "c": {"points": [[0,0,0],[1,0,0]]},
    "d": {"points": [[0,0,1],[1,0,1]]}})");
  const std::vector<std::vector<std::string>> commands{{"fit", rails, "-o"},
                                                       {"check", net, "--repair"},
                                                       {"check", net, "--json"},
                                                       {"study", "gap", "--effort", "quick", "--json"},
                                                       {"figures", "FJ07.Fig1", "-o"},
                                                       {"example", "--json"},
                                                       {"verify", "--claim", "FJ07.5", "--effort", "quick", "--json"}};
  for (const std::vector<std::string>& command : commands) {
    const Scratch place;
    std::vector<std::string> words = command;
    words.insert(words.end(), {place / "out", "--html", place / "page.html"});
    if (command.front() == "fit") words[words.size() - 3] += ".json";
    const ProgramResult result = run_program(words);
    const std::ptrdiff_t files = std::distance(std::filesystem::directory_iterator(place.path()), {});
    EXPECT_EQ(result.exit, cli::viewer().empty() ? 2 : 0) << command.front() << result.err;
    EXPECT_EQ(files, cli::viewer().empty() ? 0 : 2) << command.front();
  }
}

}  // namespace
}  // namespace torse::testing
