// IEEE 754 binary128 as the compiler computes it, 113 bits.
//   Float128                  + - * /, comparison
//   ScalarTraits<Float128>
// BigFloat<113> rounds alike and shares no code with it: each is a test of the other.
#pragma once

#include <compare>
#include <concepts>
#include <string>
#include <string_view>

#include "torse/exact/rational/rational.hpp"
#include "torse/scalar/errors.hpp"
#include "torse/scalar/traits.hpp"

namespace torse {

/// A number of the compiler's type with 113 bits. Nothing converts to it but integers, explicitly, and the named
/// `from_double`. Division by zero follows IEEE 754.
class Float128 {
 public:
  __extension__ typedef __float128 Raw;
  static constexpr int precision = 113;

  /// Zero.
  Float128() = default;

  /// The integer `i`, rounded.
  template <std::integral T>
  explicit Float128(T i) : value_(static_cast<Raw>(i)) {}

  /// The value of `x`.
  static Float128 from_double(double x) { return raw(static_cast<Raw>(x)); }

  /// Whether it is a number, not an infinity or NaN.
  bool finite() const { return value_ - value_ == Raw(0); }

  /// The nearest double.
  double to_double() const { return static_cast<double>(value_); }

  /// The exact value. Throws InvalidInput for NaN and infinities, and beyond the range of double.
  Rational to_rational() const {
    Rational value;
    for (Raw rest = value_; rest != Raw(0);) {
      const double part = static_cast<double>(rest);
      value += Rational::from_double(part);
      if (part == 0) throw InvalidInput("number", "expected one in the range of double");
      rest -= static_cast<Raw>(part);
    }
    return value;
  }

  Float128& operator+=(const Float128& b) { return *this = *this + b; }
  Float128& operator-=(const Float128& b) { return *this = *this - b; }
  Float128& operator*=(const Float128& b) { return *this = *this * b; }
  Float128& operator/=(const Float128& b) { return *this = *this / b; }

  friend Float128 operator+(const Float128& a, const Float128& b) { return raw(a.value_ + b.value_); }
  friend Float128 operator-(const Float128& a, const Float128& b) { return raw(a.value_ - b.value_); }
  friend Float128 operator*(const Float128& a, const Float128& b) { return raw(a.value_ * b.value_); }
  friend Float128 operator/(const Float128& a, const Float128& b) { return raw(a.value_ / b.value_); }
  friend Float128 operator-(const Float128& a) { return raw(-a.value_); }

  friend bool operator==(const Float128& a, const Float128& b) { return a.value_ == b.value_; }
  friend std::partial_ordering operator<=>(const Float128& a, const Float128& b) {
    if (a.value_ < b.value_) return std::partial_ordering::less;
    if (a.value_ > b.value_) return std::partial_ordering::greater;
    return a.value_ == b.value_ ? std::partial_ordering::equivalent : std::partial_ordering::unordered;
  }

 private:
  static Float128 raw(Raw value) {
    Float128 x;
    x.value_ = value;
    return x;
  }

  Raw value_ = 0;
};

template <>
struct ScalarTraits<Float128> {
  static constexpr std::string_view name = "float128";
  static constexpr bool exact = false;
  static constexpr bool decided = true;
  static constexpr bool ordered = true;
  static constexpr bool prefers_reciprocal = false;

  static Float128 from_int(std::int64_t i) { return Float128(i); }
  static Truth is_zero(const Float128& x) { return truth(x == Float128()); }
  static Truth less(const Float128& x, const Float128& y) { return truth(x < y); }
  /// Of the nearest double: for messages.
  static std::string text(const Float128& x) { return std::to_string(x.to_double()); }
};

}  // namespace torse
