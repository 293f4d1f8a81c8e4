// Float128: the laws, and every operation against BigFloat<113>, bit by bit.
#include "torse/exact/bigfloat/float128.hpp"

#include <cmath>

#include "laws/laws.hpp"
#include "torse/exact/bigfloat/bigfloat.hpp"

namespace torse::laws {

INSTANTIATE_TYPED_TEST_SUITE_P(Float128, RingLaws, Float128, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(Float128, FieldLaws, Float128, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(Float128, OrderLaws, Float128, ScalarName);

TEST(Float128, RoundsLikeBigFloatOf113Bits) {
  using Big = BigFloat<113>;
  Rng rng(1);
  const auto full = [&](auto like) {  // 113 random bits or so
    using S = decltype(like);
    Rng same(rng);
    S x = S::from_double(std::ldexp(static_cast<double>(same() >> 11), -53));
    x += S::from_double(std::ldexp(static_cast<double>(same() >> 11), -106));
    return x + S::from_double(std::ldexp(static_cast<double>(same() >> 11), -113));
  };
  for (int i = 0; i < 1000; ++i) {
    const Float128 a = full(Float128());
    const Big big_a = full(Big());
    for (int skip = 0; skip < 3; ++skip) static_cast<void>(rng());
    const Float128 b = full(Float128());
    const Big big_b = full(Big());
    for (int skip = 0; skip < 3; ++skip) static_cast<void>(rng());
    ASSERT_EQ(a.to_rational(), big_a.to_rational());
    EXPECT_EQ((a + b).to_rational(), (big_a + big_b).to_rational());
    EXPECT_EQ((a - b).to_rational(), (big_a - big_b).to_rational());
    EXPECT_EQ((a * b).to_rational(), (big_a * big_b).to_rational());
    if (definitely(is_zero(b))) continue;
    EXPECT_EQ((a / b).to_rational(), (big_a / big_b).to_rational());
    EXPECT_EQ(a < b, big_a < big_b);
  }
}

TEST(Float128, InfinitiesAreNoNumbers) {
  const Float128 infinity = Float128(1) / Float128(0);
  EXPECT_FALSE(infinity.finite());
  EXPECT_FALSE((infinity - infinity).finite());
  EXPECT_TRUE(Float128(7).finite());
  EXPECT_THROW(infinity.to_rational(), InvalidInput);
}

TEST(Float128, FractionsBelowTheRangeOfDoubleAreRefused) {
  const Rational unit = Rational::from_double(0x1p-1000);
  const Float128 tiny = Float128(1) / Float128(std::int64_t{1} << 60);
  Float128 x(1);
  Rational exact(1);
  for (int i = 0; i < 17; ++i) {  // 2^-1020
    x *= tiny;
    exact = exact / Rational(std::int64_t{1} << 60);
  }
  EXPECT_EQ(x.to_rational(), exact);
  EXPECT_LT(exact, unit);
  EXPECT_THROW((x * tiny).to_rational(), InvalidInput);
}

}  // namespace torse::laws
