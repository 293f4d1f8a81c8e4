// The laws of the concept ladder, written once over a scalar S, one GoogleTest suite a rung:
//   RingLaws, FieldLaws, OrderLaws, RealLaws
// A test file runs them on its scalars by
//   INSTANTIATE_TYPED_TEST_SUITE_P(Rational, RingLaws, testing::Types<Rational>, ScalarName);
// The laws hold for elements drawn from Samples<S>; for floating scalars those are small dyadic numbers, for which no
// operation rounds, so that every law is an equality.
#pragma once

#include <gtest/gtest.h>

#include <cctype>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "laws/samples.hpp"
#include "torse/scalar/concepts.hpp"
#include "torse/scalar/errors.hpp"

namespace torse::laws {

/// Whether a = b, as far as S decides it.
template <class S>
testing::AssertionResult same(const S& a, const S& b) {
  const Truth t = equal(a, b);
  if (Samples<S>::decided ? definitely(t) : possibly(t)) return testing::AssertionSuccess();
  return testing::AssertionFailure() << as_text(a) << " is not " << as_text(b);
}

/// The scalar's name in the names of its tests.
struct ScalarName {
  template <class S>
  static std::string GetName(int) {
    std::string name;
    for (const char c : ScalarTraits<S>::name) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return name;
  }
};

template <class S>
class Laws : public testing::Test {
 protected:
  static S zero() { return from_int<S>(0); }
  static S one() { return from_int<S>(1); }
  S any() { return Samples<S>::any(rng_); }
  S unit() { return Samples<S>::unit(rng_); }

  /// Calls law(a, b, c) for three elements, again and again until it fails.
  template <class Law>
  void for_any(Law law) {
    for (int i = 0; i < Samples<S>::rounds && !this->HasFailure(); ++i) {
      const S a = any(), b = any(), c = any();
      SCOPED_TRACE("a = " + as_text(a) + ", b = " + as_text(b) + ", c = " + as_text(c));
      law(a, b, c);
    }
  }

  /// Calls law(a, b, u, v) for two elements and two invertible ones.
  template <class Law>
  void for_units(Law law) {
    for (int i = 0; i < Samples<S>::rounds && !this->HasFailure(); ++i) {
      const S a = any(), b = any(), u = unit(), v = unit();
      SCOPED_TRACE("a = " + as_text(a) + ", b = " + as_text(b) + ", u = " + as_text(u) + ", v = " + as_text(v));
      law(a, b, u, v);
    }
  }

  /// Calls law(i, j) for two integers.
  template <class Law>
  void for_integers(Law law) {
    for (int i = 0; i < Samples<S>::rounds && !this->HasFailure(); ++i) {
      const std::int64_t j = integer(rng_, -1000, 1000), k = integer(rng_, -1000, 1000);
      SCOPED_TRACE(std::to_string(j) + ", " + std::to_string(k));
      law(j, k);
    }
  }

  Rng rng_{2007};
};

template <Ring S>
class RingLaws : public Laws<S> {};
template <Field S>
class FieldLaws : public Laws<S> {};
template <OrderedField S>
class OrderLaws : public Laws<S> {};
template <RealField S>
class RealLaws : public Laws<S> {};

TYPED_TEST_SUITE_P(RingLaws);

TYPED_TEST_P(RingLaws, Addition) {
  using S = TypeParam;
  this->for_any([&](const S& a, const S& b, const S& c) {
    EXPECT_TRUE(same<S>(a + b, b + a));
    EXPECT_TRUE(same<S>((a + b) + c, a + (b + c)));
    EXPECT_TRUE(same<S>(a + this->zero(), a));
    EXPECT_TRUE(same<S>(a - b, a + (-b)));
    EXPECT_TRUE(same<S>((a - b) + b, a));
    EXPECT_TRUE(same<S>(-(-a), a));
    EXPECT_TRUE(definitely(is_zero(S(a - a))) || !Samples<S>::decided);
  });
}

TYPED_TEST_P(RingLaws, Multiplication) {
  using S = TypeParam;
  this->for_any([&](const S& a, const S& b, const S& c) {
    EXPECT_TRUE(same<S>(a * b, b * a));
    EXPECT_TRUE(same<S>((a * b) * c, a * (b * c)));
    EXPECT_TRUE(same<S>(a * this->one(), a));
    EXPECT_TRUE(same<S>(a * this->zero(), this->zero()));
    EXPECT_TRUE(same<S>(a * (b + c), a * b + a * c));
    EXPECT_TRUE(same<S>((-a) * b, -(a * b)));
  });
}

TYPED_TEST_P(RingLaws, CompoundAssignment) {
  using S = TypeParam;
  this->for_any([&](const S& a, const S& b, const S& c) {
    S y = a;
    EXPECT_TRUE(same<S>(y += b, a + b));
    EXPECT_TRUE(same<S>(y -= c, (a + b) - c));
    EXPECT_TRUE(same<S>(y *= b, ((a + b) - c) * b));
    y = a;
    EXPECT_TRUE(same<S>(y += y, a + a));
    y = a;
    EXPECT_TRUE(same<S>(y *= y, a * a));
    y = a;
    EXPECT_TRUE(same<S>(y -= y, this->zero()));
  });
}

TYPED_TEST_P(RingLaws, AddProduct) {
  using S = TypeParam;
  this->for_any([](const S& a, const S& b, const S& c) {
    S y = c;
    add_product(y, a, b);
    EXPECT_TRUE(same<S>(y, c + a * b));
    y = a;
    add_product(y, y, b);
    EXPECT_TRUE(same<S>(y, a + a * b));
    y = a;
    add_product(y, b, y);
    EXPECT_TRUE(same<S>(y, a + b * a));
    y = a;
    add_product(y, y, y);
    EXPECT_TRUE(same<S>(y, a + a * a));
  });
}

TYPED_TEST_P(RingLaws, ValuesAreIndependent) {
  using S = TypeParam;
  this->for_any([](const S& a, const S& b, const S&) {
    S x = a;
    S y = x;
    y += b;
    EXPECT_TRUE(same<S>(x, a));
    const S moved = std::move(x);
    EXPECT_TRUE(same<S>(moved, a));
    x = b;
    EXPECT_TRUE(same<S>(x, b));
    const S& alias = x;
    x = alias;
    EXPECT_TRUE(same<S>(x, b));
    std::swap(x, y);
    EXPECT_TRUE(same<S>(x, a + b));
    EXPECT_TRUE(same<S>(y, b));
  });
}

TYPED_TEST_P(RingLaws, TemporariesChangeNothing) {
  using S = TypeParam;
  this->for_any([](const S& a, const S& b, const S&) {
    EXPECT_TRUE(same<S>(S(a) + b, a + b));
    EXPECT_TRUE(same<S>(a + S(b), a + b));
    EXPECT_TRUE(same<S>(S(a) + S(b), a + b));
    EXPECT_TRUE(same<S>(S(a) - b, a - b));
    EXPECT_TRUE(same<S>(a - S(b), a - b));
    EXPECT_TRUE(same<S>(S(a) - S(b), a - b));
    EXPECT_TRUE(same<S>(S(a) * b, a * b));
    EXPECT_TRUE(same<S>(a * S(b), a * b));
    EXPECT_TRUE(same<S>(S(a) * S(b), a * b));
    EXPECT_TRUE(same<S>(-S(a), -a));
  });
}

TYPED_TEST_P(RingLaws, Integers) {
  using S = TypeParam;
  this->for_integers([](std::int64_t i, std::int64_t j) {
    EXPECT_TRUE(same<S>(from_int<S>(i) + from_int<S>(j), from_int<S>(i + j)));
    EXPECT_TRUE(same<S>(from_int<S>(i) - from_int<S>(j), from_int<S>(i - j)));
    EXPECT_TRUE(same<S>(from_int<S>(i) * from_int<S>(j), from_int<S>(i * j)));
    EXPECT_TRUE(same<S>(S(i), from_int<S>(i)));
    EXPECT_EQ(is_zero(from_int<S>(i)), truth(i == 0));
  });
}

TYPED_TEST_P(RingLaws, ExtremeIntegers) {
  using S = TypeParam;
  constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min();
  constexpr std::int64_t largest = std::numeric_limits<std::int64_t>::max();
  EXPECT_EQ(is_zero(from_int<S>(largest)), Truth::no);
  EXPECT_EQ(is_zero(from_int<S>(least)), Truth::no);
  if constexpr (ScalarTraits<S>::exact) {
    EXPECT_TRUE(same<S>(from_int<S>(largest) - from_int<S>(largest - 1), this->one()));
    EXPECT_TRUE(same<S>(from_int<S>(least) + from_int<S>(largest), -this->one()));
  }
}

TYPED_TEST_P(RingLaws, DefaultIsZero) {
  using S = TypeParam;
  EXPECT_EQ(is_zero(S()), Truth::yes);
  EXPECT_TRUE(same<S>(S() + this->one(), this->one()));
}

TYPED_TEST_P(RingLaws, Text) {
  using S = TypeParam;
  EXPECT_FALSE(as_text(S()).empty());
  EXPECT_NE(as_text(this->zero()), as_text(this->one()));
  EXPECT_FALSE(std::string(ScalarTraits<S>::name).empty());
}

REGISTER_TYPED_TEST_SUITE_P(RingLaws, Addition, Multiplication, CompoundAssignment, AddProduct, ValuesAreIndependent,
                            TemporariesChangeNothing, Integers, ExtremeIntegers, DefaultIsZero, Text);

TYPED_TEST_SUITE_P(FieldLaws);

TYPED_TEST_P(FieldLaws, Division) {
  using S = TypeParam;
  this->for_units([&](const S& a, const S& b, const S& u, const S& v) {
    EXPECT_TRUE(same<S>((a / u) * u, a));
    EXPECT_TRUE(same<S>((a * u) / u, a));
    EXPECT_TRUE(same<S>(u / u, this->one()));
    EXPECT_TRUE(same<S>(a / this->one(), a));
    EXPECT_TRUE(same<S>(a / u, a * (this->one() / u)));
    EXPECT_TRUE(same<S>((a / u) / v, a / (u * v)));
    EXPECT_TRUE(same<S>(a / u + b / v, (a * v + b * u) / (u * v)));
    EXPECT_TRUE(same<S>((-a) / u, a / (-u)));
    EXPECT_TRUE(same<S>(this->zero() / u, this->zero()));
  });
}

TYPED_TEST_P(FieldLaws, DivisionInPlaceAndOfTemporaries) {
  using S = TypeParam;
  this->for_units([&](const S& a, const S&, const S& u, const S&) {
    S y = a;
    EXPECT_TRUE(same<S>(y /= u, a / u));
    y = u;
    EXPECT_TRUE(same<S>(y /= y, this->one()));
    EXPECT_TRUE(same<S>(S(a) / u, a / u));
    EXPECT_TRUE(same<S>(a / S(u), a / u));
    EXPECT_TRUE(same<S>(S(a) / S(u), a / u));
  });
}

TYPED_TEST_P(FieldLaws, Ratios) {
  using S = TypeParam;
  EXPECT_TRUE(same<S>(ratio<S>(1, 2) + ratio<S>(1, 2), this->one()));
  EXPECT_TRUE(same<S>(ratio<S>(-3, 4) * from_int<S>(4), from_int<S>(-3)));
  EXPECT_TRUE(same<S>(ratio<S>(6, -8), ratio<S>(-3, 4)));
  const Truth half_is_quarter = equal(ratio<S>(1, 2), ratio<S>(1, 4));
  EXPECT_FALSE(Samples<S>::decided ? possibly(half_is_quarter) : definitely(half_is_quarter));
}

TYPED_TEST_P(FieldLaws, DivisionByZeroThrows) {
  using S = TypeParam;
  if constexpr (Samples<S>::throws_on_zero) {
    this->for_any([&](const S& a, const S& b, const S&) {
      S y = a;
      EXPECT_THROW(static_cast<void>(a / (b * this->zero())), DivisionByZero);
      EXPECT_THROW(y /= this->zero(), DivisionByZero);
      EXPECT_TRUE(same<S>(y, a));
    });
  } else {
    EXPECT_NO_THROW(static_cast<void>(this->one() / this->zero()));
  }
}

REGISTER_TYPED_TEST_SUITE_P(FieldLaws, Division, DivisionInPlaceAndOfTemporaries, Ratios, DivisionByZeroThrows);

TYPED_TEST_SUITE_P(OrderLaws);

TYPED_TEST_P(OrderLaws, Trichotomy) {
  using S = TypeParam;
  this->for_any([](const S& a, const S& b, const S& c) {
    EXPECT_EQ(definitely(less(a, b)) + definitely(less(b, a)) + definitely(equal(a, b)), 1);
    EXPECT_FALSE(definitely(less(a, a)));
    if (definitely(less(a, b) & less(b, c))) {
      EXPECT_TRUE(definitely(less(a, c)));
    }
  });
}

TYPED_TEST_P(OrderLaws, AgreesWithArithmetic) {
  using S = TypeParam;
  this->for_any([&](const S& a, const S& b, const S& c) {
    EXPECT_EQ(less(a, b), less(S(a + c), S(b + c)));
    EXPECT_EQ(less(a, b), less(S(-b), S(-a)));
    if (definitely(less(this->zero(), c))) {
      EXPECT_EQ(less(a, b), less(S(a * c), S(b * c)));
    }
    EXPECT_FALSE(possibly(less(S(a * a), this->zero())));
  });
}

TYPED_TEST_P(OrderLaws, Integers) {
  using S = TypeParam;
  this->for_integers([](std::int64_t i, std::int64_t j) {
    EXPECT_EQ(less(from_int<S>(i), from_int<S>(j)), truth(i < j));
    if (i != 0 && j != 0) {
      EXPECT_EQ(less(ratio<S>(1, i), ratio<S>(1, j)), truth(i * j > 0 ? j < i : i < j));
    }
  });
}

REGISTER_TYPED_TEST_SUITE_P(OrderLaws, Trichotomy, AgreesWithArithmetic, Integers);

TYPED_TEST_SUITE_P(RealLaws);

TYPED_TEST_P(RealLaws, SquareRoots) {
  using S = TypeParam;
  this->for_any([&](const S& a, const S& b, const S&) {
    const S magnitude = definitely(less(a, this->zero())) ? S(-a) : a;
    EXPECT_TRUE(same<S>(ScalarTraits<S>::sqrt(a * a), magnitude));
    EXPECT_TRUE(
        same<S>(ScalarTraits<S>::sqrt(a * a * b * b), ScalarTraits<S>::sqrt(a * a) * ScalarTraits<S>::sqrt(b * b)));
  });
}

TYPED_TEST_P(RealLaws, SquareRootOfTwo) {
  using S = TypeParam;
  const S root = ScalarTraits<S>::sqrt(from_int<S>(2));
  EXPECT_TRUE(definitely(less(ratio<S>(141421, 100000), root)));
  EXPECT_TRUE(definitely(less(root, ratio<S>(141422, 100000))));
}

REGISTER_TYPED_TEST_SUITE_P(RealLaws, SquareRoots, SquareRootOfTwo);

// A program whose scalars reach only some rungs leaves the other suites out.
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(FieldLaws);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(OrderLaws);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(RealLaws);

}  // namespace torse::laws
