// A fault in each operation of an expression, against the expression with the error written in by hand.
#include "torse/exact/instrumented/faulty.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "torse/exact/rational/rational.hpp"
#include "torse/exact/symbolic/rational_function.hpp"
#include "torse/scalar/builtin.hpp"

namespace torse {
namespace {

using R = RationalFunction;
static_assert(ExactField<Faulty<Rational>>);
static_assert(RealField<Faulty<double>>);

/// -((a + b) (a - b) / b) by five operations.
template <class S>
S expression(const S& a, const S& b) {
  return -((a + b) * (a - b) / b);
}

TEST(Faulty, EachOperationIsCorruptedOnItsOwn) {
  const SymbolicContext context({"a", "b", "e"});
  const R a = context.variable(0);
  const R b = context.variable(1);
  const R e = context.variable(2);
  std::int64_t operations = 0;
  {
    const FaultScope<R> scope;
    EXPECT_EQ(expression(Faulty<R>(a), Faulty<R>(b)).value(), expression(a, b));
    operations = scope.operations();
    EXPECT_FALSE(scope.struck());
  }
  ASSERT_EQ(operations, 5);
  // The two factors are made in an order of the compiler's choice; the result is a sum over both.
  const R sum_fault = -((a + b + e) * (a - b) / b);
  const R difference_fault = -((a + b) * (a - b + e) / b);
  const std::vector<R> later = {-(((a + b) * (a - b) + e) / b), -((a + b) * (a - b) / b + e),
                                -((a + b) * (a - b) / b) + e};
  for (std::int64_t k = 0; k < operations; ++k) {
    const FaultScope<R> scope(k, e);
    const R value = expression(Faulty<R>(a), Faulty<R>(b)).value();
    EXPECT_TRUE(scope.struck());
    EXPECT_EQ(scope.operations(), operations);
    EXPECT_FALSE(value == expression(a, b));
    if (k < 2) {
      EXPECT_TRUE(value == sum_fault || value == difference_fault) << k;
    } else {
      EXPECT_EQ(value, later[static_cast<std::size_t>(k - 2)]) << k;
    }
  }
}

TEST(Faulty, DefaultErrorIsOne) {
  const FaultScope<Rational> scope(0);
  EXPECT_EQ((Faulty<Rational>(2) * Faulty<Rational>(3)).value(), Rational(7));
  EXPECT_EQ((Faulty<Rational>(2) * Faulty<Rational>(3)).value(), Rational(6));
}

TEST(Faulty, FusedProductIsTwoOperations) {
  for (const auto& [k, expected] : {std::pair{0, 8}, std::pair{1, 8}, std::pair{2, 7}}) {
    const FaultScope<Rational> scope(k);
    Faulty<Rational> y(1);
    add_product(y, Faulty<Rational>(2), Faulty<Rational>(3));
    EXPECT_EQ(y.value(), Rational(expected));
    EXPECT_EQ(scope.operations(), 2);
  }
}

TEST(Faulty, OutsideAndInnerScopes) {
  EXPECT_EQ((Faulty<Rational>(2) + Faulty<Rational>(3)).value(), Rational(5));
  FaultScope<Rational> outer(1);
  {
    const FaultScope<Rational> inner;
    EXPECT_EQ((Faulty<Rational>(2) + Faulty<Rational>(3)).value(), Rational(5));
    EXPECT_EQ(inner.operations(), 1);
  }
  EXPECT_EQ(outer.operations(), 0);
  EXPECT_EQ((Faulty<Rational>(2) + Faulty<Rational>(3)).value(), Rational(5));
  EXPECT_FALSE(outer.struck());
  EXPECT_EQ((Faulty<Rational>(2) + Faulty<Rational>(3)).value(), Rational(6));
  EXPECT_TRUE(outer.struck());
}

TEST(Faulty, SquareRootsToo) {
  const FaultScope<double> scope(0);
  EXPECT_EQ(ScalarTraits<Faulty<double>>::sqrt(Faulty<double>(9)).value(), 4);
}

}  // namespace
}  // namespace torse
