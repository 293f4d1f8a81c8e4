// The built-in floating-point scalars.
#include <cmath>
#include <cstdlib>
#include <limits>

#include "laws/laws.hpp"
#include "torse/scalar/builtin.hpp"

namespace torse::laws {

using Floating = testing::Types<float, double, long double>;
INSTANTIATE_TYPED_TEST_SUITE_P(Floating, RingLaws, Floating, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(Floating, FieldLaws, Floating, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(Floating, OrderLaws, Floating, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(Floating, RealLaws, Floating, ScalarName);

template <class S>
class FloatingScalar : public testing::Test {};
TYPED_TEST_SUITE(FloatingScalar, Floating, ScalarName);

TYPED_TEST(FloatingScalar, TextReadsBackAsTheSameValue) {
  using S = TypeParam;
  Rng rng(1);
  for (int i = 0; i < 1000; ++i) {
    const S x = std::ldexp(static_cast<S>(rng()) / 3, static_cast<int>(integer(rng, -140, 60)));
    EXPECT_EQ(static_cast<S>(std::strtold(as_text(x).c_str(), nullptr)), x);
  }
}

TYPED_TEST(FloatingScalar, PredicatesSpeakOfTheRepresentedValue) {
  using S = TypeParam;
  constexpr S nan = std::numeric_limits<S>::quiet_NaN();
  constexpr S tiny = std::numeric_limits<S>::denorm_min();
  EXPECT_EQ(is_zero(S{-0.0F}), Truth::yes);
  EXPECT_EQ(is_zero(tiny), Truth::no);
  EXPECT_EQ(is_zero(nan), Truth::no);
  EXPECT_EQ(less(nan, S{1}), Truth::no);
  EXPECT_EQ(less(S{0}, tiny), Truth::yes);
}

}  // namespace torse::laws
