// Short numbers, and witnesses and enclosures in words.
#include "torse/exact/decide/words.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "torse/exact/warp/words.hpp"

namespace torse {
namespace {

TEST(Words, ShortNumbersAreExactOrSayAbout) {
  EXPECT_EQ(short_number(Rational::from_text("-123456789/1000")), "-123456789/1000");
  EXPECT_EQ(short_number(Rational::from_text("1/1000000000000000000000000000000")), "about 1e-30");
  Rational huge(-3);
  for (int i = 0; i < 12; ++i) huge *= Rational(huge);
  EXPECT_EQ(short_number(huge).substr(0, 8), "about 2^");
}

TEST(Words, AWitnessNamesPieceIntervalAndValue) {
  const KnotList<Rational> u(1, {Rational(0), ratio<Rational>(1, 3), Rational(1)});
  EXPECT_EQ(describe({2, 3, ratio<Rational>(-1, 7)}, u),
            "piece 2, u from 1/3 to 1: coefficient 3 of the determinant is -1/7");
}

TEST(Words, BoundsAreRoundedAwayFromTheEnclosure) {
  WarpEnclosure warp;
  warp.piece = 1;
  warp.parameter = ratio<Rational>(1, 2);
  // Doubles in steps of an irrational ratio over all magnitudes.
  for (double x = 1e-300; x < 90; x *= 3.7182818) {
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
  EXPECT_EQ(describe(warp), "the largest warp angle is between 89.9994 and 90 degrees");
}

}  // namespace
}  // namespace torse
