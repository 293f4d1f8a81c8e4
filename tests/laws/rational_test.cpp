// Both exact rational back ends: the laws, one against the other, and Rational's conversions.
#include "torse/exact/rational/rational.hpp"

#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "laws/laws.hpp"
#include "torse/exact/rational/cpp_rational.hpp"

namespace torse::laws {

template <>
struct Samples<Rational> : FractionSamples<Rational> {};
template <>
struct Samples<CppRational> : FractionSamples<CppRational> {};

using Rationals = testing::Types<Rational, CppRational>;
INSTANTIATE_TYPED_TEST_SUITE_P(Rational, RingLaws, Rationals, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(Rational, FieldLaws, Rationals, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(Rational, OrderLaws, Rationals, ScalarName);

/// x op y for the operation of that number.
template <class S>
S operate(std::uint64_t operation, const S& x, const S& y) {
  switch (operation) {
    case 0:
      return x + y;
    case 1:
      return x - y;
    case 2:
      return x * y;
    default:
      return definitely(is_zero(y)) ? -x : x / y;
  }
}

TEST(Rational, AgreesWithTheOtherBackEnd) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Rng rng(seed);
    std::vector<Rational> x;
    std::vector<CppRational> y;
    for (int i = 0; i < 8; ++i) {
      x.push_back(FractionSamples<Rational>::any(rng));
      y.push_back(CppRational::from_text(as_text(x.back())));
    }
    for (int step = 0; step < 40; ++step) {
      const std::uint64_t operation = rng() % 4, i = rng() % 8, j = rng() % 8, k = rng() % 8;
      x[k] = operate(operation, x[i], x[j]);
      y[k] = operate(operation, y[i], y[j]);
      ASSERT_EQ(as_text(x[k]), as_text(y[k]));
      ASSERT_EQ(x[i] < x[j], y[i] < y[j]);
      ASSERT_EQ(x[i] == x[j], y[i] == y[j]);
      ASSERT_EQ(Rational::from_text(as_text(y[k])), x[k]);
      if (x[k].numerator_bits() > 20000) break;
    }
  }
}

TEST(Rational, ReadsIntegersAndFractions) {
  EXPECT_EQ(Rational::from_text("17"), Rational(17));
  EXPECT_EQ(Rational::from_text("+17"), Rational(17));
  EXPECT_EQ(Rational::from_text("-6/4"), Rational(-3) / Rational(2));
  EXPECT_EQ(Rational::from_text("-6/4").text(), "-3/2");
  EXPECT_EQ(Rational::from_text("007/0014").text(), "1/2");
  EXPECT_EQ(Rational::from_text("0/5").text(), "0");
  EXPECT_EQ(Rational::from_text("-0").text(), "0");
  const std::string huge = "-1" + std::string(500, '0') + "1";
  EXPECT_EQ(Rational::from_text(huge).text(), huge);
  for (const char* bad :
       {"",    "-",   "+",    "/",  "1/", "/2",   "1/0",  "-1/0",  "0/0", "1/-2", "1/+2", "--1",  "+-1",
        "1.5", "1e3", "0x10", " 1", "1 ", "1 /2", "1/ 2", "1/2/3", "one", "inf",  "nan",  "1_000"}) {
    EXPECT_THROW(static_cast<void>(Rational::from_text(bad)), InvalidInput) << '"' << bad << '"';
  }
  EXPECT_THROW(static_cast<void>(Rational::from_text(std::string_view("1\0002", 3))), InvalidInput);
  for (const char* bad : {"1/0", "x", "1.5"}) {
    EXPECT_THROW(static_cast<void>(CppRational::from_text(bad)), InvalidInput) << '"' << bad << '"';
  }
}

/// 2^k by repeated multiplication.
Rational power_of_two(int k) {
  Rational r(1);
  for (; k > 0; --k) r *= Rational(2);
  for (; k < 0; ++k) r /= Rational(2);
  return r;
}

/// A finite double with random bits; one in four lies below the normal range.
double random_bits(Rng& rng) {
  for (;;) {
    std::uint64_t bits = rng();
    if (rng() % 4 == 0) bits &= 0x800fffffffffffff;
    const auto x = std::bit_cast<double>(bits);
    if (std::isfinite(x)) return x;
  }
}

TEST(Rational, FromDoubleIsExact) {
  Rng rng(1);
  for (int i = 0; i < 100; ++i) {
    const double x = random_bits(rng);
    int exponent = 0;
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
    EXPECT_EQ(Rational::from_double(x), Rational(mantissa) * power_of_two(exponent - 53));
  }
  EXPECT_EQ(Rational::from_double(-0.0), Rational(0));
  EXPECT_EQ(Rational::from_double(0.1).text(), "3602879701896397/36028797018963968");
  EXPECT_THROW(static_cast<void>(Rational::from_double(std::numeric_limits<double>::quiet_NaN())), InvalidInput);
  EXPECT_THROW(static_cast<void>(Rational::from_double(std::numeric_limits<double>::infinity())), InvalidInput);
  EXPECT_THROW(static_cast<void>(Rational::from_double(-std::numeric_limits<double>::infinity())), InvalidInput);
}

TEST(Rational, ToDoubleInvertsFromDouble) {
  Rng rng(2);
  for (int i = 0; i < 2000; ++i) {
    const double x = random_bits(rng);
    EXPECT_EQ(Rational::from_double(x).to_double(), x);
  }
}

TEST(Rational, ToDoubleRoundsToNearestWithTiesToEven) {
  Rng rng(3);
  const Rational hair = power_of_two(-1300);
  for (int i = 0; i < 500; ++i) {
    const double x = random_bits(rng);
    const double y = std::nextafter(x, HUGE_VAL);
    if (!std::isfinite(y)) continue;
    const Rational middle = (Rational::from_double(x) + Rational::from_double(y)) / Rational(2);
    const bool x_is_even = std::bit_cast<std::uint64_t>(x) % 2 == 0;
    EXPECT_EQ(middle.to_double(), x_is_even ? x : y);
    EXPECT_EQ((middle - hair).to_double(), x);
    EXPECT_EQ((middle + hair).to_double(), y);
  }
}

TEST(Rational, ToDoubleAtTheEndsOfTheRange) {
  constexpr double largest = std::numeric_limits<double>::max();
  constexpr double smallest = std::numeric_limits<double>::denorm_min();
  const Rational above = Rational::from_double(largest) + power_of_two(970);
  const Rational hair = power_of_two(-1300);
  EXPECT_EQ(above.to_double(), HUGE_VAL);
  EXPECT_EQ((-above).to_double(), -HUGE_VAL);
  EXPECT_EQ((above - hair).to_double(), largest);
  EXPECT_EQ(power_of_two(5000).to_double(), HUGE_VAL);
  EXPECT_EQ((-power_of_two(5000)).to_double(), -HUGE_VAL);
  EXPECT_EQ(power_of_two(-1075).to_double(), 0.0);
  EXPECT_EQ((power_of_two(-1075) + hair).to_double(), smallest);
  EXPECT_EQ((-power_of_two(-1075) - hair).to_double(), -smallest);
  EXPECT_EQ(power_of_two(-5000).to_double(), 0.0);
  EXPECT_EQ((power_of_two(-1022) - hair).to_double(), std::numeric_limits<double>::min());
}

TEST(Rational, ToDoubleAgreesWithTheDecimalReaderOfTheSystem) {
  Rng rng(4);
  for (int i = 0; i < 2000; ++i) {
    const std::string digits = std::to_string(rng());
    const int places = static_cast<int>(integer(rng, 0, 330));
    const Rational x = Rational::from_text(digits + "/1" + std::string(static_cast<std::size_t>(places), '0'));
    EXPECT_EQ(x.to_double(), std::strtod((digits + "e-" + std::to_string(places)).c_str(), nullptr));
  }
}

TEST(Rational, TellsItsSize) {
  EXPECT_EQ(Rational(0).numerator_bits(), 0U);
  EXPECT_EQ(Rational(0).denominator_bits(), 1U);
  EXPECT_EQ(Rational::from_text("-255/1024").numerator_bits(), 8U);
  EXPECT_EQ(Rational::from_text("-255/1024").denominator_bits(), 11U);
}

TEST(Rational, CommonDenominatorIsTheLeast) {
  const auto least = [](const std::vector<Rational>& list) { return ScalarTraits<Rational>::common_denominator(list); };
  EXPECT_EQ(least({ratio<Rational>(-1, 4), ratio<Rational>(5, 6), Rational(3)}), Rational(12));
  EXPECT_EQ(least({ratio<Rational>(2, 7)}), Rational(7));
  EXPECT_EQ(least({}), Rational(1));
}

TEST(Rational, TakesUnsignedWords) {
  EXPECT_EQ(Rational(~std::uint64_t{0}).text(), "18446744073709551615");
  EXPECT_EQ(Rational(std::numeric_limits<std::int64_t>::min()).text(), "-9223372036854775808");
}

TEST(Rational, CopiesGmpNumbersInLowestTerms) {
  mpq_t q;
  mpq_init(q);
  mpz_set_si(mpq_numref(q), 6);
  mpz_set_si(mpq_denref(q), -4);
  EXPECT_EQ(Rational::from_mpq(q).text(), "-3/2");
  mpz_set_si(mpq_denref(q), 0);
  EXPECT_THROW(static_cast<void>(Rational::from_mpq(q)), DivisionByZero);
  mpq_clear(q);
}

const Rational outlives_its_thread = Rational(1) / Rational(3);

TEST(Rational, MovesBetweenThreadsAndOutlivesThem) {
  std::vector<Rational> made;
  for (int round = 0; round < 4; ++round) {
    std::thread worker([&made] {
      for (int i = 1; i <= 200; ++i) made.push_back(outlives_its_thread + Rational(1) / Rational(i));
    });
    worker.join();
  }
  Rational sum;
  for (Rational& x : made) sum += std::move(x) - outlives_its_thread;
  Rational harmonic;
  for (int i = 1; i <= 200; ++i) harmonic += Rational(4) / Rational(i);
  EXPECT_EQ(sum, harmonic);
}

}  // namespace torse::laws
