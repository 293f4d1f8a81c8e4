// BigFloat: the laws, and every operation against the processor's floating point and against exact rationals.
#include "torse/exact/bigfloat/bigfloat.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>

#include "laws/laws.hpp"
#include "torse/exact/rational/rational.hpp"

namespace torse::laws {

using BigFloats = testing::Types<BigFloat<53>, BigFloat<64>, BigFloat<113>, BigFloat<1000>>;
INSTANTIATE_TYPED_TEST_SUITE_P(BigFloat, RingLaws, BigFloats, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(BigFloat, FieldLaws, BigFloats, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(BigFloat, OrderLaws, BigFloats, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(BigFloat, RealLaws, BigFloats, ScalarName);

double random_double(Rng& rng) {
  return std::ldexp(static_cast<double>(rng() >> 11) - 4.5e15, static_cast<int>(integer(rng, -80, 20)));
}

TEST(BigFloat, Of53BitsIsDouble) {
  Rng rng(1);
  using B = BigFloat<53>;
  for (int i = 0; i < 2000; ++i) {
    const double x = random_double(rng), y = random_double(rng);
    const B a = B::from_double(x), b = B::from_double(y);
    EXPECT_EQ((a + b).to_double(), x + y);
    EXPECT_EQ((a - b).to_double(), x - y);
    EXPECT_EQ((a * b).to_double(), x * y);
    EXPECT_EQ((a / b).to_double(), x / y);
    EXPECT_EQ((-a).to_double(), -x);
    EXPECT_EQ(ScalarTraits<B>::sqrt(a * a + b * b).to_double(), std::sqrt(x * x + y * y));
    EXPECT_EQ(a < b, x < y);
    EXPECT_EQ(std::strtod(a.text().c_str(), nullptr), x);
  }
}

TEST(BigFloat, Of24BitsIsFloat) {
  Rng rng(2);
  using B = BigFloat<24>;
  for (int i = 0; i < 2000; ++i) {
    const auto x = static_cast<float>(random_double(rng) * 1e-6), y = static_cast<float>(random_double(rng) * 1e-6);
    const B a = B::from_double(x), b = B::from_double(y);
    EXPECT_EQ((a + b).to_double(), double{x + y});
    EXPECT_EQ((a * b).to_double(), double{x * y});
    EXPECT_EQ((a / b).to_double(), double{x / y});
  }
}

/// Whether `rounded` is within half a unit in the last of `bits` places of the exact result.
bool nearest(const Rational& rounded, const Rational& result, int bits) {
  Rational unit = result.sign() < 0 ? -result : result;
  for (int i = 0; i < bits; ++i) unit /= Rational(2);
  const Rational error = rounded - result;
  return error <= unit && -error <= unit;
}

TEST(BigFloat, RoundsTheExactResult) {
  Rng rng(3);
  using B = BigFloat<113>;
  for (int i = 0; i < 500; ++i) {
    const Rational x = FractionSamples<Rational>::unit(rng), y = FractionSamples<Rational>::unit(rng);
    const B a = B::from_rational(x), b = B::from_rational(y);
    const Rational p = a.to_rational(), q = b.to_rational();
    EXPECT_TRUE(nearest(p, x, 113));
    EXPECT_TRUE(nearest((a + b).to_rational(), p + q, 113));
    EXPECT_TRUE(nearest((a - b).to_rational(), p - q, 113));
    EXPECT_TRUE(nearest((a * b).to_rational(), p * q, 113));
    EXPECT_TRUE(nearest((a / b).to_rational(), p / q, 113));
  }
  const Rational root = ScalarTraits<B>::sqrt(B(2)).to_rational();
  EXPECT_TRUE(nearest(root * root, Rational(2), 111));
  EXPECT_FALSE(nearest(root * root, Rational(2), 125));
}

TEST(BigFloat, FollowsIeee754AtZero) {
  using B = BigFloat<113>;
  EXPECT_EQ((B(1) / B(0)).to_double(), std::numeric_limits<double>::infinity());
  const B nan = B(0) / B(0);
  EXPECT_TRUE(std::isnan(nan.to_double()));
  EXPECT_FALSE(nan == nan);
  EXPECT_EQ(is_zero(nan), Truth::no);
  EXPECT_EQ(less(nan, B(1)), Truth::no);
  EXPECT_THROW(static_cast<void>(nan.to_rational()), InvalidInput);
}

TEST(BigFloat, TextIsTheNumberAlone) {
  EXPECT_EQ(BigFloat<113>::from_double(0.375).text(), "0.375");
  EXPECT_EQ(BigFloat<24>(-7).text(), "-7");
}

TEST(BigFloat, NameTellsThePrecision) {
  EXPECT_EQ(ScalarTraits<BigFloat<2>>::name, "2 bits");
  EXPECT_EQ(ScalarTraits<BigFloat<113>>::name, "113 bits");
  EXPECT_EQ(ScalarTraits<BigFloat<12345>>::name, "12345 bits");
}

}  // namespace torse::laws
