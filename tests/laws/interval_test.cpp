// Intervals obey the laws, contain the exact results and are not wider than they must be.
#include "torse/scalar/interval.hpp"

#include <cmath>
#include <limits>

#include "laws/laws.hpp"
#include "torse/exact/rational/rational.hpp"

namespace torse::laws {

template <>
struct Samples<Interval> : DyadicSamples<Interval> {
  static constexpr bool decided = false;
  static constexpr bool throws_on_zero = true;

  static Interval any(Rng& rng) {
    const double x = static_cast<double>(integer(rng, -1000, 1000)) / 7;
    const double y = static_cast<double>(integer(rng, -1000, 1000)) / 9;
    return rng() % 3 == 0 ? DyadicSamples<Interval>::any(rng) : Interval::hull(std::min(x, y), std::max(x, y));
  }
  static Interval unit(Rng& rng) {
    const Interval x = Interval::hull(0.125, 1 + static_cast<double>(integer(rng, 1, 1000)) / 3);
    return rng() % 2 == 0 ? x : -x;
  }
};

INSTANTIATE_TYPED_TEST_SUITE_P(Interval, RingLaws, Interval, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(Interval, FieldLaws, Interval, ScalarName);

namespace {

constexpr double inf = detail::infinity;
constexpr double denormal = std::numeric_limits<double>::denorm_min();
constexpr double largest = std::numeric_limits<double>::max();

double above(double x) { return std::nextafter(x, inf); }

/// A double of either sign between 2^exponent and twice that.
double sized(Rng& rng, long exponent) {
  const double mantissa = 1 + static_cast<double>(rng() >> 12) * 0x1p-52;
  return (rng() % 2 == 0 ? 1 : -1) * std::ldexp(mantissa, static_cast<int>(exponent));
}

/// A double of any size, zero, subnormal and near overflow included.
double hostile(Rng& rng) {
  if (rng() % 16 == 0) return 0;
  return sized(rng, rng() % 4 == 0 ? integer(rng, -1074, 1023) : integer(rng, -40, 40));
}

Rational exact(double x) { return Rational::from_double(x); }

/// Whether each end lies on its side of the exact value, with one double between the ends at most.
void expect_tight(const Interval& x, const Rational& value) {
  if (std::isfinite(x.lower())) {
    EXPECT_LE(exact(x.lower()), value);
  } else {
    EXPECT_LT(value, exact(-std::numeric_limits<double>::max()));
  }
  if (std::isfinite(x.upper())) {
    EXPECT_GE(exact(x.upper()), value);
  } else {
    EXPECT_GT(value, exact(std::numeric_limits<double>::max()));
  }
  const double next = std::nextafter(x.lower(), detail::infinity);
  EXPECT_GE(std::nextafter(next, detail::infinity), x.upper());
}

TEST(Interval, ContainsTheExactResultTightly) {
  Rng rng(11);
  for (int i = 0; i < 20000 && !testing::Test::HasFailure(); ++i) {
    const double x = hostile(rng);
    const double y = hostile(rng);
    SCOPED_TRACE(std::to_string(x) + ", " + std::to_string(y));
    const Interval a = Interval::point(x);
    const Interval b = Interval::point(y);
    expect_tight(a + b, exact(x) + exact(y));
    expect_tight(a - b, exact(x) - exact(y));
    expect_tight(a * b, exact(x) * exact(y));
    if (y != 0) expect_tight(a / b, exact(x) / exact(y));
  }
}

/// Away from the ends of the range each bound is the nearest double on its side.
TEST(Interval, BoundsAreTheNearestOnes) {
  const auto expect_largest_below = [](double bound, const Rational& value) {
    EXPECT_LE(exact(bound), value);
    EXPECT_LT(value, exact(above(bound)));
  };
  Rng rng(14);
  for (int i = 0; i < 5000 && !testing::Test::HasFailure(); ++i) {
    const double x = sized(rng, integer(rng, -300, 300));
    const double y = sized(rng, integer(rng, -300, 300));
    expect_largest_below(lower_sum(x, y), exact(x) + exact(y));
    expect_largest_below(lower_product(x, y), exact(x) * exact(y));
    expect_largest_below(lower_quotient(x, y), exact(x) / exact(y));
    const double root = lower_root(std::abs(x));
    EXPECT_LE(exact(root) * exact(root), exact(std::abs(x)));
    EXPECT_EQ(upper_root(std::abs(x)), exact(root) * exact(root) == exact(std::abs(x)) ? root : above(root));
  }
}

TEST(Interval, ExactResultsStayPoints) {
  const auto is_point = [](const Interval& x, double value) { return x.lower() == value && x.upper() == value; };
  const Interval x = Interval::point(1.5), y = Interval::point(0.125);
  EXPECT_TRUE(is_point(x + y, 1.625));
  EXPECT_TRUE(is_point(x - y, 1.375));
  EXPECT_TRUE(is_point(x * y, 0.1875));
  EXPECT_TRUE(is_point(x / y, 12));
}

TEST(Interval, RootsSquareToEitherSide) {
  Rng rng(12);
  for (int i = 0; i < 5000 && !testing::Test::HasFailure(); ++i) {
    const double x = std::abs(hostile(rng));
    const Interval root = ScalarTraits<Interval>::sqrt(Interval::point(x));
    EXPECT_LE(exact(root.lower()) * exact(root.lower()), exact(x));
    EXPECT_GE(exact(root.upper()) * exact(root.upper()), exact(x));
    EXPECT_GE(std::nextafter(std::nextafter(root.lower(), 2 * x + 1), 2 * x + 1), root.upper());
  }
  const Interval exact_root = ScalarTraits<Interval>::sqrt(Interval::point(2.25));
  EXPECT_EQ(exact_root.lower(), 1.5);
  EXPECT_EQ(exact_root.upper(), 1.5);
  EXPECT_EQ(ScalarTraits<Interval>::sqrt(Interval::hull(-1, 1)).lower(), -detail::infinity);
}

TEST(Interval, WideOperandsContainAllResults) {
  Rng rng(13);
  for (int i = 0; i < 2000 && !testing::Test::HasFailure(); ++i) {
    const double ends[4] = {hostile(rng), hostile(rng), hostile(rng), hostile(rng)};
    const Interval a = Interval::hull(std::min(ends[0], ends[1]), std::max(ends[0], ends[1]));
    const Interval b = Interval::hull(std::min(ends[2], ends[3]), std::max(ends[2], ends[3]));
    const auto inside = [](const Interval& x, const Rational& value) {
      return (!std::isfinite(x.lower()) || exact(x.lower()) <= value) &&
             (!std::isfinite(x.upper()) || value <= exact(x.upper()));
    };
    const Rational x = (exact(ends[0]) + exact(ends[1]) * Rational(3)) / Rational(4);
    for (const Rational& y : {exact(ends[2]), exact(ends[3]), (exact(ends[2]) + exact(ends[3])) / Rational(2)}) {
      EXPECT_TRUE(inside(a + b, x + y));
      EXPECT_TRUE(inside(a - b, x - y));
      EXPECT_TRUE(inside(a * b, x * y));
      if (y.sign() != 0 && !(b.lower() == 0 && b.upper() == 0)) {
        EXPECT_TRUE(inside(a / b, x / y));
      }
    }
  }
}

TEST(Interval, QuotientsByIntervalsWithoutEnd) {
  const Interval above = Interval::hull(2, detail::infinity);
  const Interval positive = Interval::hull(3, 4) / above;
  EXPECT_LE(positive.lower(), 0);
  EXPECT_GE(positive.lower(), -0x1p-1074);
  EXPECT_EQ(positive.upper(), 2);
  const Interval negative = Interval::hull(-4, -3) / above;
  EXPECT_EQ(negative.lower(), -2);
  EXPECT_GE(negative.upper(), 0);
  EXPECT_LE(negative.upper(), 0x1p-1074);
  const Interval both = above / above;
  EXPECT_LE(both.lower(), 0);
  EXPECT_EQ(both.upper(), detail::infinity);
  const Interval below = above / -above;
  EXPECT_EQ(below.lower(), -detail::infinity);
  EXPECT_GE(below.upper(), 0);
}

TEST(Interval, PredicatesSayOnlyWhatHoldsForAllElements) {
  EXPECT_EQ(is_zero(Interval(0)), Truth::yes);
  EXPECT_EQ(is_zero(Interval::hull(0, 1)), Truth::unknown);
  EXPECT_EQ(is_zero(Interval::hull(0x1p-1074, 1)), Truth::no);
  EXPECT_EQ(less(Interval::hull(0, 1), Interval::hull(2, 3)), Truth::yes);
  EXPECT_EQ(less(Interval::hull(0, 2), Interval::hull(2, 3)), Truth::unknown);
  EXPECT_EQ(less(Interval::hull(2, 3), Interval::hull(0, 2)), Truth::no);
  const std::int64_t beyond = (std::int64_t{1} << 53) + 1;
  EXPECT_TRUE(exact(Interval(beyond).lower()) < Rational(beyond) && Rational(beyond) < exact(Interval(beyond).upper()));
  EXPECT_THROW(Interval::hull(1, 0), InvalidInput);
  EXPECT_THROW(Interval::hull(detail::infinity, detail::infinity), InvalidInput);
  EXPECT_THROW(Interval::hull(-detail::infinity, -detail::infinity), InvalidInput);
  EXPECT_TRUE(Interval::hull(-detail::infinity, detail::infinity).contains(0));
  try {
    Interval::hull(1, 0);
    ADD_FAILURE();
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(), "interval: expected ends in increasing order");
  }
  EXPECT_THROW(Interval::point(std::nan("")), InvalidInput);
  EXPECT_THROW(static_cast<void>(Interval(1) / Interval(0)), DivisionByZero);
}

/// From 2^-960 on the error of a product is a double; below, the bound is one double lower.
TEST(Interval, TinyResults) {
  EXPECT_EQ(lower_product(0x1p-480, 0x1p-480), 0x1p-960);
  EXPECT_EQ(above(lower_product(0x1p-480, 0x1p-481)), 0x1p-961);
  EXPECT_EQ(lower_product(denormal, 0.25), -denormal);
  EXPECT_EQ(lower_quotient(0x1p-480, 0x1p480), 0x1p-960);
  EXPECT_EQ(above(lower_quotient(0x1p-481, 0x1p480)), 0x1p-961);
  EXPECT_EQ(above(lower_quotient(0x1p-1000, 0x1p-1000)), 1);
  EXPECT_EQ(lower_quotient(-denormal, 4), -denormal);
  EXPECT_EQ(above(lower_root(0x1p-1000)), 0x1p-500);
  EXPECT_EQ(upper_root(0x1p-1000), above(0x1p-500));
}

TEST(Interval, OverflowIsNoInfinity) {
  EXPECT_EQ(lower_sum(largest, largest), largest);
  EXPECT_EQ(lower_product(largest, 2), largest);
  EXPECT_EQ(lower_quotient(largest, 0.5), largest);
  EXPECT_EQ(lower_sum(-largest, -largest), -inf);
  EXPECT_EQ(lower_product(-largest, 2), -inf);
}

TEST(Interval, InfiniteEnds) {
  EXPECT_EQ(lower_sum(-inf, 3), -inf);
  EXPECT_EQ(lower_product(-2, inf), -inf);
  EXPECT_EQ(lower_product(inf, -2), -inf);
  EXPECT_EQ(lower_product(-2, -inf), inf);
  EXPECT_EQ(lower_product(-inf, 2), -inf);
  EXPECT_EQ(lower_product(0, inf), 0);
  EXPECT_EQ(lower_product(-inf, 0), 0);
  EXPECT_EQ(lower_quotient(inf, -2), -inf);
  EXPECT_EQ(lower_quotient(inf, 2), inf);
  EXPECT_EQ(lower_quotient(-inf, 2), -inf);
  EXPECT_EQ(lower_quotient(inf, inf), -inf);
  EXPECT_EQ(lower_quotient(-inf, inf), -inf);
  EXPECT_EQ(lower_quotient(3, inf), -denormal);
  EXPECT_EQ(lower_quotient(3, -inf), -denormal);
  EXPECT_EQ(lower_quotient(0, inf), 0);
  for (double end : {0.0, inf}) {
    EXPECT_EQ(lower_root(end), end);
    EXPECT_EQ(upper_root(end), end);
  }
}

TEST(Interval, NoEndIsANegativeZero) {
  for (const Interval& x : {Interval(1) - Interval(1), -Interval(0), Interval::point(-0.0)}) {
    EXPECT_FALSE(std::signbit(x.lower()));
    EXPECT_FALSE(std::signbit(x.upper()));
  }
}

}  // namespace
}  // namespace torse::laws
