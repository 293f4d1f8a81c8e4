// Numbers as text: exact values against Rational's own reader, and every kind of text that is refused.
#include "torse/io/number.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "torse/exact/modular/zp.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/io/limits.hpp"

namespace torse {
namespace {

std::string read(const std::string& text) { return parse_number<Rational>(text).text(); }

TEST(Number, DecimalsAreExact) {
  EXPECT_EQ(read("0"), "0");
  EXPECT_EQ(read("-0.0"), "0");
  EXPECT_EQ(read("12"), "12");
  EXPECT_EQ(read("+12"), "12");
  EXPECT_EQ(read("-1.5e-3"), "-3/2000");
  EXPECT_EQ(read("0.1"), "1/10");
  EXPECT_EQ(read("2.5E+3"), "2500");
  EXPECT_EQ(read("1e-30"), "1/1000000000000000000000000000000");
  EXPECT_EQ(read("007"), "7");
}

TEST(Number, FractionsAreReduced) {
  EXPECT_EQ(read("6/4"), "3/2");
  EXPECT_EQ(read("-6/4"), "-3/2");
  EXPECT_EQ(read("0/5"), "0");
}

TEST(Number, HexadecimalFloatsAreTheDoublesTheyPrint) {
  EXPECT_EQ(read("0x1.8p-3"), "3/16");
  EXPECT_EQ(read("-0X1.8P+1"), "-3");
  EXPECT_EQ(read("0xff"), "255");
  EXPECT_EQ(read("0xF.8"), "31/2");
  EXPECT_EQ(read("0x8000000000000000"), "9223372036854775808");
  EXPECT_EQ(read("0xfedcba9876543210"), "18364758544493064720");
  for (const double x : {0.1, -1.0 / 3, 5e-324, 1.7976931348623157e308}) {
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, "%a", x);
    EXPECT_EQ(parse_number<Rational>(buffer), Rational::from_double(x)) << buffer;
  }
}

TEST(Number, LongDigitsAgreeWithTheRationalsReader) {
  std::string digits;
  for (int i = 0; i < 5000; ++i) digits += static_cast<char>('0' + (i * i + 7 * i + 1) % 10);
  for (const std::size_t length : {1U, 14U, 15U, 16U, 17U, 30U, 31U, 63U, 1000U, 5000U}) {
    const std::string text = digits.substr(0, length) + "/1" + digits.substr(0, length / 2);
    EXPECT_EQ(parse_number<Rational>(text), Rational::from_text(text)) << length;
  }
}

TEST(Number, AnyExactField) {
  EXPECT_TRUE(definitely(equal(parse_number<Zp>("7/2") * from_int<Zp>(2), from_int<Zp>(7))));
  EXPECT_TRUE(definitely(equal(parse_number<Zp>("-0.25") * from_int<Zp>(-4), from_int<Zp>(1))));
}

TEST(Number, OtherTextsAreRefused) {
  for (const char* text :
       {"",    " 1",    "1 ",   "-",    "+",     "--1",   "1.",       ".5",  "1e",    "1e+",  "e5",
        "1/",  "/2",    "1/-2", "1/+2", "1/2/3", "1.5/2", "1/2.5",    "0x",  "0x.8",  "0x1.", "0x1p",
        "0xg", "1/0x2", "abc",  "NaN",  "nan",   "inf",   "Infinity", "1,5", "1_000", "1\n",  "\xd9\xa1"}) {
    EXPECT_THROW(parse_number<Rational>(text), BadNumber) << '"' << text << '"';
  }
  EXPECT_THROW(parse_number<Rational>(std::string("1\0", 2)), BadNumber);
}

TEST(Number, ZeroDenominatorsAreNamed) {
  for (const char* text : {"1/0", "0/0", "-3/000"}) {
    try {
      parse_number<Rational>(text);
      FAIL() << text;
    } catch (const BadNumber& bad) {
      EXPECT_THAT(bad.what(), ::testing::HasSubstr("denominator that is not zero"));
    }
  }
}

TEST(Number, LimitsHoldOnBothSides) {
  EXPECT_EQ(parse_number<Rational>("1e4000") * parse_number<Rational>("1e-4000"), Rational(1));
  EXPECT_EQ(parse_number<Rational>("0x1p20000") * parse_number<Rational>("0x1p-20000"), Rational(1));
  for (const char* text : {"1e4001", "1e-4001", "1e1000000000", "1e-99999999999999999999", "0x1p20001", "0x1p-20001"}) {
    EXPECT_THROW(parse_number<Rational>(text), BadNumber) << text;
  }
  EXPECT_NO_THROW(split_number(std::string(limits::number_characters, '1')));
  EXPECT_THROW(split_number(std::string(limits::number_characters + 1, '1')), BadNumber);
}

}  // namespace
}  // namespace torse
