// Real intervals with double ends, rounded outwards without touching the rounding mode.
//   lower_sum, lower_product, lower_quotient, lower_root, upper_root     doubles on one side of the exact result
//   Interval                                                             a real field with three-valued predicates
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "torse/scalar/builtin.hpp"
#include "torse/scalar/errors.hpp"

namespace torse {

namespace detail {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// Below this the error of a product may itself underflow.
inline constexpr double tiny_result = 0x1p-960;

inline double next_below(double x) { return std::nextafter(x, -infinity); }

/// A lower bound of the exact result from the rounded one and the sign of what is missing. An overflow of finite
/// operands exceeds the largest double.
inline double below(double rounded, double missing) {
  if (rounded == infinity) return std::numeric_limits<double>::max();
  return missing < 0 ? next_below(rounded) : rounded;
}

inline bool negligible(double x) { return std::abs(x) < tiny_result; }

}  // namespace detail

/// a + b rounded down; neither is +infinity. The error of the rounded sum is exact (Knuth's two-sum).
inline double lower_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  return detail::below(sum, (a - (sum - b_part)) + (b - b_part));
}

/// a b rounded down; the product with zero is zero.
inline double lower_product(double a, double b) {
  if (a == 0 || b == 0) return 0;
  if (std::isinf(a) || std::isinf(b)) return a * b;
  const double product = a * b;
  return detail::below(product, detail::negligible(product) ? -1.0 : std::fma(a, b, -product));
}

/// a / b rounded down, b not zero; -infinity where both are infinite.
inline double lower_quotient(double a, double b) {
  if (a == 0) return 0;
  if (std::isinf(b)) return std::isinf(a) ? -detail::infinity : detail::next_below(0);
  if (std::isinf(a)) return a / b;
  const double quotient = a / b;
  if (detail::negligible(quotient) || detail::negligible(a)) return detail::below(quotient, -1.0);
  const double rest = std::fma(-quotient, b, a);
  return detail::below(quotient, b > 0 ? rest : -rest);
}

/// The square root of a >= 0 rounded down and up.
inline double lower_root(double a) {
  const double root = std::sqrt(a);
  if (a == 0 || std::isinf(a)) return root;
  return detail::below(root, detail::negligible(a) ? -1.0 : std::fma(-root, root, a));
}
inline double upper_root(double a) {
  const double root = std::sqrt(a);
  if (a == 0 || std::isinf(a)) return root;
  return -detail::below(-root, detail::negligible(a) ? -1.0 : std::fma(root, root, -a));
}

/// The real numbers between two doubles, of which the lower may be -infinity and the upper +infinity. Every operation
/// contains the exact results for all elements of its operands. Division by an interval around zero gives the whole
/// line, division by exactly zero throws DivisionByZero.
class Interval {
 public:
  /// Exactly zero.
  Interval() = default;

  /// The integer i.
  template <std::integral T>
  explicit Interval(T i) : Interval(hull(static_cast<double>(i), static_cast<double>(i))) {
    constexpr double exact = 0x1p53;
    if (std::abs(lower_) >= exact) *this = hull(detail::next_below(lower_), -detail::next_below(-upper_));
  }

  /// The interval from `lower` to `upper`. Throws InvalidInput unless lower <= upper with at least one number between.
  static Interval hull(double lower, double upper) {
    if (!(lower <= upper) || lower == detail::infinity || upper == -detail::infinity) {
      throw InvalidInput("interval", "expected ends in increasing order");
    }
    return raw(lower, upper);
  }

  /// The value of a finite double.
  static Interval point(double x) { return hull(x, x); }

  /// All numbers.
  static Interval line() { return raw(-detail::infinity, detail::infinity); }

  /// The ends; one that is zero is +0.
  double lower() const { return lower_ + 0.0; }
  double upper() const { return upper_ + 0.0; }
  bool contains(double x) const { return lower_ <= x && x <= upper_; }

  friend Interval operator+(const Interval& x, const Interval& y) {
    return raw(lower_sum(x.lower_, y.lower_), -lower_sum(-x.upper_, -y.upper_));
  }
  friend Interval operator-(const Interval& x) { return raw(-x.upper_, -x.lower_); }
  friend Interval operator-(const Interval& x, const Interval& y) { return x + -y; }

  friend Interval operator*(const Interval& x, const Interval& y) {
    return raw(std::min({lower_product(x.lower_, y.lower_), lower_product(x.lower_, y.upper_),
                         lower_product(x.upper_, y.lower_), lower_product(x.upper_, y.upper_)}),
               -std::min({lower_product(-x.lower_, y.lower_), lower_product(-x.lower_, y.upper_),
                          lower_product(-x.upper_, y.lower_), lower_product(-x.upper_, y.upper_)}));
  }

  friend Interval operator/(const Interval& x, const Interval& y) {
    if (y.lower_ == 0 && y.upper_ == 0) throw DivisionByZero();
    if (y.contains(0)) return line();
    return raw(std::min({lower_quotient(x.lower_, y.lower_), lower_quotient(x.lower_, y.upper_),
                         lower_quotient(x.upper_, y.lower_), lower_quotient(x.upper_, y.upper_)}),
               -std::min({lower_quotient(-x.lower_, y.lower_), lower_quotient(-x.lower_, y.upper_),
                          lower_quotient(-x.upper_, y.lower_), lower_quotient(-x.upper_, y.upper_)}));
  }

  Interval& operator+=(const Interval& x) { return *this = *this + x; }
  Interval& operator-=(const Interval& x) { return *this = *this - x; }
  Interval& operator*=(const Interval& x) { return *this = *this * x; }
  Interval& operator/=(const Interval& x) { return *this = *this / x; }

 private:
  static Interval raw(double lower, double upper) {
    Interval x;
    x.lower_ = lower;
    x.upper_ = upper;
    return x;
  }

  double lower_ = 0;
  double upper_ = 0;
};

template <>
struct ScalarTraits<Interval> {
  static constexpr std::string_view name = "interval";
  static constexpr bool exact = false;
  static constexpr bool decided = false;
  static constexpr bool ordered = true;
  static constexpr bool prefers_reciprocal = false;

  static Interval from_int(std::int64_t i) { return Interval(i); }
  static Truth is_zero(const Interval& x) {
    if (!x.contains(0)) return Truth::no;
    return x.lower() == x.upper() ? Truth::yes : Truth::unknown;
  }
  static Truth less(const Interval& x, const Interval& y) {
    if (x.upper() < y.lower()) return Truth::yes;
    return x.lower() >= y.upper() ? Truth::no : Truth::unknown;
  }
  /// The whole line where x contains a negative number.
  static Interval sqrt(const Interval& x) {
    if (x.lower() < 0) return Interval::line();
    return Interval::hull(lower_root(x.lower()), upper_root(x.upper()));
  }
  static std::string text(const Interval& x) {
    return '[' + ScalarTraits<double>::text(x.lower()) + ", " + ScalarTraits<double>::text(x.upper()) + ']';
  }
};

}  // namespace torse
