// Running error analysis: a double beside a bound of its distance from the exact result.
//   RunningError          the value that double has, and the bound
//   ScalarTraits<RunningError>
// The local error of an operation is not estimated but computed, by Knuth's two-sum and by fused multiply-add, so that
// operations which do not round add nothing. With x = a + da, |da| <= ea, for the exact operands x, y of rounded a, b:
//   sum        |fl(a+b) - (x+y)| <= |local| + ea + eb
//   product    |fl(ab) - xy|     <= |local| + |a| eb + |b| ea + ea eb
//   quotient   |q - x/y|         <= (|a - q b| + |q| eb + ea) / (|b| - eb)        q = fl(a/b), |b| > eb
//   root       |r - sqrt x|      <= (|r^2 - a| + ea) / r                           r = fl(sqrt a), a > ea
// That the bounds, which are computed too, are none the less bounds is proved: proofs/coq/Running.v is this file line
// by line, Running_*.v have what follows for every operation, program and decision. Wilkinson, Rounding Errors in
// Algebraic Processes, 1963; Higham, Accuracy and Stability, section 3.3.
#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "torse/scalar/builtin.hpp"

namespace torse {

/// A double that an algorithm computes, bit for bit, and a bound of its error for exact inputs. The bound is infinite
/// where the value left the range of doubles or a divisor may be zero; then nothing is known. Where it is finite, no
/// divisor of the exact computation is zero and no operand of a root is negative.
class RunningError {
 public:
  /// Exactly zero.
  RunningError() = default;

  /// The integer i.
  template <std::integral T>
  explicit RunningError(T i) : value_(static_cast<double>(i)) {
    constexpr double exact = 0x1p53;  // what 2^53 + 1 rounds to as well
    if (std::abs(value_) >= exact) bound_ = std::abs(value_) * 0x1p-52;
  }

  /// The exact value of a finite double.
  static RunningError from_double(double x) { return {x, std::isfinite(x) ? 0 : unknown}; }

  double value() const { return value_; }
  double bound() const { return bound_; }

  friend RunningError operator+(const RunningError& x, const RunningError& y) {
    const double sum = x.value_ + y.value_;
    const double y_part = sum - x.value_;
    const double local = (x.value_ - (sum - y_part)) + (y.value_ - y_part);
    return {sum, rounded_up(std::abs(local) + x.bound_ + y.bound_)};
  }
  friend RunningError operator-(const RunningError& x) { return {-x.value_, x.bound_}; }
  friend RunningError operator-(const RunningError& x, const RunningError& y) { return x + -y; }

  friend RunningError operator*(const RunningError& x, const RunningError& y) {
    const double product = x.value_ * y.value_;
    if (x.is_exactly_zero() || y.is_exactly_zero()) return {product, x.bound_ + y.bound_ < unknown ? 0 : unknown};
    double bound = std::abs(std::fma(x.value_, y.value_, -product)) + lost(product);
    if (x.bound_ != 0 || y.bound_ != 0) {
      bound += std::abs(x.value_) * y.bound_ + std::abs(y.value_) * x.bound_ + x.bound_ * y.bound_ + underflow;
    }
    return {product, rounded_up(bound)};
  }

  friend RunningError operator/(const RunningError& x, const RunningError& y) {
    const double quotient = x.value_ / y.value_;
    const double divisor = (std::abs(y.value_) - y.bound_) * (1 - 0x1p-52);
    if (!(divisor > 0)) return {quotient, unknown};
    if (x.is_exactly_zero()) return {quotient, 0};
    double rest = std::abs(std::fma(-quotient, y.value_, x.value_)) + lost(x.value_) + lost(quotient);
    if (x.bound_ != 0 || y.bound_ != 0) rest += std::abs(quotient) * y.bound_ + x.bound_ + underflow;
    return {quotient, rest == 0 ? 0 : rounded_up(rest / divisor + underflow)};
  }

  RunningError& operator+=(const RunningError& x) { return *this = *this + x; }
  RunningError& operator-=(const RunningError& x) { return *this = *this - x; }
  RunningError& operator*=(const RunningError& x) { return *this = *this * x; }
  RunningError& operator/=(const RunningError& x) { return *this = *this / x; }

  /// Unknown unless the exact value is certainly not negative.
  friend RunningError root(const RunningError& x) {
    const double value = std::sqrt(x.value_);
    if (x.is_exactly_zero()) return {value, 0};
    if (!(x.value_ > x.bound_)) return {value, unknown};
    const double rest = std::abs(std::fma(value, value, -x.value_)) + lost(x.value_) + x.bound_;
    return {value, rest == 0 ? 0 : rounded_up(rest / value + underflow)};
  }

 private:
  static constexpr double unknown = std::numeric_limits<double>::infinity();
  /// More than a few roundings below the smallest normal number take away.
  static constexpr double underflow = 0x1p-1070;

  RunningError(double value, double bound) : value_(value), bound_(bound) {}

  bool is_exactly_zero() const { return value_ == 0 && bound_ == 0; }

  /// What a computed local error may lack where it underflows.
  static double lost(double result) { return std::abs(result) < 0x1p-960 ? underflow : 0; }

  /// A sum of at most eight terms, computed, made an upper bound of the exact one; unknown for NaN.
  static double rounded_up(double bound) { return bound >= 0 ? bound * (1 + 0x1p-49) : unknown; }

  double value_ = 0;
  double bound_ = 0;
};

template <>
struct ScalarTraits<RunningError> {
  static constexpr std::string_view name = "running error";
  static constexpr bool exact = false;
  static constexpr bool decided = false;
  static constexpr bool ordered = true;
  static constexpr bool prefers_reciprocal = false;

  static RunningError from_int(std::int64_t i) { return RunningError(i); }
  static Truth is_zero(const RunningError& x) {
    if (std::abs(x.value()) > x.bound()) return Truth::no;
    return x.bound() == 0 ? Truth::yes : Truth::unknown;
  }
  static Truth less(const RunningError& x, const RunningError& y) {
    const RunningError rest = y - x;
    if (is_zero(rest) != Truth::no) return is_zero(rest) == Truth::yes ? Truth::no : Truth::unknown;
    return truth(rest.value() > 0);
  }
  static RunningError sqrt(const RunningError& x) { return root(x); }
  static std::string text(const RunningError& x) {
    return ScalarTraits<double>::text(x.value()) + " +- " + ScalarTraits<double>::text(x.bound());
  }
};

}  // namespace torse
