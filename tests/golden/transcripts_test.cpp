// What the program prints, word for word: the transcripts beside this file.
#include "support/transcript.hpp"

namespace torse::testing {
namespace {

class Words : public Transcript {};

TEST_P(Words, PrintWhatIsWritten) { expect_as_written(); }

INSTANTIATE_TEST_SUITE_P(Golden, Words, ::testing::ValuesIn(pages_below("tests/golden/transcripts")), Transcript::name);

TEST(Examples, AreReadFromPages) {
  const std::vector<Example> found = examples_of(
      {"text", "    $ one", "    a", "", "    b", "", "more", "    c", "    $ two", "    $ three", "    [1]", ""});
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].command, "one");
  EXPECT_EQ(found[0].line, 2U);
  EXPECT_EQ(found[0].printed, (std::vector<std::string>{"a", "", "b"}));
  EXPECT_TRUE(found[1].printed.empty());
  EXPECT_EQ(found[2].printed, (std::vector<std::string>{"[1]"}));
}

TEST(Examples, DotsStandForAnyText) {
  EXPECT_TRUE(fits("in ... s, ... files", "in 0.3 s, 12 files"));
  EXPECT_TRUE(fits("...", ""));
  EXPECT_FALSE(fits("in ... s", "in 3 ms, done"));
  EXPECT_FALSE(fits("at ... s", "in 3 s"));
  EXPECT_FALSE(fits("a...ba", "aba ab"));
  EXPECT_FALSE(fits("ab...b", "ab"));
  EXPECT_FALSE(fits("a", "ab"));
  const std::vector<std::string> text{"a", "b", "c"};
  EXPECT_TRUE(fits({"a", "...", "c"}, text));
  EXPECT_TRUE(fits({"...", "a", "b", "c", "..."}, text));
  EXPECT_FALSE(fits({"a", "...", "b"}, text));
  EXPECT_FALSE(fits({"a", "b"}, text));
  EXPECT_FALSE(fits({"a", "b", "c", "d"}, text));
}

}  // namespace
}  // namespace torse::testing
