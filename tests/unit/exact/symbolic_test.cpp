// Rational functions against evaluation at random rational points in another arithmetic.
#include "torse/exact/symbolic/rational_function.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include "random_program.hpp"
#include "torse/exact/symbolic/simple_fraction.hpp"
#include "torse/scalar/concepts.hpp"
#include "torse/scalar/errors.hpp"

namespace torse {
namespace {

using R = RationalFunction;
static_assert(ExactField<R>);
static_assert(!OrderedField<R>);

class RationalFunctionTest : public testing::Test {
 protected:
  SymbolicContext context_{{"x", "y", "z"}};
  R x_ = context_.variable(0);
  R y_ = context_.variable(1);
  R z_ = context_.variable(2);
};

TEST_F(RationalFunctionTest, AgreesWithEvaluationAtRandomPoints) {
  std::mt19937_64 random(1);
  int compared = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const test::Program program = test::random_program(random, 3, 9, "+-*/");
    const std::vector<R> functions = program.run<R>({x_, y_, z_});
    const std::vector<CppRational> point = test::random_point(random, 3);
    std::vector<CppRational> values;
    try {
      values = program.run(point);
    } catch (const DivisionByZero&) {
      continue;
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
      ASSERT_EQ(functions[i].evaluate(test::texts(point)), values[i].text()) << functions[i].text();
      ++compared;
    }
  }
  EXPECT_GT(compared, 3000);
}

TEST_F(RationalFunctionTest, CompoundAssignmentAndTemporariesAgreeWithOperators) {
  std::mt19937_64 random(2);
  for (int trial = 0; trial < 100; ++trial) {
    const std::vector<R> values = test::random_program(random, 3, 7, "+-*/").run<R>({x_, y_, z_});
    for (const R& a : values) {
      const R& b = values.back();
      R sum = a;
      R difference = a;
      R product = a;
      EXPECT_EQ(sum += b, a + b);
      EXPECT_EQ(difference -= b, a - b);
      EXPECT_EQ(product *= b, a * b);
      EXPECT_EQ(R(a) + b, a + b);
      EXPECT_EQ(R(a) - b, a - b);
      EXPECT_EQ(-(R(a) * b), -(a * b));
      R fused = a;
      add_product(fused, b, a);
      EXPECT_EQ(fused, a + b * a);
      if (b.is_zero()) continue;
      R quotient = a;
      EXPECT_EQ(quotient /= b, a / b);
      EXPECT_EQ(R(a) / b, a / b);
    }
  }
}

// Products with simple fractions (units, linear and primitive) take a path of their own. A nonlinear factor above and
// below, put in first and cancelled last, keeps to the general one; reduced forms are unique, so the results must be
// the same.
TEST_F(RationalFunctionTest, SimpleFactorsAgreeWithTheGeneralPath) {
  const R q = x_ * x_ * y_ + R(3) * z_ - R(7);
  const std::vector<R> simple = {R(1),
                                 R(-1),
                                 x_,
                                 -y_,
                                 x_ - y_,
                                 y_ - x_,
                                 z_ - x_,
                                 z_ + R(1),
                                 R(1) - z_,
                                 R(2) * x_ - z_,
                                 R(3) * y_ + R(1),
                                 x_ + y_ + z_,
                                 R(2) * x_ + R(2),
                                 R(4) * y_ - R(2) * x_};
  const std::vector<R> awkward = {R(2) * x_ + R(2), R(2) * x_ + R(3), x_ * y_, x_ * x_ + R(1), R(6)};
  std::mt19937_64 random(9);
  for (int trial = 0; trial < 400; ++trial) {
    const auto pick = [&random](const std::vector<R>& from) { return from[random() % from.size()]; };
    R f = pick(awkward) / pick(awkward);
    for (int k = 0; k < 4; ++k) {
      const R c = pick(simple);
      const R d = pick(simple);
      const R ratio = c / d;
      const R general_ratio = ((c * q) * (R(1) / (d * q * (q + x_)))) * (q + x_);
      ASSERT_EQ(ratio, general_ratio) << c.text() << " over " << d.text();
      const R product = f * ratio;
      ASSERT_EQ(product, (f * (general_ratio * q)) / q) << f.text() << " times " << ratio.text();
      ASSERT_EQ(product, ratio * f);
      ASSERT_EQ(f / ratio, (f * q) / (general_ratio * q));
      f = product;
    }
  }
}

/// Which polynomials take that path: units, and linear ones with a coefficient +-1.
TEST(SimpleFraction, IsOfUnitsAndLinearPolynomials) {
  fmpz_mpoly_ctx_t ring;
  fmpz_mpoly_ctx_init(ring, 3, ORD_LEX);
  const char* names[] = {"x", "y", "z"};
  const auto simple = [&](const char* text) {
    fmpz_mpoly_t p;
    fmpz_mpoly_init(p, ring);
    EXPECT_EQ(fmpz_mpoly_set_str_pretty(p, text, names, ring), 0);
    const bool result = detail::is_simple(p, ring);
    fmpz_mpoly_clear(p, ring);
    return result;
  };
  for (const char* text : {"1", "-1", "x", "-z", "x-y", "2*x+1", "3*x-y", "x+y+z-5"}) EXPECT_TRUE(simple(text)) << text;
  for (const char* text : {"0", "2", "-3", "2*x", "2*x+2", "x*y", "x^2+1", "x*y+z"}) EXPECT_FALSE(simple(text)) << text;
  fmpz_mpoly_ctx_clear(ring);
}

TEST_F(RationalFunctionTest, AnOperandMayBeTheResult) {
  R a = x_ / (y_ + R(1));
  const R& itself = a;
  a += itself;
  EXPECT_EQ(a, R(2) * x_ / (y_ + R(1)));
  a *= itself;
  EXPECT_EQ(a, R(4) * x_ * x_ / (y_ + R(1)) / (y_ + R(1)));
  a = itself;
  EXPECT_EQ(a, R(4) * x_ * x_ / (y_ + R(1)) / (y_ + R(1)));
  a /= itself;
  EXPECT_EQ(a, R(1));
  a = x_;
  a *= itself;
  EXPECT_EQ(a, x_ * x_);
  a -= itself;
  EXPECT_TRUE(a.is_zero());
}

TEST_F(RationalFunctionTest, ConstantsBelongToEveryContext) {
  const SymbolicContext other({"t"});
  const R third = R(1) / R(3);
  EXPECT_TRUE(third.is_constant());
  EXPECT_EQ((x_ + third).evaluate({"1/3", "0", "0"}), "2/3");
  EXPECT_EQ((other.variable(0) - third).evaluate({"1/3"}), "0");
  EXPECT_TRUE((x_ / x_).is_constant());
  EXPECT_EQ((x_ - x_) + other.variable(0), other.variable(0));
  EXPECT_THROW(x_ + other.variable(0), InvalidInput);
  R mixed = other.variable(0);
  mixed = x_;
  EXPECT_EQ(mixed, x_);
  EXPECT_FALSE(x_ == other.variable(0));
}

TEST_F(RationalFunctionTest, LargeConstantsStayExact) {
  R power = R(1);
  for (int i = 0; i < 200; ++i) power *= R(3);
  EXPECT_EQ((power * x_ / power), x_);
  EXPECT_EQ((power - R(1)) / power + R(1) / power, R(1));
  EXPECT_EQ(R(~std::uint64_t{0}).text(), "18446744073709551615");
  EXPECT_EQ(R(std::numeric_limits<std::int64_t>::min()).text(), "-9223372036854775808");
}

TEST_F(RationalFunctionTest, MovedFromIsZero) {
  R a = x_ + y_;
  const R b = std::move(a);
  EXPECT_TRUE(a.is_zero());  // NOLINT(bugprone-use-after-move)
  EXPECT_EQ(b, x_ + y_);
}

TEST_F(RationalFunctionTest, DivisionByZeroThrows) {
  EXPECT_THROW(x_ / R(0), DivisionByZero);
  EXPECT_THROW(R(1) / R(0), DivisionByZero);
  EXPECT_THROW(x_ / ((x_ + y_) * (x_ - y_) - x_ * x_ + y_ * y_), DivisionByZero);
  EXPECT_THROW((R(1) / (x_ - y_)).evaluate({"1/2", "2/4", "0"}), DivisionByZero);
}

TEST_F(RationalFunctionTest, InputsAreChecked) {
  EXPECT_THROW(SymbolicContext({}), InvalidInput);
  EXPECT_THROW(context_.variable(3), std::out_of_range);
  EXPECT_THROW(context_.variable(-1), std::out_of_range);
  EXPECT_THROW(x_.evaluate({"1", "2"}), InvalidInput);
  EXPECT_THROW(x_.evaluate({"1", "2", "three"}), InvalidInput);
  EXPECT_THROW(x_.evaluate({"1", "2", "3/0"}), InvalidInput);
}

TEST_F(RationalFunctionTest, TextLengthAndShape) {
  const R f = (R(6) * x_ + R(4) * y_) / (R(2) * z_ * z_ - R(2));
  EXPECT_EQ(f.text(), "(3*x+2*y)/(z^2-1)");
  EXPECT_EQ(f.length(), 4);
  EXPECT_EQ(f.shape().numerator_degree, 1);
  EXPECT_EQ(f.shape().denominator_degree, 2);
  EXPECT_EQ(f.shape().numerator_bits, 3);
  EXPECT_EQ(f.shape().denominator_bits, 1);
  EXPECT_EQ((x_ + R(1)).text(), "x+1");
  EXPECT_EQ(R(-5).text(), "-5");
  EXPECT_LT(ScalarTraits<R>::weight(x_), ScalarTraits<R>::weight(f));
}

}  // namespace
}  // namespace torse
