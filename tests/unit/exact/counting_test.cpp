// Operation counts against counts by hand.
#include "torse/exact/instrumented/counting.hpp"

#include <gtest/gtest.h>

#include "torse/algebra/determinant.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/scalar/builtin.hpp"

namespace torse {
namespace {

using C = Counting<Rational>;
static_assert(ExactField<C> && OrderedField<C>);
static_assert(RealField<Counting<double>>);

TEST(Counting, CountsByKindInsideTheScopeOnly) {
  const C a(2);
  const C b(3);
  Tally tally;
  const C before = a * b;
  C y(0);
  {
    const CountingScope scope(tally);
    y = (a + b) * (a - b) / -b;
    add_product(y, a, b);
    EXPECT_EQ(less(a, b), Truth::yes);
    EXPECT_EQ(is_zero(a), Truth::no);
  }
  const C after = before / b;
  EXPECT_EQ(tally, (Tally{.additions = 4, .multiplications = 2, .divisions = 1, .comparisons = 2, .square_roots = 0}));
  EXPECT_EQ(y.value(), ratio<Rational>(5, 3) + Rational(6));
  EXPECT_EQ(after.value(), Rational(2));
}

TEST(Counting, InnerScopeTakesOver) {
  Tally outer;
  Tally inner;
  const CountingScope outer_scope(outer);
  C x(1);
  x += x;
  {
    const CountingScope inner_scope(inner);
    x *= x;
  }
  x += x;
  EXPECT_EQ(outer.additions, 2);
  EXPECT_EQ(outer.multiplications, 0);
  EXPECT_EQ(inner.multiplications, 1);
}

TEST(Counting, DeterminantTakesThirtyProducts) {
  const auto row = [](int i) { return Vec<C, 4>(C(i), C(i * i), C(1), C(7 - i)); };
  Tally tally;
  const CountingScope scope(tally);
  det4<C>(row(1), row(2), row(3), row(4));
  EXPECT_EQ(tally.multiplications, 12 * 2 + 6);
  EXPECT_EQ(tally.additions, 12 + 5);
  EXPECT_EQ(tally.divisions, 0);
}

TEST(Counting, SquareRoots) {
  Tally tally;
  const CountingScope scope(tally);
  EXPECT_EQ(ScalarTraits<Counting<double>>::sqrt(Counting<double>(9)).value(), 3);
  EXPECT_EQ(tally.square_roots, 1);
}

}  // namespace
}  // namespace torse
