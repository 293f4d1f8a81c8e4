// Points over scalars that divide by a reciprocal and over scalars that do not: each coordinate is divided.
#include "torse/algebra/point.hpp"

#include <gtest/gtest.h>

#include <cstdint>

#include "torse/exact/modular/zp.hpp"
#include "torse/exact/rational/rational.hpp"

namespace torse {
namespace {

TEST(Point, DivideDividesEveryCoordinate) {
  static_assert(ScalarTraits<Zp>::prefers_reciprocal && !ScalarTraits<Rational>::prefers_reciprocal);
  const Modulus modulus((std::uint64_t{1} << 62) - 57);
  const auto element = [&](int i) {
    return i < 0 ? -Zp(modulus, static_cast<std::uint64_t>(-i)) : Zp(modulus, static_cast<std::uint64_t>(i));
  };
  const Zp six = element(6);
  Vec<Zp, 3> x(element(12), element(-18), element(1));
  divide(x, six);
  EXPECT_EQ(equal(x[0], element(2)), Truth::yes);
  EXPECT_EQ(equal(x[1], element(-3)), Truth::yes);
  EXPECT_EQ(equal(Zp(x[2] * six), element(1)), Truth::yes);
  Vec<Rational, 3> y(Rational(12), Rational(-18), Rational(1));
  divide(y, Rational(6));
  EXPECT_EQ(y, (Vec<Rational, 3>(Rational(2), Rational(-3), ratio<Rational>(1, 6))));
}

}  // namespace
}  // namespace torse
