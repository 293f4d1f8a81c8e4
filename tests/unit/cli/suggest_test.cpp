// Edit distances by hand, and when a suggestion is made.
#include "torse/cli/suggest.hpp"

#include <gtest/gtest.h>

namespace torse::cli {
namespace {

TEST(Suggest, EditDistance) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("abc", ""), 3U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(edit_distance("chekc", "check"), 1U);
  EXPECT_EQ(edit_distance("abcd", "badc"), 2U);
}

TEST(Suggest, OnlyNearWords) {
  const std::vector<std::string> words{"check", "construct", "verify"};
  EXPECT_EQ(suggestion("chekc", words), "; did you mean check?");
  EXPECT_EQ(suggestion("constuct", words), "; did you mean construct?");
  EXPECT_EQ(suggestion("fit", words), "");
  EXPECT_EQ(suggestion(std::string(1'000'000, 'x'), words), "");
  EXPECT_EQ(suggestion("x", {}), "");
}

}  // namespace
}  // namespace torse::cli
