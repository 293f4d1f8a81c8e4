// Documents: values keep their text, and every error names its place.
#include "torse/io/document.hpp"

#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "torse/exact/rational/rational.hpp"
#include "torse/io/parse.hpp"

namespace torse {
namespace {

/// The message of the error that reading this text gives.
std::string error_of(const std::string& text) {
  try {
    const Document document("f", text);
  } catch (const FileError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Document, NumbersKeepTheirExactText) {
  const Document document("f", R"({"a": [1e-30, 12345678901234567890123, -0, 0.10, "2/3"]})");
  const std::vector<Value> items = document.root().at("a").items();
  EXPECT_EQ(items[0].number<Rational>(), Rational::from_text("1/1000000000000000000000000000000"));
  EXPECT_EQ(items[1].number<Rational>(), Rational::from_text("12345678901234567890123"));
  EXPECT_EQ(items[2].number<Rational>(), Rational(0));
  EXPECT_EQ(items[3].number<Rational>(), Rational::from_text("1/10"));
  EXPECT_EQ(items[4].number<Rational>(), Rational::from_text("2/3"));
}

TEST(Document, PlacesAreCountedInLinesAndColumns) {
  const Document document("f", "{\"a\": [\n  1, [2,\n 3, {\"b\": \"x\\u00e9\" , \"c\":4}]]}");
  const std::vector<Value> inner = document.root().at("a").items()[1].items();
  try {
    inner[2].at("c").fail("wrong");
  } catch (const FileError& error) {
    EXPECT_STREQ(error.what(), "f: a[1][2].c (line 3, column 27): wrong");
    EXPECT_EQ(error.place(), "a[1][2].c");
    EXPECT_EQ(error.line(), 3U);
    EXPECT_EQ(error.column(), 27U);
  }
  EXPECT_STREQ(document.error("a[1][1]", "wrong").what(), "f: a[1][1] (line 3, column 2): wrong");
  EXPECT_STREQ(document.error("a[7]", "wrong").what(), "f: a (line 1, column 7): a[7]: wrong");
  EXPECT_STREQ(document.error("zz", "wrong").what(), "f: zz: wrong");
  EXPECT_STREQ(document.error(InvalidInput("a[0]", "wrong")).what(), "f: a[0] (line 2, column 3): wrong");
}

/// Characters of two and of four bytes, and a byte order mark of three, which is none of the text.
TEST(Document, PlacesAreCountedInCharactersToo) {
  const std::string line = "{\"\xC3\xA9\xF0\x9F\x98\x80\": null}";
  for (const auto& [before, row, column] :
       {std::tuple{"", 1U, 12U}, {"\xEF\xBB\xBF", 1U, 15U}, {"\n", 2U, 12U}, {"\xEF\xBB\xBF\n", 2U, 12U}}) {
    const Document document("f", before + line);
    const FileError error = document.error("\xC3\xA9\xF0\x9F\x98\x80", "wrong");
    EXPECT_EQ(error.line(), row);
    EXPECT_EQ(error.column(), column);
    EXPECT_EQ(error.character(), 8U);
  }
  EXPECT_EQ(FileError("f", "wrong").character(), 0U);
}

TEST(Document, SyntaxErrorsNameLineAndColumn) {
  EXPECT_EQ(error_of(""), "f: expected JSON, found an empty file");
  EXPECT_EQ(error_of("[1,\n  tru]"), "f: line 2, column 6: expected JSON, found invalid literal near \"tru]\"");
  EXPECT_EQ(error_of("{\"a\": 1,}"), "f: line 1, column 9: expected string literal, found '}' near \"}\"");
  EXPECT_EQ(error_of("[1] x"), "f: line 1, column 5: expected end of input, found invalid literal near \"x\"");
  EXPECT_EQ(error_of("[1"), "f: line 1, column 3: expected ']', found end of input");
  EXPECT_EQ(error_of("[NaN]"), "f: line 1, column 2: expected JSON, found invalid literal near \"NaN]\"");
  EXPECT_EQ(error_of("{\"a\": 1, \"a\": 2}"), "f: line 1, column 10: expected each key once, found \"a\" again");
  EXPECT_EQ(error_of("\"\xff\""),
            "f: line 1, column 2: expected JSON, found invalid string: ill-formed UTF-8 byte near \"\\xff\"\"");
}

/// Long texts are shortened after 40 bytes.
TEST(Document, ErrorsShowWhatWasFound) {
  const auto wrong = [](const std::string& text) {
    try {
      Document("f", text).root().expected("a surface");
    } catch (const FileError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_EQ(wrong("[1]"), "f: expected a surface, found an array of 1");
  EXPECT_EQ(wrong(std::string(40, '7')), "f: expected a surface, found " + std::string(40, '7'));
  EXPECT_EQ(wrong(std::string(41, '7')), "f: expected a surface, found " + std::string(40, '7') + "...");
}

TEST(Document, ANumberAloneHasAPlace) {
  EXPECT_EQ(error_of("2e1000000000"),
            "f: line 1, column 1: expected a number below 1e4932 (a string may hold a larger one), found "
            "\"2e1000000000\"");
}

TEST(Document, ANullByteDoesNotEndTheText) {
  EXPECT_EQ(error_of(std::string("{}\n\0 x", 6)), "f: line 2, column 1: expected JSON, found a null byte");
  EXPECT_EQ(error_of(std::string("[12\0]", 6)), "f: line 1, column 4: expected JSON, found a null byte");
}

TEST(Document, LimitsStopBeforeMemoryDoes) {
  EXPECT_NE(error_of(std::string(50'000'000, '[')).find("at most 32 deep"), std::string::npos);
  std::string objects;
  for (int i = 0; i < 40; ++i) objects += "{\"a\":";
  EXPECT_NE(error_of(objects).find("at most 32 deep"), std::string::npos);
  EXPECT_EQ(error_of(std::string(32, '[') + std::string(32, ']')), "no error");
  EXPECT_NE(error_of(std::string(33, '[') + std::string(33, ']')).find("at most 32 deep"), std::string::npos);

  std::string values = "[0";
  for (int i = 0; i < 2'200'000; ++i) values += ",0";
  EXPECT_NE(error_of(values + "]").find("at most 2097152 values"), std::string::npos);
  // The list is a value too.
  values.resize(2 * 2'097'151);
  EXPECT_EQ(error_of(values + "]"), "no error");
  EXPECT_NE(error_of(values + ",0]").find("at most 2097152 values"), std::string::npos);

  std::string keys = "{\"k\":0";
  for (int i = 0; i < 64; ++i) keys += ",\"k" + std::to_string(i) + "\":0";
  EXPECT_NE(error_of(keys + "}").find("at most 64 keys"), std::string::npos);

  EXPECT_EQ(
      error_of("[1, 1e1000000000]"),
      "f: line 1, column 5: expected a number below 1e4932 (a string may hold a larger one), found \"1e1000000000\"");
}

TEST(Document, BlanksInARowAreLimited) {
  const std::string most(limits::blanks, '\n');
  EXPECT_EQ(error_of("[" + most + "x]").substr(0, 40), "f: line 1048577, column 1: expected JSON");
  EXPECT_EQ(error_of(most + "x").substr(0, 40), "f: line 1048577, column 1: expected JSON");
  EXPECT_EQ(error_of("[" + most + " x]"),
            "f: line 1048577, column 1: expected at most 1048576 blanks in a row, found more");
}

TEST(Document, ExponentsAreLimitedTogether) {
  EXPECT_EQ(exponent_bits("1e-300"), 999U);
  EXPECT_EQ(exponent_bits("-1.5E+3"), 9U);
  EXPECT_EQ(exponent_bits("0x1.8p-52"), 52U);
  EXPECT_EQ(exponent_bits("0x1P100"), 100U);
  EXPECT_EQ(exponent_bits("1e99999999999999999999"), 66600U);
  for (const char* none : {"", "12", "-12", "+", "e", "2/3", "name", "line-7", "1e", "0x1.ff", "0x3e99999", "-0X1E5"}) {
    EXPECT_EQ(exponent_bits(none), 0U) << none;
  }
  // 10076 numbers of 13320 bits are just below 2^27.
  std::string text = "[";
  for (int i = 0; i < 5038; ++i) text += "1e-4000, \"1e4000\",";
  EXPECT_EQ(error_of(text + "1]"), "no error");
  EXPECT_EQ(
      error_of(text + "1e4000]"),
      "f: line 1, column 90686: expected numbers whose exponents make at most 134217728 bits together, found more");
}

TEST(Document, TheSquaresOfLengthsAreLimitedTogether) {
  EXPECT_EQ(error_of("[\"" + std::string(524'288, '1') + "\"]"), "no error");  // squared 2^38
  EXPECT_EQ(error_of("[0, \"" + std::string(524'289, '1') + "\"]"),
            "f: [1] (line 1, column 5): expected numbers whose lengths have squares that add up to at most 2^38, found "
            "more up to here");
  const std::string part = "\"" + std::string(370'000, '7') + "\"";
  EXPECT_EQ(error_of("[" + part + ", " + part + "]"), "no error");
  EXPECT_NE(error_of("[" + part + ", {\"a\": " + part + "}, " + part + "]").find("[2]"), std::string::npos);
}

TEST(Document, TypedAccessSaysWhatItFound) {
  const Document document("f", R"({"n": 1.5, "s": "text", "l": [1, 2], "o": {}, "z": null})");
  const Value root = document.root();
  const auto reason = [](const auto& action) {
    try {
      action();
    } catch (const FileError& error) {
      return error.place() + ": " + error.reason();
    }
    return std::string("no error");
  };
  EXPECT_EQ(reason([&] { root.at("n").integer(1, 9); }), "n: expected an integer from 1 to 9, found 1.5");
  EXPECT_EQ(reason([&] { root.at("s").items(); }), "s: expected an array, found \"text\"");
  EXPECT_EQ(reason([&] { root.at("l").string(); }), "l: expected a string, found an array of 2");
  EXPECT_EQ(reason([&] { root.at("o").number<Rational>(); }), "o: expected a number, found an object");
  EXPECT_EQ(reason([&] { root.at("z").at("x"); }), "z: expected an object, found null");
  EXPECT_EQ(reason([&] { root.at("q"); }), ": expected the key \"q\", found none");
  EXPECT_EQ(reason([&] {
              root.expect_keys({"n", "s", "l", "o"});
            }),
            "z: expected one of the keys n, s, l, o, found \"z\"");
  EXPECT_EQ(reason([&] { root.expect_keys({"n", "s", "l", "o", "z"}); }), "no error");
}

}  // namespace
}  // namespace torse
