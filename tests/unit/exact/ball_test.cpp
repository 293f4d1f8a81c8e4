// Balls contain the exact values, and their predicates say no more than the balls show.
#include "torse/exact/ball/ball.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "random_program.hpp"
#include "torse/scalar/concepts.hpp"
#include "torse/scalar/errors.hpp"

namespace torse {
namespace {

template <class B>
class BallTest : public testing::Test {};
using Precisions = testing::Types<Ball<24>, Ball<64>, Ball<256>>;
TYPED_TEST_SUITE(BallTest, Precisions);

static_assert(RealField<Ball<64>>);
static_assert(!ScalarTraits<Ball<64>>::exact);

/// As many digits as the bits are worth: log10 of 2^24, 2^64 and 2^256 is 7.2, 19.3 and 77.1.
TEST(Ball, TextHasTheDigitsOfItsBits) {
  const auto begins = [](const std::string& text, std::size_t digits) {
    return text.starts_with("[0." + std::string(digits, '3') + " +/- ");
  };
  EXPECT_TRUE(begins(as_text(Ball<24>(1) / Ball<24>(3)), 7));
  EXPECT_TRUE(begins(as_text(Ball<64>(1) / Ball<64>(3)), 19));
  EXPECT_TRUE(begins(as_text(Ball<256>(1) / Ball<256>(3)), 77));
}

TYPED_TEST(BallTest, ContainsTheExactValue) {
  using B = TypeParam;
  std::mt19937_64 random(3);
  int finite = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const test::Program program = test::random_program(random, 3, 12, "+-*/");
    const std::vector<CppRational> point = test::random_point(random, 3);
    std::vector<CppRational> exact;
    std::vector<B> balls;
    try {
      exact = program.run(point);
      std::vector<B> inputs;
      for (const CppRational& value : point) inputs.push_back(B::rational(value.text()));
      balls = program.run(inputs);
    } catch (const DivisionByZero&) {
      continue;
    }
    for (std::size_t i = 0; i < exact.size(); ++i) {
      ASSERT_TRUE(balls[i].contains(exact[i].text())) << as_text(balls[i]) << " " << exact[i].text();
      if (balls[i].is_finite()) ++finite;
      if (exact[i].sign() != 0) {
        ASSERT_FALSE(definitely(is_zero(balls[i])));
      } else {
        ASSERT_TRUE(possibly(is_zero(balls[i])));
      }
      const Truth negative = less(balls[i], B(0));
      if (negative != Truth::unknown) {
        ASSERT_EQ(negative, truth(exact[i].sign() < 0));
      }
      B fused = balls[i];
      add_product(fused, balls[i], balls[0]);
      ASSERT_TRUE(fused.contains((exact[i] + exact[i] * exact[0]).text()));
    }
  }
  EXPECT_GT(finite, 3000);
}

TYPED_TEST(BallTest, RadiusFollowsPrecision) {
  using B = TypeParam;
  const B third = B::rational("1/3");
  EXPECT_FALSE(definitely(is_zero(third)));
  EXPECT_GT(third.radius(), 0);
  EXPECT_TRUE(third.contains("1/3"));
  EXPECT_NEAR(third.midpoint(), 1.0 / 3, 1e-6);
  EXPECT_EQ(B(5).radius(), 0);
  EXPECT_EQ(is_zero(third - third), Truth::unknown);
  EXPECT_EQ(is_zero(B(5) - B(5)), Truth::yes);
  EXPECT_EQ(is_zero(third), Truth::no);
}

TEST(Ball, MorePrecisionMeansSmallerRadius) {
  EXPECT_LT(Ball<256>::rational("1/3").radius(), std::ldexp(1.0, -250));
  EXPECT_LT(Ball<64>::rational("1/3").radius(), std::ldexp(1.0, -60));
  EXPECT_GT(Ball<64>::rational("1/3").radius(), std::ldexp(1.0, -70));
}

TEST(Ball, IntervalContainsItsEnds) {
  const Ball<30> x = Ball<30>::interval(0.1, 0.7);
  EXPECT_TRUE(x.contains("3602879701896397/36028797018963968"));
  EXPECT_TRUE(x.contains("3152519739159347/4503599627370496"));
  EXPECT_FALSE(x.contains("0"));
  EXPECT_FALSE(x.contains("8/10"));
  EXPECT_EQ(less(x, Ball<30>(1)), Truth::yes);
  EXPECT_EQ(less(Ball<30>(1), x), Truth::no);
  EXPECT_EQ(less(x, Ball<30>::rational("1/2")), Truth::unknown);
  EXPECT_THROW(Ball<30>::interval(1, 0), InvalidInput);
  EXPECT_THROW(Ball<30>::interval(0, std::numeric_limits<double>::infinity()), InvalidInput);
  EXPECT_THROW(Ball<30>::interval(std::nan(""), 1), InvalidInput);
  try {
    Ball<30>::interval(1, 0);
    ADD_FAILURE() << "expected an error";
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.place(), "interval");
  }
}

TEST(Ball, DivisionByABallAroundZeroIsNotFiniteAndDecidesNothing) {
  const Ball<64> around = Ball<64>::interval(-1, 1);
  const Ball<64> quotient = Ball<64>(1) / around;
  EXPECT_FALSE(quotient.is_finite());
  EXPECT_EQ(is_zero(quotient), Truth::unknown);
  EXPECT_EQ(less(quotient, Ball<64>(0)), Truth::unknown);
  EXPECT_TRUE(quotient.contains("1000000"));
  EXPECT_THROW(Ball<64>(1) / Ball<64>(0), DivisionByZero);
  EXPECT_THROW(Ball<64>::rational("1/0"), DivisionByZero);
  EXPECT_THROW(Ball<64>::rational("pi"), InvalidInput);
}

TEST(Ball, SquareRootEncloses) {
  const Ball<64> root = ScalarTraits<Ball<64>>::sqrt(Ball<64>(2));
  EXPECT_EQ(less(root, Ball<64>::rational("141421356237309505/100000000000000000")), Truth::yes);
  EXPECT_EQ(less(Ball<64>::rational("141421356237309504/100000000000000000"), root), Truth::yes);
  EXPECT_TRUE((root * root).contains("2"));
  EXPECT_FALSE(ScalarTraits<Ball<64>>::sqrt(Ball<64>(-1)).is_finite());
}

}  // namespace
}  // namespace torse
