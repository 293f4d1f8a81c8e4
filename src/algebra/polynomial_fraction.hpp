// Rational functions of one variable over an exact field, always reduced: the field S(t), a scalar like any other.
//   PolynomialFraction<S>      numerator over monic denominator; + - * /, value, zero test
//   ScalarTraits<PolynomialFraction<S>>
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "torse/algebra/polynomial.hpp"

namespace torse {

/// f/g in lowest terms with monic g, so that equal functions have equal parts.
template <ExactField S>
class PolynomialFraction {
 public:
  /// Zero.
  PolynomialFraction() : den_(1) {}
  /// The constant `i`.
  template <std::integral T>
  explicit PolynomialFraction(T i) : num_(i), den_(1) {}
  /// The polynomial f.
  explicit PolynomialFraction(Polynomial<S> f) : num_(std::move(f)), den_(1) {}
  /// f/g. Throws DivisionByZero for g = 0.
  PolynomialFraction(const Polynomial<S>& f, const Polynomial<S>& g) : num_(f), den_(g) {
    if (g.zero()) throw DivisionByZero();
    if (den_.degree() > 0) {
      const Polynomial<S> common = gcd(num_, den_);
      num_ = exact_quotient(num_, common);
      den_ = exact_quotient(den_, common);
    }
    const S unit = from_int<S>(1) / den_.leading();
    num_.scale(unit);
    den_.scale(unit);
  }

  /// The function t.
  static PolynomialFraction variable() { return PolynomialFraction(Polynomial<S>::variable()); }

  const Polynomial<S>& numerator() const { return num_; }
  const Polynomial<S>& denominator() const { return den_; }
  /// The value of a constant function, none for others.
  std::optional<S> constant_value() const {
    if (den_.degree() > 0 || num_.degree() > 0) return std::nullopt;
    return num_.zero() ? from_int<S>(0) : num_.leading();
  }

  /// The value at x. Throws DivisionByZero at a pole.
  S operator()(const S& x) const {
    const S below = den_(x);
    if (definitely(is_zero(below))) throw DivisionByZero();
    return num_(x) / below;
  }

  friend PolynomialFraction operator+(const PolynomialFraction& x, const PolynomialFraction& y) {
    return PolynomialFraction(x.num_ * y.den_ + y.num_ * x.den_, x.den_ * y.den_);
  }
  friend PolynomialFraction operator-(const PolynomialFraction& x, const PolynomialFraction& y) {
    return PolynomialFraction(x.num_ * y.den_ - y.num_ * x.den_, x.den_ * y.den_);
  }
  friend PolynomialFraction operator*(const PolynomialFraction& x, const PolynomialFraction& y) {
    return PolynomialFraction(x.num_ * y.num_, x.den_ * y.den_);
  }
  /// Throws DivisionByZero for y = 0.
  friend PolynomialFraction operator/(const PolynomialFraction& x, const PolynomialFraction& y) {
    return PolynomialFraction(x.num_ * y.den_, x.den_ * y.num_);
  }
  friend PolynomialFraction operator-(PolynomialFraction x) {
    x.num_ = -std::move(x.num_);
    return x;
  }
  PolynomialFraction& operator+=(const PolynomialFraction& y) { return *this = *this + y; }
  PolynomialFraction& operator-=(const PolynomialFraction& y) { return *this = *this - y; }
  PolynomialFraction& operator*=(const PolynomialFraction& y) { return *this = *this * y; }
  PolynomialFraction& operator/=(const PolynomialFraction& y) { return *this = *this / y; }

  friend bool operator==(const PolynomialFraction& x, const PolynomialFraction& y) {
    return x.num_ == y.num_ && x.den_ == y.den_;
  }

 private:
  Polynomial<S> num_;
  Polynomial<S> den_;
};

template <ExactField S>
struct ScalarTraits<PolynomialFraction<S>> {
  static constexpr std::string_view name = "rational functions of t";
  static constexpr bool exact = true;
  static constexpr bool decided = true;
  static constexpr bool ordered = false;
  static constexpr bool prefers_reciprocal = false;

  static PolynomialFraction<S> from_int(std::int64_t i) { return PolynomialFraction<S>(i); }
  static Truth is_zero(const PolynomialFraction<S>& x) { return truth(x.numerator().zero()); }
  static std::string text(const PolynomialFraction<S>& x) {
    if (x.denominator().degree() == 0) return as_text(x.numerator());
    return '(' + as_text(x.numerator()) + ")/(" + as_text(x.denominator()) + ')';
  }
};

}  // namespace torse
