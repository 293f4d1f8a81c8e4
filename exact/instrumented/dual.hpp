// A scalar that carries its derivatives by all inputs of a computation.
//   Dual<S>               value and gradient, by the rules of differentiation
//   ScalarTraits<Dual<S>>
// Over the rationals both are exact: what condition numbers are made of.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "torse/scalar/concepts.hpp"
#include "torse/scalar/errors.hpp"

namespace torse {

/// x with dx/dt_k for the variables t_0, t_1, ...; a gradient is as long as its last entry that may differ from zero.
template <Field S>
class Dual {
 public:
  /// The constant zero.
  Dual() : value_(from_int<S>(0)) {}
  /// The constant i.
  template <std::integral T>
  explicit Dual(T i) : value_(from_int<S>(static_cast<std::int64_t>(i))) {}

  /// The variable t_k with this value.
  static Dual variable(S value, std::size_t k) {
    Dual x;
    x.value_ = std::move(value);
    x.gradient_.assign(k + 1, from_int<S>(0));
    x.gradient_[k] = from_int<S>(1);
    return x;
  }

  const S& value() const { return value_; }
  /// dx/dt_k.
  S derivative(std::size_t k) const { return k < gradient_.size() ? gradient_[k] : from_int<S>(0); }

  Dual& operator+=(const Dual& b) {
    add_gradient(from_int<S>(1), b);
    value_ += b.value_;
    return *this;
  }
  Dual& operator-=(const Dual& b) {
    add_gradient(from_int<S>(-1), b);
    value_ -= b.value_;
    return *this;
  }
  Dual& operator*=(const Dual& b) {
    const Dual factor = b;
    scale_gradient(factor.value_);
    add_gradient(value_, factor);
    value_ *= factor.value_;
    return *this;
  }
  /// d(a/b) = (da - (a/b) db) / b. Throws DivisionByZero for b = 0.
  Dual& operator/=(const Dual& b) {
    if (definitely(is_zero(b.value_))) throw DivisionByZero();
    const Dual divisor = b;
    value_ /= divisor.value_;
    add_gradient(-value_, divisor);
    scale_gradient(from_int<S>(1) / divisor.value_);
    return *this;
  }

  friend Dual operator+(Dual a, const Dual& b) { return std::move(a += b); }
  friend Dual operator-(Dual a, const Dual& b) { return std::move(a -= b); }
  friend Dual operator*(Dual a, const Dual& b) { return std::move(a *= b); }
  friend Dual operator/(Dual a, const Dual& b) { return std::move(a /= b); }
  friend Dual operator-(const Dual& a) { return Dual() - a; }

 private:
  void scale_gradient(const S& factor) {
    for (S& x : gradient_) {
      if (!definitely(is_zero(x))) x *= factor;
    }
  }
  void add_gradient(const S& factor, const Dual& b) {
    const std::size_t count = b.gradient_.size();
    if (gradient_.size() < count) gradient_.resize(count, from_int<S>(0));
    for (std::size_t k = 0; k < count; ++k) {
      if (!definitely(is_zero(b.gradient_[k]))) add_product(gradient_[k], factor, S(b.gradient_[k]));
    }
  }

  S value_;
  std::vector<S> gradient_;
};

/// Predicates speak of the value.
template <class S>
struct ScalarTraits<Dual<S>> {
  static constexpr std::string_view name = "dual";
  static constexpr bool exact = ScalarTraits<S>::exact;
  static constexpr bool decided = ScalarTraits<S>::decided;
  static constexpr bool ordered = ScalarTraits<S>::ordered;
  static constexpr bool prefers_reciprocal = false;

  static Dual<S> from_int(std::int64_t i) { return Dual<S>(i); }
  static Truth is_zero(const Dual<S>& x) { return ScalarTraits<S>::is_zero(x.value()); }
  static Truth less(const Dual<S>& x, const Dual<S>& y) requires(ScalarTraits<S>::ordered) {
    return ScalarTraits<S>::less(x.value(), y.value());
  }
  static std::string text(const Dual<S>& x) { return ScalarTraits<S>::text(x.value()); }
};

}  // namespace torse
