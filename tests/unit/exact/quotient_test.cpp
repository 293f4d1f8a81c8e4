// Quotients of long fractions, rounded outwards, against exact comparison.
#include "torse/exact/warp/quotient.hpp"

#include <gtest/gtest.h>

#include <random>

namespace torse {
namespace {

using Q = Rational;

/// A fraction of two random numbers of about `bits` bits, times 2^exponent.
Q random_fraction(int bits, int exponent, std::mt19937_64& rng) {
  Q numerator(1), denominator(1);
  const Q base = Q(1L << 30);
  for (int i = 0; i < bits; i += 30) {
    numerator = numerator * base + Q(static_cast<long>(rng() % (1UL << 30)));
    denominator = denominator * base + Q(static_cast<long>(rng() % (1UL << 30)));
  }
  Q x = numerator / denominator;
  for (int i = 0; i < std::abs(exponent); ++i) x = exponent < 0 ? x / Q(2) : x * Q(2);
  return x;
}

TEST(QuotientEnclosure, HoldsTheQuotientOfLongFractions) {
  std::mt19937_64 rng(1);
  for (const int bits : {60, 3000}) {
    for (int exponent = -60; exponent <= 60; exponent += 3) {
      const Q x = Q(exponent % 2 == 0 ? 1 : -1) * random_fraction(bits, exponent, rng);
      const Q y = random_fraction(bits, -exponent / 2, rng);
      const Interval found = quotient_enclosure(x, y);
      EXPECT_LE(Q::from_double(found.lower()), x / y);
      EXPECT_GE(Q::from_double(found.upper()), x / y);
      EXPECT_LE(found.upper() - found.lower(), 0x1p-47 * std::abs(found.upper()));
    }
  }
}

TEST(QuotientEnclosure, BeyondTheRangeOfDoubles) {
  std::mt19937_64 rng(2);
  const Q x = random_fraction(3000, 0, rng);
  const Q huge = random_fraction(3000, 3000, rng);
  const Interval most = quotient_enclosure(huge, x), least = quotient_enclosure(x, huge);
  EXPECT_EQ(most.upper(), detail::infinity);
  EXPECT_EQ(most.lower(), std::numeric_limits<double>::max());
  EXPECT_LE(least.lower(), 0);
  EXPECT_EQ(least.upper(), std::numeric_limits<double>::denorm_min());
  const Interval negative = quotient_enclosure(-huge, x);
  EXPECT_EQ(negative.lower(), -detail::infinity);
  EXPECT_EQ(negative.upper(), std::numeric_limits<double>::lowest());
  EXPECT_TRUE(quotient_enclosure(Q(0), huge).contains(0));
}

TEST(QuotientEnclosure, IsExactForShortNumbers) {
  const Interval half = quotient_enclosure(Q(3) / Q(7), Q(6) / Q(7));
  EXPECT_EQ(half.lower(), 0.5);
  EXPECT_EQ(half.upper(), 0.5);
}

}  // namespace
}  // namespace torse
