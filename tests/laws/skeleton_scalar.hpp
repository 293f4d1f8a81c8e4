// A skeleton to copy for a new scalar: all that the library asks of one, from ring to real field. It wraps a double and
// nothing more; rename it, replace the member, and leave out the rungs that your arithmetic does not reach.
//   Skeleton                  the values and + - * /
//   ScalarTraits<Skeleton>    name, predicates, text
#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

#include "torse/scalar/concepts.hpp"

namespace torse {

/// Say here what a value is, what rounds and what is thrown.
class Skeleton {
 public:
  /// Zero.
  Skeleton() = default;

  /// The integer `i`. Nothing converts implicitly, and a floating-point number not at all: std::integral refuses it.
  template <std::integral T>
  explicit Skeleton(T i) : value_(static_cast<double>(i)) {}

  // Ring. The operators return values, never references or expression templates.
  Skeleton& operator+=(const Skeleton& b) { return value_ += b.value_, *this; }
  Skeleton& operator-=(const Skeleton& b) { return value_ -= b.value_, *this; }
  Skeleton& operator*=(const Skeleton& b) { return value_ *= b.value_, *this; }
  friend Skeleton operator+(Skeleton a, const Skeleton& b) { return a += b; }
  friend Skeleton operator-(Skeleton a, const Skeleton& b) { return a -= b; }
  friend Skeleton operator*(Skeleton a, const Skeleton& b) { return a *= b; }
  friend Skeleton operator-(const Skeleton& a) { return Skeleton() - a; }
  bool is_zero() const { return value_ == 0; }
  std::string text() const { return std::to_string(value_); }

  // Field. An exact scalar throws DivisionByZero here for b = 0.
  Skeleton& operator/=(const Skeleton& b) { return value_ /= b.value_, *this; }
  friend Skeleton operator/(Skeleton a, const Skeleton& b) { return a /= b; }

  // OrderedField.
  friend bool operator<(const Skeleton& a, const Skeleton& b) { return a.value_ < b.value_; }

  // RealField.
  Skeleton square_root() const {
    Skeleton r;
    r.value_ = std::sqrt(value_);
    return r;
  }

 private:
  double value_ = 0;
};

template <>
struct ScalarTraits<Skeleton> {
  static constexpr std::string_view name = "skeleton";
  static constexpr bool exact = false;
  static constexpr bool decided = true;
  static constexpr bool ordered = true;
  static constexpr bool prefers_reciprocal = false;

  static Skeleton from_int(std::int64_t i) { return Skeleton(i); }
  static Truth is_zero(const Skeleton& x) { return truth(x.is_zero()); }
  static Truth less(const Skeleton& x, const Skeleton& y) { return truth(x < y); }
  static Skeleton sqrt(const Skeleton& x) { return x.square_root(); }
  static std::string text(const Skeleton& x) { return x.text(); }
};

static_assert(RealField<Skeleton>);

}  // namespace torse
