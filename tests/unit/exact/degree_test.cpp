// The bounds of Degree against the true degrees and coefficient sizes, found symbolically.
#include "torse/exact/instrumented/degree.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "random_program.hpp"
#include "torse/exact/symbolic/rational_function.hpp"
#include "torse/scalar/concepts.hpp"

namespace torse {
namespace {

static_assert(Field<Degree>);

TEST(Degree, BoundsHoldOnRandomPolynomials) {
  const SymbolicContext context({"x", "y", "z"});
  std::mt19937_64 random(4);
  int attained = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const test::Program program = test::random_program(random, 3, 10, "+-*");
    const auto actual = program.run<RationalFunction>({context.variable(0), context.variable(1), context.variable(2)});
    const auto bound = program.run<Degree>({Degree::input(), Degree::input(), Degree::input()});
    for (std::size_t i = 0; i < actual.size(); ++i) {
      const Shape shape = actual[i].shape();
      ASSERT_LE(shape.numerator_degree, bound[i].numerator_degree()) << actual[i].text();
      ASSERT_LE(shape.numerator_bits, bound[i].numerator_bits()) << actual[i].text();
      ASSERT_EQ(bound[i].denominator_degree(), 0);
      ASSERT_EQ(bound[i].denominator_bits(), 0);
      if (i >= 7 && shape.numerator_bits > 2 && shape.numerator_bits == bound[i].numerator_bits()) ++attained;
    }
  }
  EXPECT_GT(attained, 500);
}

// Where both degrees are attained, the unreduced numerator is an integer multiple of the reduced one, so that its norm
// bounds the reduced norm; where they are not, a factor has cancelled, whose cofactor may have a larger norm.
TEST(Degree, BoundsHoldOnRandomRationalFunctions) {
  const SymbolicContext context({"x", "y", "z"});
  std::mt19937_64 random(5);
  int attained = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const test::Program program = test::random_program(random, 3, 9, "+-*/");
    const auto actual = program.run<RationalFunction>({context.variable(0), context.variable(1), context.variable(2)});
    const auto bound = program.run<Degree>({Degree::input(), Degree::input(), Degree::input()});
    for (std::size_t i = 0; i < actual.size(); ++i) {
      if (actual[i].is_zero()) continue;
      const Shape shape = actual[i].shape();
      ASSERT_LE(shape.numerator_degree, bound[i].numerator_degree()) << actual[i].text();
      ASSERT_LE(shape.denominator_degree, bound[i].denominator_degree()) << actual[i].text();
      ASSERT_FALSE(definitely(is_zero(bound[i])));
      if (shape.numerator_degree == bound[i].numerator_degree() &&
          shape.denominator_degree == bound[i].denominator_degree()) {
        ASSERT_LE(shape.numerator_bits, bound[i].numerator_bits()) << actual[i].text();
        ASSERT_LE(shape.denominator_bits, bound[i].denominator_bits()) << actual[i].text();
        if (i >= 7 && shape.denominator_degree > 0) ++attained;
      }
    }
  }
  EXPECT_GT(attained, 300);
}

TEST(Degree, KnowsZeroAndConstants) {
  EXPECT_EQ(is_zero(Degree()), Truth::yes);
  EXPECT_EQ(is_zero(Degree(0)), Truth::yes);
  EXPECT_EQ(is_zero(Degree(0) * Degree::input()), Truth::yes);
  EXPECT_EQ(is_zero(Degree(3) / Degree(-7)), Truth::no);
  EXPECT_EQ(is_zero(Degree::input()), Truth::unknown);
  EXPECT_EQ(is_zero(Degree(1) - Degree(1)), Truth::unknown);
  EXPECT_THROW(Degree(1) / Degree(0), DivisionByZero);
  EXPECT_EQ(Degree(-8).numerator_bits(), 3);
  EXPECT_EQ(Degree(9).numerator_bits(), 4);
  EXPECT_EQ((Degree(1) / Degree(9)).denominator_bits(), 4);
}

TEST(Degree, EqualDenominatorsStay) {
  const Degree w = Degree::input();
  Degree sum = Degree::input() / w;
  for (int i = 0; i < 20; ++i) sum += Degree::input() / w;
  EXPECT_EQ(sum.denominator_degree(), 1);
  EXPECT_EQ(sum.numerator_degree(), 1);
  EXPECT_EQ(sum.numerator_bits(), 5);  // 21 <= 2^5
  EXPECT_EQ((sum * w).denominator_degree(), 0);
}

// m <- (a + b m) / (c + d m), the shape of FJ07.18: the denominators of m cancel, so the growth is linear.
TEST(Degree, RecursionsByFractionsGrowLinearly) {
  Degree m = Degree::input();
  for (int k = 1; k <= 40; ++k) {
    m = (Degree::input() + Degree::input() * m) / (Degree::input() + Degree::input() * m);
    EXPECT_EQ(m.numerator_degree(), k + 1);
    EXPECT_EQ(m.denominator_degree(), k + 1);
  }
}

/// log2() of a number that is held exactly is that of the number, and one that is not exact counts as more: 2^53 + 1,
/// and 2^58 + 1 = (2^29 - 2^15 + 1) (2^29 + 2^15 + 1), have 54 and 59.
TEST(UpperBound, IsRoundedUpOnlyWhereItIsNotExact) {
  const auto bound = [](std::uint64_t i) { return UpperBound(i); };
  const auto two_to = [](int k) { return std::uint64_t{1} << k; };
  EXPECT_EQ((bound(1) + bound(1)).log2(), 1);
  EXPECT_EQ((bound(5) + bound(3)).log2(), 3);
  EXPECT_EQ((bound(3) + bound(5)).log2(), 3);
  EXPECT_EQ((bound(5) + bound(4)).log2(), 4);
  EXPECT_EQ((bound(8) * bound(4)).log2(), 5);
  EXPECT_EQ((bound(3) * bound(5)).log2(), 4);
  EXPECT_EQ(bound(two_to(53)).log2(), 53);
  EXPECT_EQ(bound(two_to(53) + 1).log2(), 54);
  EXPECT_EQ((bound(two_to(53)) + bound(1)).log2(), 54);
  EXPECT_EQ((bound(1) + bound(two_to(53))).log2(), 54);
  EXPECT_EQ((bound(two_to(29) - two_to(15) + 1) * bound(two_to(29) + two_to(15) + 1)).log2(), 59);
}

/// Operands whose exponents are 2048 apart, where the smaller one underflows.
TEST(UpperBound, TellsASumFromItsLargerPart) {
  UpperBound power(2);
  for (int i = 0; i < 11; ++i) power = power * power;
  EXPECT_EQ(power.log2(), 2048);
  EXPECT_EQ((power + UpperBound(1)).log2(), 2049);
  EXPECT_EQ((UpperBound(1) + power).log2(), 2049);
}

TEST(Degree, BoundsOfAnySizeStayFinite) {
  Degree power = Degree::input() + Degree(1);
  for (int i = 0; i < 40; ++i) power *= power;
  EXPECT_EQ(power.numerator_degree(), std::int64_t{1} << 40);
  Degree chain = Degree(3);
  for (int i = 0; i < 3000; ++i) chain = chain * Degree(1024) + Degree(1);
  EXPECT_GE(chain.numerator_bits(), 30001);
  EXPECT_LE(chain.numerator_bits(), 30003);
}

}  // namespace
}  // namespace torse
