// Polynomials in one variable t over an exact field, in the power basis.
//   Polynomial<S>          + - *, value, derivative, composition, zero test
//   divide_with_rest       quotient and remainder         exact_quotient     where the remainder is zero
//   gcd, common_divisor    of two, of a list, monic       square_free_part   each root once
//   ScalarTraits<Polynomial<S>>: the ring S[t]
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "torse/scalar/concepts.hpp"
#include "torse/scalar/errors.hpp"

namespace torse {

/// sum_i a_i t^i. The last coefficient is not zero; the zero polynomial has none and degree -1.
template <ExactField S>
class Polynomial {
 public:
  /// Zero.
  Polynomial() = default;
  /// The constant `i`.
  template <std::integral T>
  explicit Polynomial(T i) : Polynomial(std::vector<S>{from_int<S>(static_cast<std::int64_t>(i))}) {}
  /// sum_i coefficients[i] t^i.
  explicit Polynomial(std::vector<S> coefficients) : a_(std::move(coefficients)) { trim(); }

  /// The constant a.
  static Polynomial constant(S a) { return Polynomial(std::vector<S>{std::move(a)}); }
  /// The polynomial t.
  static Polynomial variable() { return Polynomial(std::vector<S>{from_int<S>(0), from_int<S>(1)}); }

  /// The degree, -1 for the zero polynomial.
  int degree() const { return static_cast<int>(a_.size()) - 1; }
  bool zero() const { return a_.empty(); }
  /// The coefficient of t^i, 0 <= i <= degree().
  const S& operator[](int i) const { return a_[static_cast<std::size_t>(i)]; }
  /// The coefficients of 1, t, t^2, ...; none for the zero polynomial.
  const std::vector<S>& coefficients() const { return a_; }
  /// The coefficient of the highest power. The polynomial is not zero.
  const S& leading() const { return a_.back(); }

  Polynomial& operator+=(const Polynomial& g) {
    if (a_.size() < g.a_.size()) a_.resize(g.a_.size(), from_int<S>(0));
    for (std::size_t i = 0; i < g.a_.size(); ++i) a_[i] += g.a_[i];
    trim();
    return *this;
  }
  Polynomial& operator-=(const Polynomial& g) {
    if (a_.size() < g.a_.size()) a_.resize(g.a_.size(), from_int<S>(0));
    for (std::size_t i = 0; i < g.a_.size(); ++i) a_[i] -= g.a_[i];
    trim();
    return *this;
  }
  Polynomial& operator*=(const Polynomial& g) { return *this = *this * g; }
  /// Each coefficient times a.
  Polynomial& scale(const S& a) {
    for (S& x : a_) x *= a;
    trim();
    return *this;
  }

  friend Polynomial operator+(Polynomial f, const Polynomial& g) { return std::move(f += g); }
  friend Polynomial operator-(Polynomial f, const Polynomial& g) { return std::move(f -= g); }
  friend Polynomial operator-(Polynomial f) {
    for (S& x : f.a_) x = -x;
    return f;
  }
  friend Polynomial operator*(const Polynomial& f, const Polynomial& g) {
    if (f.zero() || g.zero()) return Polynomial();
    std::vector<S> product(f.a_.size() + g.a_.size() - 1, from_int<S>(0));
    for (std::size_t i = 0; i < f.a_.size(); ++i) {
      for (std::size_t j = 0; j < g.a_.size(); ++j) add_product(product[i + j], f.a_[i], g.a_[j]);
    }
    return Polynomial(std::move(product));
  }
  friend bool operator==(const Polynomial& f, const Polynomial& g) { return (f - g).zero(); }

  /// f(x) by Horner's rule.
  S operator()(const S& x) const {
    S value = from_int<S>(0);
    for (std::size_t i = a_.size(); i-- > 0;) value = value * x + a_[i];
    return value;
  }
  /// f(g(t)).
  Polynomial compose(const Polynomial& g) const {
    Polynomial value;
    for (std::size_t i = a_.size(); i-- > 0;) value = value * g + constant(a_[i]);
    return value;
  }
  Polynomial derivative() const {
    std::vector<S> d;
    for (int i = 1; i <= degree(); ++i) d.push_back(from_int<S>(i) * (*this)[i]);
    return Polynomial(std::move(d));
  }
  /// The multiple with leading coefficient 1; zero stays zero.
  Polynomial monic() const {
    Polynomial f = *this;
    return zero() ? f : f.scale(from_int<S>(1) / leading());
  }

 private:
  void trim() {
    while (!a_.empty() && definitely(is_zero(a_.back()))) a_.pop_back();
  }

  std::vector<S> a_;
};

/// Quotient and remainder.
template <ExactField S>
struct Division {
  Polynomial<S> quotient;
  Polynomial<S> rest;
};

/// f = quotient g + rest with deg rest < deg g. Throws DivisionByZero for g = 0.
template <ExactField S>
Division<S> divide_with_rest(const Polynomial<S>& f, const Polynomial<S>& g) {
  if (g.zero()) throw DivisionByZero();
  if (f.degree() < g.degree()) return {Polynomial<S>(), f};
  const std::size_t m = g.coefficients().size();
  std::vector<S> rest = f.coefficients();
  std::vector<S> quotient(rest.size() - m + 1, from_int<S>(0));
  for (std::size_t i = quotient.size(); i-- > 0;) {
    quotient[i] = rest[i + m - 1] / g.leading();
    const S factor = -quotient[i];
    for (std::size_t j = 0; j < m; ++j) add_product(rest[i + j], factor, g.coefficients()[j]);
  }
  rest.resize(m - 1);
  return {Polynomial<S>(std::move(quotient)), Polynomial<S>(std::move(rest))};
}

/// f / g where g divides f; the remainder is not looked at. Throws DivisionByZero for g = 0.
template <ExactField S>
Polynomial<S> exact_quotient(const Polynomial<S>& f, const Polynomial<S>& g) {
  return g.degree() == 0 && definitely(equal(g.leading(), from_int<S>(1))) ? f : divide_with_rest(f, g).quotient;
}

/// The monic greatest common divisor; gcd(0, 0) = 0. By `ScalarTraits<S>::polynomial_gcd` where a field has it, else by
/// Euclid's algorithm with monic remainders.
template <ExactField S>
Polynomial<S> gcd(Polynomial<S> f, Polynomial<S> g) {
  if (f.zero()) return g.monic();
  if (g.zero()) return f.monic();
  if (f.degree() == 0 || g.degree() == 0) return Polynomial<S>(1);
  if constexpr (requires { ScalarTraits<S>::polynomial_gcd(f.coefficients(), g.coefficients()); }) {
    return Polynomial<S>(ScalarTraits<S>::polynomial_gcd(f.coefficients(), g.coefficients()));
  } else {
    f = f.monic();
    while (!g.zero()) {
      f = divide_with_rest(f, g).rest;
      std::swap(f, g);
      g = g.monic();
    }
    return f.monic();
  }
}

/// The monic greatest common divisor of a list of polynomials.
template <class List>
auto common_divisor(const List& list) {
  typename List::value_type common;
  for (const auto& f : list) common = gcd(common, f);
  return common;
}

/// The monic polynomial with the same roots, each once, over a field of characteristic zero. f is not zero.
template <ExactField S>
Polynomial<S> square_free_part(const Polynomial<S>& f) {
  return exact_quotient(f.monic(), gcd(f, f.derivative()));
}

/// "3/2 t^2 - t + 5", "0" for zero; a coefficient that is itself a sum stands in brackets.
template <ExactField S>
std::string polynomial_text(const Polynomial<S>& f) {
  if (f.zero()) return "0";
  std::string text;
  for (int i = f.degree(); i >= 0; --i) {
    if (definitely(is_zero(f[i]))) continue;
    std::string factor = as_text(f[i]);
    if (factor.find(' ') != std::string::npos) factor.insert(0, 1, '(').push_back(')');
    const bool negative = factor.front() == '-';
    if (negative) factor.erase(0, 1);
    text += text.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
    const std::string power = i == 0 ? "" : i == 1 ? "t" : "t^" + std::to_string(i);
    if (power.empty()) {
      text += factor;
    } else {
      text += factor == "1" ? power : factor.append(1, ' ').append(power);
    }
  }
  return text;
}

template <ExactField S>
struct ScalarTraits<Polynomial<S>> {
  static constexpr std::string_view name = "polynomials";
  static constexpr bool exact = true;
  static constexpr bool decided = true;
  static constexpr bool ordered = false;
  static constexpr bool prefers_reciprocal = false;

  static Polynomial<S> from_int(std::int64_t i) { return Polynomial<S>(i); }
  static Truth is_zero(const Polynomial<S>& f) { return truth(f.zero()); }
  static std::string text(const Polynomial<S>& f) { return polynomial_text(f); }
};

}  // namespace torse
