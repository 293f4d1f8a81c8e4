// Short numbers, and witnesses and enclosures in words.
#include "torse/exact/decide/words.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "torse/exact/warp/words.hpp"

namespace torse {
namespace {

TEST(Words, ShortNumbersAreExactOrSayAbout) {
  EXPECT_EQ(short_number(Rational::from_text("-123456789/1000")), "-123456789/1000");
  EXPECT_EQ(short_number(Rational::from_text("1/1000000000000000000000000000000")), "about 1e-30");
  Rational huge(-3);
  for (int i = 0; i < 12; ++i) huge *= Rational(huge);
  EXPECT_EQ(short_number(huge).substr(0, 8), "about 2^");
  EXPECT_EQ(short_number(-huge).substr(0, 9), "about -2^");
}

TEST(Words, AWitnessNamesPieceIntervalAndValue) {
  const KnotList<Rational> u(1, {Rational(0), ratio<Rational>(1, 3), Rational(1)});
  EXPECT_EQ(describe({2, 3, ratio<Rational>(-1, 7)}, u),
            "piece 2, u from 1/3 to 1: coefficient 3 of the determinant is -1/7");
}

TEST(Words, DecimalBoundsAreTheNearestOnes) {
  EXPECT_EQ(decimal_above(1.21, 2), "1.3");
  EXPECT_EQ(decimal_below(1.29, 2), "1.2");
  EXPECT_EQ(decimal_above(0.0944, 2), "0.095");
  EXPECT_EQ(decimal_above(9.94, 2), "10");
  EXPECT_EQ(decimal_below(9.96, 2), "9.9");
  EXPECT_EQ(decimal_below(10.4, 2), "10");
  EXPECT_EQ(decimal_below(0.000999999, 3), "0.000999");
  EXPECT_EQ(decimal_above(0.00123401, 4), "0.001235");
  EXPECT_EQ(decimal_above(123456.7, 3), "1.24e+05");
  for (const auto& bound : {decimal_above, decimal_below}) {
    EXPECT_EQ(bound(2, 3), "2");
    EXPECT_EQ(bound(0.1, 3), "0.1");
    EXPECT_EQ(bound(0, 3), "0");
  }
}

/// In integers: x has the leading digits `all`, and a bound of three digits has the first three of them or one more.
TEST(Words, DecimalBoundsInEveryMagnitude) {
  for (int exponent = -290; exponent <= 290; exponent += 29) {
    for (int all = 100001; all < 1000000; all += 997) {
      const double x = std::strtod((std::to_string(all) + "e" + std::to_string(exponent)).c_str(), nullptr);
      const int first = all / 1000;
      const auto with = [&](int digits) {
        return std::strtod((std::to_string(digits) + "e" + std::to_string(exponent + 3)).c_str(), nullptr);
      };
      ASSERT_EQ(std::strtod(decimal_below(x, 3).c_str(), nullptr), with(first)) << x;
      ASSERT_EQ(std::strtod(decimal_above(x, 3).c_str(), nullptr), with(all % 1000 == 0 ? first : first + 1)) << x;
    }
  }
}

TEST(Words, BoundsAreRoundedAwayFromTheEnclosure) {
  WarpEnclosure warp;
  warp.piece = 1;
  warp.parameter = ratio<Rational>(1, 2);
  // Doubles in steps of an irrational ratio over all magnitudes.
  for (double x = 3.14159265e-300; x < 90; x *= 3.7182818) {
    warp.lower = warp.upper = x;
    double lower = 0;
    double upper = 0;
    ASSERT_EQ(std::sscanf(describe(warp).c_str(), "the largest warp angle is between %lf and %lf degrees, at u = 1/2",
                          &lower, &upper),
              2);
    EXPECT_LT(lower, x);
    EXPECT_GT(upper, x);
    EXPECT_LT(upper - lower, 3e-5 * x);
  }
}

TEST(Words, NoBoundExceedsARightAngleAndNoPlaceIsInvented) {
  WarpEnclosure warp;
  warp.lower = 89.9999;
  warp.upper = 90;
  EXPECT_EQ(describe(warp), "the largest warp angle is between 89.9999 and 90 degrees");
}

}  // namespace
}  // namespace torse
