// The exact stage's parts: limits of quotients with known roots, scales of tiny quotients, costs counted by hand.
#include <gtest/gtest.h>

#include <cstdlib>
#include <utility>
#include <vector>

#include "torse/exact/warp/exact_cost.hpp"
#include "torse/exact/warp/exact_quotients.hpp"

namespace torse {
namespace {

using Q = Rational;
using Form = BinaryForm<Q>;

Q q(const char* text) { return Q::from_text(text); }
Q power_of_two(int e) {
  Q x(1);
  for (int i = 0; i < std::abs(e); ++i) x = e < 0 ? x / Q(2) : x * Q(2);
  return x;
}

/// sum of g_i s^(m-i) t^i.
Form form(std::vector<Q> g) { return Form(std::move(g)); }

/// A quotient below 2/3 by g / D with D = (s + t)^m.
SineForms<Q> below_two_thirds(const Form& gap) {
  Form denominator = form({Q(1)});
  for (int i = 0; i < gap.degree(); ++i) denominator = denominator * form({Q(1), Q(1)});
  return {q("2/3") * denominator - gap, denominator};
}

bool found_nowhere_above(const Form& gap) { return nowhere_above(below_two_thirds(gap), q("2/3")); }

TEST(NowhereAbove, ByTheSignBetweenTheRoots) {
  const Form linear = form({Q(-1), Q(1)});                               // t - s
  EXPECT_TRUE(found_nowhere_above(form({Q(0), Q(0)})));                  // equal everywhere
  EXPECT_TRUE(found_nowhere_above(form({Q(1), Q(1), Q(1)})));            // below everywhere
  EXPECT_TRUE(found_nowhere_above(linear * linear));                     // touches at 1/2
  EXPECT_TRUE(found_nowhere_above(form({Q(0), Q(1), Q(0)})));            // at both ends only
  EXPECT_TRUE(found_nowhere_above(form({Q(2), Q(3), Q(1)})));            // equal at negative parameters only
  EXPECT_FALSE(found_nowhere_above(form({Q(-1), Q(-1), Q(-1)})));        // above everywhere
  EXPECT_FALSE(found_nowhere_above(linear));                             // above before the root
  EXPECT_FALSE(found_nowhere_above(Q(-1) * linear));                     // above after it
  EXPECT_FALSE(found_nowhere_above(form({Q(0), Q(-1), Q(0)})));          // above but for the ends
  EXPECT_FALSE(found_nowhere_above(form({Q(2), Q(-3), Q(1)})));          // above between two roots
  EXPECT_FALSE(found_nowhere_above(Q(-1) * form({Q(2), Q(-3), Q(1)})));  // above outside them
  EXPECT_TRUE(nowhere_above({form({Q(1)}), form({Q(2)})}, q("1/2")));    // constants
  EXPECT_FALSE(nowhere_above({form({Q(1)}), form({Q(2)})}, q("49/100")));
}

/// (x - 1/2)(x^2 - 1/4 - 2^-h): negative between 1/2 and an irrational root at about 1/2 + 2^-h only.
TEST(NowhereAbove, BetweenRootsThatNearlyMeet) {
  for (const int h : {10, 30, 200}) {
    const Form narrow = form({q("-1/2"), Q(1)}) * form({Q(-1) * (q("1/4") + power_of_two(-h)), Q(0), Q(1)});
    EXPECT_FALSE(found_nowhere_above(narrow)) << h;
    EXPECT_TRUE(found_nowhere_above(narrow * narrow)) << h;
  }
}

/// (x^2 - 2)(x^2 - 2 - 2^-h): both roots irrational, so that there is a gap between two intervals to be tested.
TEST(NowhereAbove, BetweenIrrationalRoots) {
  for (int h = 1; h <= 40; ++h) {
    const Form near_root = form({Q(-2), Q(0), Q(1)}) * form({Q(-2) - power_of_two(-h), Q(0), Q(1)});
    EXPECT_FALSE(found_nowhere_above(near_root)) << h;
    EXPECT_FALSE(found_nowhere_above(Q(-1) * near_root)) << h;
    EXPECT_TRUE(found_nowhere_above(near_root * near_root)) << h;
  }
}

TEST(ScaleFor, BringsTheLargestQuotientNearOne) {
  const auto quotient = [](int e) { return SineForms<Q>{form({Q(0), power_of_two(e)}), form({Q(1), Q(1)})}; };
  const SineForms<Q> zero{form({Q(0), Q(0)}), form({Q(1), Q(1)})};
  EXPECT_EQ(scale_for({quotient(-2000)}), 1000);
  EXPECT_EQ(scale_for({quotient(-3000), quotient(-2000), zero}), 1000);
  EXPECT_EQ(scale_for({quotient(-799), quotient(-2000)}), 0);
  EXPECT_EQ(scale_for({quotient(-800)}), 400);
  EXPECT_EQ(scale_for({quotient(-802)}), 401);
  EXPECT_EQ(scale_for({zero}), 0);
  EXPECT_EQ(scale_for({}), 0);
  const SineForms<Q> large_denominator{form({Q(1), Q(3)}), form({Q(1), power_of_two(2001)})};
  EXPECT_EQ(scale_for({large_denominator}), 1000);
}

TEST(Scaled, TheNumeratorAlone) {
  const SineForms<Q> quotient{form({Q(3), Q(5)}), form({Q(7), Q(11)})};
  for (const auto& [exponent, power] : {std::pair(0L, "1"), std::pair(3L, "64"), std::pair(-2L, "1/16")}) {
    const SineForms<Q> found = scaled(quotient, exponent);
    EXPECT_EQ(found.numerator[0], Q(3) * q(power));
    EXPECT_EQ(found.numerator[1], Q(5) * q(power));
    EXPECT_EQ(found.denominator[0], Q(7));
    EXPECT_EQ(found.denominator[1], Q(11));
  }
}

TEST(WithIntegers, OneFactorForAllComponents) {
  const FormVector<Q> found = with_integers({form({q("1/2"), Q(1)}), form({q("-2/3"), Q(0)}), form({Q(5), Q(5)})});
  EXPECT_EQ(found[0][0], Q(3));
  EXPECT_EQ(found[0][1], Q(6));
  EXPECT_EQ(found[1][0], Q(-4));
  EXPECT_EQ(found[1][1], Q(0));
  EXPECT_EQ(found[2][1], Q(30));
}

template <int D>
Surface<Q, D> strip(int pieces, const Q& entry) {
  std::vector<Q> knots;
  for (int k = 0; k <= pieces; ++k) knots.emplace_back(k);
  Vec<Q, D> x;
  for (int j = 0; j < D; ++j) x[j] = entry;
  const std::vector<Vec<Q, D>> row(static_cast<std::size_t>(pieces) + 1, x);
  return {KnotList<Q>(1, std::move(knots)), row, row};
}

/// Points (5, 5, 5): numerators of 3 bits, 12 denominators of 1 bit, 5^2 products of the quotient's degree 4.
TEST(ExactWork, CountsProductsTimesBits) {
  EXPECT_EQ((exact_work<3>(strip<3>(1, Q(5)), {1})), (4 * 3 + 3 * 12 + 64) * 25.0);
  EXPECT_EQ((exact_work<3>(strip<3>(4, Q(5)), {2, 4})), 2 * (4 * 3 + 3 * 12 + 64) * 25.0);
  EXPECT_EQ((exact_work<3>(strip<3>(1, q("5/4")), {1})), (4 * 3 + 3 * 36 + 64) * 25.0);
  EXPECT_EQ((exact_work<4>(strip<4>(1, Q(5)), {1})), 2 * (4 * 3 + 3 * 16 + 64) * 81.0);
}

TEST(ExactCost, GrowsWithTheLongestNumber) {
  EXPECT_EQ((exact_cost<3>(strip<3>(1, Q(5)))), 3000);
  EXPECT_EQ((exact_cost<3>(strip<3>(1, power_of_two(510)))), 3000);
  EXPECT_EQ((exact_cost<3>(strip<3>(1, power_of_two(1022)))), 6000);
  EXPECT_EQ((exact_cost<3>(strip<3>(1, power_of_two(-1022)))), 6000);
  Surface<Q, 4> one = strip<4>(1, Q(5));
  one.d[1][3] = power_of_two(1022);
  EXPECT_EQ(exact_cost<4>(one), 6000);
}

}  // namespace
}  // namespace torse
