// What of a text may stand in a message: characters of every length, and bytes as \xNN that are none or that move a
// cursor.
#include "torse/io/text.hpp"

#include <gtest/gtest.h>

#include <string>

namespace torse {
namespace {

TEST(Printable, KeepsCharactersOfEveryLength) {
  for (const std::string text : {"az ~", "\xC2\xA0", "\xC2\xB0", "\xDF\xBF", "\xE0\xA0\x80", "\xED\x9F\xBF",
                                 "\xEF\xBF\xBD", "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF"}) {
    EXPECT_EQ(printable(text), text);
  }
}

TEST(Printable, ShowsControlCharactersByTheirBytes) {
  EXPECT_EQ(printable("a\tb\x1B[2J\x7F"), "a\\x09b\\x1b[2J\\x7f");
  EXPECT_EQ(printable("\xC2\x80\xC2\x9B"
                      "2J"),
            "\\xc2\\x80\\xc2\\x9b2J");
}

/// XML has none of them.
TEST(Printable, ShowsTheTwoThatAreNoCharacters) {
  EXPECT_EQ(printable("a\xEF\xBF\xBE"
                      "b"),
            "a\\xef\\xbf\\xbeb");
  EXPECT_EQ(printable("\xEF\xBF\xBF"), "\\xef\\xbf\\xbf");
}

TEST(Printable, ShowsBytesThatAreNoText) {
  EXPECT_EQ(printable("\xC2"), "\\xc2");
  EXPECT_EQ(printable("\xC1\xBF"), "\\xc1\\xbf") << "an ASCII letter in two bytes";
  EXPECT_EQ(printable("\xE0\x9F\xBF"), "\\xe0\\x9f\\xbf") << "two bytes would do";
  EXPECT_EQ(printable("\xF0\x8F\xBF\xBF"), "\\xf0\\x8f\\xbf\\xbf") << "three bytes would do";
  EXPECT_EQ(printable("\xED\xA0\x80"), "\\xed\\xa0\\x80") << "half of a pair of UTF-16";
  EXPECT_EQ(printable("\xF4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80") << "beyond the last character";
  EXPECT_EQ(printable("\xE2\x82x"), "\\xe2\\x82x");
}

/// Forty bytes, or fewer where a character would be cut.
TEST(InQuotes, LongTextsEndBehindACharacter) {
  const std::string forty(40, 'a');
  EXPECT_EQ(in_quotes(forty), '"' + forty + '"');
  EXPECT_EQ(in_quotes(forty + "b"), '"' + forty + "...\"");
  EXPECT_EQ(in_quotes(forty + "\xC2\xB0"), '"' + forty + "...\"");
  EXPECT_EQ(in_quotes(forty.substr(1) + "\xC2\xB0" + "b"), '"' + forty.substr(1) + "...\"");
  EXPECT_EQ(in_quotes(forty.substr(2) + "\xE2\x82\xAC" + "b"), '"' + forty.substr(2) + "...\"");
  EXPECT_EQ(in_quotes(forty.substr(3) + "\xE2\x82\xAC" + "b"), '"' + forty.substr(3) + "\xE2\x82\xAC...\"");
}

}  // namespace
}  // namespace torse
