// Running errors: the value is that of double, bit for bit, and the exact result is within the bound.
#include "torse/exact/instrumented/running_error.hpp"

#include <array>
#include <bit>
#include <cmath>

#include "laws/laws.hpp"
#include "torse/exact/rational/rational.hpp"

namespace torse::laws {

template <>
struct Samples<RunningError> : DyadicSamples<RunningError> {
  static constexpr bool throws_on_zero = false;
};

INSTANTIATE_TYPED_TEST_SUITE_P(RunningError, RingLaws, RunningError, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(RunningError, FieldLaws, RunningError, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(RunningError, OrderLaws, RunningError, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(RunningError, RealLaws, RunningError, ScalarName);

namespace {

/// A number as a program of operations sees it in three arithmetics.
struct Three {
  double rounded;
  RunningError running;
  Rational exact;

  static Three of(double x) { return {x, RunningError::from_double(x), Rational::from_double(x)}; }
};

double hostile(Rng& rng) {
  if (rng() % 16 == 0) return 0;
  const double mantissa = rng() % 3 == 0 ? 1 : 1 + static_cast<double>(rng() >> 12) * 0x1p-52;
  const int exponent = static_cast<int>(rng() % 4 == 0 ? integer(rng, -1074, 1023) : integer(rng, -30, 30));
  return (rng() % 2 == 0 ? 1 : -1) * std::ldexp(mantissa, exponent);
}

Rational absolute(const Rational& x) { return x.sign() < 0 ? -x : x; }

void expect_within(const Three& x) {
  if (std::isnan(x.rounded)) {
    EXPECT_TRUE(std::isnan(x.running.value()));
  } else {
    EXPECT_EQ(x.running.value(), x.rounded);
  }
  if (!std::isfinite(x.running.bound())) return;
  ASSERT_TRUE(std::isfinite(x.rounded));
  EXPECT_LE(absolute(Rational::from_double(x.rounded) - x.exact), Rational::from_double(x.running.bound()));
}

/// x op y in all three; a divisor whose exact value is zero is left alone.
Three apply(std::uint64_t operation, const Three& x, const Three& y) {
  switch (operation % 5) {
    case 0:
      return {x.rounded + y.rounded, x.running + y.running, x.exact + y.exact};
    case 1:
      return {x.rounded - y.rounded, x.running - y.running, x.exact - y.exact};
    case 2:
      return {x.rounded * y.rounded, x.running * y.running, x.exact * y.exact};
    default:
      break;
  }
  if (y.exact.sign() == 0) return x;
  return {x.rounded / y.rounded, x.running / y.running, x.exact / y.exact};
}

TEST(RunningError, BoundsTheErrorOfChainsOfOperations) {
  Rng rng(21);
  int known = 0;
  for (int run = 0; run < 3000 && !testing::Test::HasFailure(); ++run) {
    std::vector<Three> numbers{Three::of(hostile(rng)), Three::of(hostile(rng)), Three::of(hostile(rng))};
    for (int step = 0; step < 6; ++step) {
      const Three& x = numbers[rng() % numbers.size()];
      const Three& y = numbers[rng() % numbers.size()];
      Three next = apply(rng(), x, y);
      expect_within(next);
      known += std::isfinite(next.running.bound()) ? 1 : 0;
      if (next.exact.denominator_bits() + next.exact.numerator_bits() < 20000) numbers.push_back(std::move(next));
    }
  }
  EXPECT_GT(known, 12000);
}

TEST(RunningError, DivisorsMayBeNearlyAsSmallAsTheirErrors) {
  Rng rng(23);
  for (int run = 0; run < 3000 && !testing::Test::HasFailure(); ++run) {
    const Three big = Three::of(std::ldexp(1 + static_cast<double>(rng() >> 12) * 0x1p-52, 50));
    const Three divisor = apply(3, Three::of(1 + static_cast<double>(rng() >> 12) * 0x1p-52), big);
    expect_within(apply(4, Three::of(hostile(rng)), divisor));
  }
}

TEST(RunningError, QuotientsMayUnderflow) {
  Rng rng(24);
  for (int run = 0; run < 3000 && !testing::Test::HasFailure(); ++run) {
    const double tiny =
        std::ldexp(1 + static_cast<double>(rng() >> 12) * 0x1p-52, static_cast<int>(integer(rng, -1074, -950)));
    const double other =
        std::ldexp(1 + static_cast<double>(rng() >> 12) * 0x1p-52, static_cast<int>(integer(rng, -90, 90)));
    expect_within(apply(4, Three::of(tiny), Three::of(other)));
    if (std::isfinite(1 / tiny)) expect_within(apply(4, Three::of(other), Three::of(1 / tiny)));
  }
}

TEST(RunningError, OperationsThatDoNotRoundAddNothing) {
  const auto exact = [](double x) { return RunningError::from_double(x); };
  EXPECT_EQ((exact(0.5) + exact(0.25)).bound(), 0);
  EXPECT_EQ((exact(3) * exact(0.125)).bound(), 0);
  EXPECT_EQ((exact(3) / exact(8)).bound(), 0);
  EXPECT_EQ((exact(0x1p-1060) * exact(0)).bound(), 0);
  EXPECT_EQ(ScalarTraits<RunningError>::sqrt(exact(2.25)).bound(), 0);
  EXPECT_EQ(is_zero(exact(0.1) - exact(0.1)), Truth::yes);
}

TEST(RunningError, BoundsAreNearTheErrors) {
  const RunningError third = RunningError(1) / RunningError(3);
  EXPECT_LT(third.bound(), 0x1p-54);
  EXPECT_GT(third.bound(), 0x1p-56);
  EXPECT_EQ(is_zero(third * RunningError(3) - RunningError(1)), Truth::unknown);
  EXPECT_EQ(is_zero(third - RunningError::from_double(0.3333)), Truth::no);
}

TEST(RunningError, NothingIsKnownBeyondTheRangeOrBesideAZeroDivisor) {
  const RunningError huge = RunningError::from_double(0x1p1023);
  EXPECT_EQ(is_zero(huge + huge), Truth::unknown);
  EXPECT_EQ(is_zero(huge * huge), Truth::unknown);
  EXPECT_EQ(is_zero(RunningError(1) / RunningError(0)), Truth::unknown);
  const RunningError small = RunningError(1) / RunningError(3) * RunningError(3) - RunningError(1);
  EXPECT_TRUE(std::isinf((RunningError(1) / small).bound()));
  EXPECT_TRUE(std::isinf((huge + huge).bound()));
  EXPECT_TRUE(std::isinf(ScalarTraits<RunningError>::sqrt(RunningError::from_double(0x1p-60) - small).bound()));
  EXPECT_TRUE(std::isinf(ScalarTraits<RunningError>::sqrt(RunningError(-1)).bound()));
}

/// A double and a bound that no one operation gives: half of the time beside the size of the double, where a divisor
/// barely is none.
RunningError uncertain(Rng& rng) {
  const double value = hostile(rng);
  double bound = rng() % 4 == 0 ? 0 : std::abs(hostile(rng));
  if (rng() % 2 == 0) {
    bound = std::abs(value);
    for (std::uint64_t i = rng() % 4; i > 0; --i) bound = std::nextafter(bound, 0.0);
  }
  return std::bit_cast<RunningError>(std::array<double, 2>{value, bound});
}

TEST(RunningError, OperandsMayBeAnywhereWithinTheirBounds) {
  Rng rng(25);
  int known = 0;
  for (int run = 0; run < 20000 && !testing::Test::HasFailure(); ++run) {
    const RunningError x = uncertain(rng);
    const RunningError y = uncertain(rng);
    const RunningError root_x = ScalarTraits<RunningError>::sqrt(x);
    for (const int corner : {0, 1, 2, 3}) {
      const auto end = [](const RunningError& z, bool upper) {
        const Rational bound = Rational::from_double(z.bound());
        return Rational::from_double(z.value()) + (upper ? bound : -bound);
      };
      const Three a{x.value(), x, end(x, corner % 2 == 1)};
      const Three b{y.value(), y, end(y, corner / 2 == 1)};
      for (std::uint64_t operation = 0; operation < 4; ++operation) {
        const Three result = apply(operation, a, b);
        if (operation == 3 && b.exact.sign() == 0) {
          EXPECT_TRUE(std::isinf((x / y).bound()));
        } else {
          expect_within(result);
          known += std::isfinite(result.running.bound()) ? 1 : 0;
        }
      }
      if (std::isfinite(root_x.bound())) {
        const Rational above = end(root_x, true);
        const Rational below = end(root_x, false);
        EXPECT_LE(below.sign() < 0 ? Rational() : below * below, a.exact);
        EXPECT_GE(above * above, a.exact);
      }
    }
  }
  EXPECT_GT(known, 200000);
}

TEST(RunningError, IntegersAreWithinTheirBounds) {
  for (const std::int64_t two : {std::int64_t{1} << 52, std::int64_t{1} << 53, std::int64_t{1} << 54}) {
    for (std::int64_t i = two - 3; i <= two + 3; ++i) {
      for (const std::int64_t j : {i, -i}) {
        const RunningError x(j);
        EXPECT_LE(absolute(Rational::from_double(x.value()) - Rational(j)), Rational::from_double(x.bound())) << j;
        if (std::abs(j) < std::int64_t{1} << 53) {
          EXPECT_EQ(x.bound(), 0);
        }
      }
    }
  }
}

/// 3/10 - 2/10 - 1/10 is zero and computed as 2^-55; dividing by it says nothing, and neither does zero times that.
TEST(RunningError, ZeroTimesTheUnknownIsUnknown) {
  const RunningError tenth = RunningError::from_double(0.1);
  const RunningError zero = tenth * RunningError(3) - tenth * RunningError(2) - tenth;
  EXPECT_EQ(zero.value(), 0x1p-55);
  const RunningError unknown = RunningError(1) / zero;
  EXPECT_EQ(unknown.value(), 0x1p55);
  EXPECT_TRUE(std::isinf((RunningError(0) * unknown).bound()));
  EXPECT_TRUE(std::isinf((unknown * RunningError(0)).bound()));
}

TEST(RunningError, RootsAreWithinTheirBounds) {
  Rng rng(22);
  for (int run = 0; run < 3000 && !testing::Test::HasFailure(); ++run) {
    const double x = std::abs(hostile(rng));
    const RunningError r = ScalarTraits<RunningError>::sqrt(RunningError::from_double(x));
    const Rational value = Rational::from_double(r.value());
    const Rational bound = Rational::from_double(r.bound());
    const Rational low = value - bound;
    EXPECT_LE(low.sign() < 0 ? Rational() : low * low, Rational::from_double(x));
    EXPECT_GE((value + bound) * (value + bound), Rational::from_double(x));
  }
}

}  // namespace
}  // namespace torse::laws
