// Balls obey the laws: exactly for the dyadic numbers they hold exactly, and up to their radius for wide ones.
#include "torse/exact/ball/ball.hpp"

#include <algorithm>
#include <string>

#include "laws/laws.hpp"
#include "torse/exact/rational/rational.hpp"

namespace torse::laws {

using ExactBall = Ball<128>;
using WideBall = Ball<53>;

template <>
struct Samples<ExactBall> : DyadicSamples<ExactBall> {
  static constexpr bool throws_on_zero = true;
};

template <>
struct Samples<WideBall> : DyadicSamples<WideBall> {
  /// Equal balls with a radius are not known to be equal, only not known to differ.
  static constexpr bool decided = false;
  static constexpr bool throws_on_zero = true;

  static WideBall any(Rng& rng) {
    const double x = static_cast<double>(integer(rng, -1000, 1000)) / 7,
                 y = static_cast<double>(integer(rng, -1000, 1000)) / 9;
    return rng() % 3 == 0 ? DyadicSamples<WideBall>::any(rng) : WideBall::interval(std::min(x, y), std::max(x, y));
  }

  /// A ball without zero.
  static WideBall unit(Rng& rng) {
    const WideBall x = WideBall::interval(0.125, static_cast<double>(integer(rng, 1, 1000)) / 3);
    return rng() % 2 == 0 ? x : -x;
  }
};

INSTANTIATE_TYPED_TEST_SUITE_P(ExactBall, RingLaws, ExactBall, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(ExactBall, FieldLaws, ExactBall, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(ExactBall, OrderLaws, ExactBall, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(ExactBall, RealLaws, ExactBall, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(WideBall, RingLaws, WideBall, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(WideBall, FieldLaws, WideBall, ScalarName);

/// Whether the ball contains the rational number.
bool contains(const WideBall& ball, const Rational& x) { return ball.contains(x.text()); }

TEST(Ball, EnclosesTheExactResult) {
  Rng rng(8);
  for (int i = 0; i < 300; ++i) {
    const Rational x = FractionSamples<Rational>::unit(rng), y = FractionSamples<Rational>::unit(rng);
    const WideBall a = WideBall::rational(x.text()), b = WideBall::rational(y.text());
    EXPECT_TRUE(contains(a, x));
    EXPECT_TRUE(contains(a + b, x + y));
    EXPECT_TRUE(contains(a - b, x - y));
    EXPECT_TRUE(contains(a * b, x * y));
    EXPECT_TRUE(contains(a / b, x / y));
    EXPECT_TRUE(contains(-a, -x));
    EXPECT_FALSE(contains(a, x + x));
    if (definitely(less(a, b))) {
      EXPECT_LT(x, y);
    }
    if (definitely(is_zero(a))) ADD_FAILURE() << as_text(a);
  }
}

TEST(Ball, AWideBallDecidesNothingAboutTheZeroInside) {
  const WideBall x = WideBall::interval(-1, 2);
  EXPECT_EQ(is_zero(x), Truth::unknown);
  EXPECT_EQ(less(x, WideBall(0)), Truth::unknown);
  EXPECT_EQ(less(x, WideBall(3)), Truth::yes);
  EXPECT_EQ(less(WideBall(3), x), Truth::no);
}

}  // namespace torse::laws
