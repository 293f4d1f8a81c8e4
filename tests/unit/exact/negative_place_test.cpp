// Where polynomials are negative, against their factors.
#include "torse/exact/roots/negative_place.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace torse::test {
namespace {

using Q = Rational;
using B = Bernstein<Q>;

Q q(std::int64_t a, std::int64_t b = 1) { return ratio<Q>(a, b); }

/// t - a.
B root(const Q& a) { return B({-a, Q(1) - a}); }

B constant(int a) { return B({Q(a)}); }

/// A place, and f < 0 there by its factors: between these.
void expect_between(const B& f, const Q& low, const Q& high) {
  const auto place = negative_place(f);
  ASSERT_TRUE(place);
  EXPECT_LT(low, *place);
  EXPECT_LT(*place, high);
}

TEST(NegativePlace, OfSimpleZeros) {
  expect_between(root(q(1, 3)), q(-1), q(1, 3));
  expect_between(constant(-1) * root(q(1, 3)), q(1, 3), q(2));
  expect_between(root(q(1, 3)) * root(q(2, 3)), q(1, 3), q(2, 3));
  EXPECT_FALSE(negative_place(root(q(-1, 7))));
  EXPECT_FALSE(negative_place(constant(-1) * root(q(8, 7))));
}

TEST(NegativePlace, ZerosAtTheEndsAreNone) {
  EXPECT_FALSE(negative_place(root(q(0))));
  EXPECT_FALSE(negative_place(constant(-1) * root(q(1))));
  EXPECT_FALSE(negative_place(constant(0)));
  expect_between(root(q(0)) * root(q(1)), q(0), q(1));
}

/// What halvings do not tell from two zeros.
TEST(NegativePlace, DoubleZerosAreNone) {
  for (const B& zero : {root(q(1, 3)), root(q(1, 2)), root(q(3, 5)) * root(q(1, 7))}) {
    EXPECT_FALSE(negative_place(zero * zero));
    EXPECT_TRUE(negative_place(constant(-1) * zero * zero));
  }
  const B irrational = root(q(0)) * root(q(0)) - B({q(1, 2)}).elevated(2);  // t^2 - 1/2
  EXPECT_FALSE(negative_place(irrational * irrational));
  EXPECT_FALSE(negative_place(irrational * irrational * root(q(0))));
}

/// Beside a double zero a simple one in each direction, and a triple one, which changes the sign.
TEST(NegativePlace, BesideADoubleZero) {
  const B twice = root(q(1, 3)) * root(q(1, 3));
  const Q least = Q::from_double(0x1p-40);
  expect_between(twice * root(least), q(-1), least);
  expect_between(twice * constant(-1) * root(Q(1) - least), Q(1) - least, q(2));
  expect_between(twice * root(q(1, 3)), q(-1), q(1, 3));
  EXPECT_FALSE(negative_place(twice * root(-least)));
  EXPECT_FALSE(negative_place(twice * constant(-1) * root(Q(1) + least)));
}

TEST(NegativePlace, BetweenAZeroAndAnEnd) {
  const Q least = Q::from_double(0x1p-14);
  expect_between(constant(-1) * root(q(1)) * root(Q(1) - least) * constant(-1), Q(1) - least, q(1));
  expect_between(root(q(0)) * root(least), q(0), least);
}

TEST(NegativePlace, BetweenZerosThatAreNearlyOne) {
  const Q a = q(1, 3);
  const Q b = a + Q::from_double(0x1p-200);
  expect_between(root(a) * root(b), a, b);
  expect_between(root(a) * root(b) * root(q(1, 5)) * root(q(1, 5)), a, b);
  EXPECT_FALSE(negative_place(root(a) * root(b) * root(a) * root(b)));
}

}  // namespace
}  // namespace torse::test
