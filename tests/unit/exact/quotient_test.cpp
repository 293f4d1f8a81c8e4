// Quotients of long fractions and of balls, rounded outwards, against exact comparison; quotients in doubles, whose
// errors add up.
#include "torse/exact/warp/quotient.hpp"

#include <gtest/gtest.h>

#include <random>
#include <utility>

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
  EXPECT_EQ(quotient_enclosure(Q(0), huge).lower(), 0);
  EXPECT_EQ(quotient_enclosure(Q(0), huge).upper(), 0);
}

TEST(QuotientEnclosure, IsExactForShortNumbers) {
  const Interval half = quotient_enclosure(Q(3) / Q(7), Q(6) / Q(7));
  EXPECT_EQ(half.lower(), 0.5);
  EXPECT_EQ(half.upper(), 0.5);
}

TEST(QuotientEnclosure, HoldsTheWholeBall) {
  using B = Ball<64>;
  for (const auto& [low, high] : {std::pair{1.0, 1.5}, {-3.0, 1.0}, {-0x1p-40, 0x1p-60}}) {
    const Interval found = enclosure(B::interval(low, high));
    EXPECT_LE(found.lower(), low);
    EXPECT_GE(found.upper(), high);
    EXPECT_LE(found.upper() - found.lower(), (high - low) * (1 + 0x1p-20));
  }
  EXPECT_GE(quotient_enclosure(B::interval(1, 2), B::interval(4, 5)).upper(), 0.5);
  EXPECT_LE(quotient_enclosure(B::interval(1, 2), B::interval(4, 5)).lower(), 0.2);
}

/// N = 1 over D = 1 but for one coefficient in the middle: without the radius that is positive or not, with it never.
TEST(BernsteinQuotient, HopesWhereTheMiddleOfADenominatorIsPositive) {
  using B = Ball<64>;
  const auto bound = [](double low, double high) {
    const Bernstein<B> denominator(std::vector<B>{B(1), B::interval(low, high), B(1)});
    return BernsteinQuotient<B>(Bernstein<B>(std::vector<B>{B(1), B(1), B(1)}), denominator).upper();
  };
  for (const double low : {-1.0, 0.0, -1.5}) EXPECT_EQ(bound(low, 1).value, detail::infinity);
  EXPECT_EQ(bound(0, 1).nominal, 1);
  EXPECT_EQ(bound(-0.5, 1).nominal, 1);
  EXPECT_EQ(bound(-1, 1).nominal, detail::infinity);
  EXPECT_EQ(bound(-1.5, 1).nominal, detail::infinity);
  EXPECT_GE(bound(0.5, 1).value, 2);
}

/// The constant `value`, known up to `radius`, as a form.
RoundedForms<1> constant(int degree, double value, double radius) {
  RoundedForms<1> x(degree);
  for (int i = 0; i <= degree; ++i) x.at(0, i) = value * binomial<Q>(degree, i).to_double();
  x.close(radius);
  return x;
}

TEST(RoundedQuotient, IsBetweenTheQuotientsOfItsErrors) {
  for (const auto& [r, s] : {std::pair{0.25, 0.0}, {0.0, 0.25}, {0.25, 0.5}}) {
    const RoundedQuotient x(constant(4, 1, r), constant(4, 2, s));
    EXPECT_GE(x.upper().value, (1 + r) / (2 - s));
    EXPECT_LE(x.lower_at_begin(), (1 - r) / (2 + s));
    EXPECT_LE(x.lower_at_end(), (1 - r) / (2 + s));
    EXPECT_LE(x.upper().value, (1 + r) / (2 - s) * (1 + 0x1p-40));
    EXPECT_GE(x.lower_at_end(), (1 - r) / (2 + s) * (1 - 0x1p-40));
  }
}

TEST(RoundedQuotient, IsNotNegative) {
  const RoundedQuotient x(constant(4, -1, 0), constant(4, 2, 0));
  EXPECT_EQ(x.upper().nominal, 0);
  EXPECT_GE(x.upper().value, 0);
  EXPECT_LE(x.upper().value, 0x1p-1000);
  EXPECT_EQ(x.lower_at_begin(), 0);
}

TEST(RoundedQuotient, IsUnboundedWhereItsDenominatorMayVanish) {
  EXPECT_EQ(RoundedQuotient(constant(4, 1, 0), constant(4, 2, 2)).upper().value, detail::infinity);
  EXPECT_EQ(RoundedQuotient(constant(4, 1, 0), constant(4, 2, 3)).upper().value, detail::infinity);
  EXPECT_EQ(RoundedQuotient(constant(4, 1, 0), constant(4, -2, 0)).upper().value, detail::infinity);
  EXPECT_EQ(RoundedQuotient(constant(4, 1, 2), constant(4, 2, 0)).lower_at_begin(), 0);
}

/// Bernstein coefficients 1, -1, 1 over 1, 0, 1: the one of zero says nothing, whatever stands over it.
TEST(RoundedQuotient, HopesOnlyWhereItsDenominatorIsPositive) {
  const auto over = [](double middle) {
    RoundedForms<1> numerator = constant(2, 1, 0), denominator = constant(2, 1, 0);
    numerator.at(0, 1) = -2;
    denominator.at(0, 1) = 2 * middle;
    denominator.close(0.5);
    return RoundedQuotient(numerator, denominator).upper();
  };
  EXPECT_EQ(over(0.25).nominal, 1);
  EXPECT_EQ(over(0).nominal, detail::infinity);
  EXPECT_EQ(over(-0.25).nominal, detail::infinity);
  for (const double middle : {0.25, 0.0, -0.25}) EXPECT_EQ(over(middle).value, detail::infinity);
}

/// A subdivision makes `degree` half sums one upon the other, each off by 2^-53.
TEST(RoundedQuotient, CountsTheErrorsOfSubdivision) {
  constexpr int degree = 20, levels = 40;
  RoundedQuotient x(constant(degree, 1, 0), constant(degree, 1, 0));
  for (int i = 0; i < levels; ++i) x = i % 2 == 0 ? x.split().first : x.split().second;
  const double error = levels * degree * rounding::unit;
  EXPECT_GE(x.upper().value, 1 + 2 * error);
  EXPECT_LE(x.lower_at_begin(), 1 - 2 * error + 4 * error * error);
  EXPECT_LE(x.upper().value, 1 + 4 * error);
}

}  // namespace
}  // namespace torse
