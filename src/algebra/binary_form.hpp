// Homogeneous polynomials f(s, t) = sum_i f_i s^{d-i} t^i over a ring. With s = 1-t they are the polynomials of degree
// d in Bernstein form, f_i being the binomial C(d, i) times the i-th Bernstein coefficient: products and derivatives
// need no division, so they hold over the integers and in every characteristic.
//   BinaryForm<S>     coefficients, + - *, d/ds, d/dt, value, zero test
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "torse/scalar/concepts.hpp"

namespace torse {

/// A homogeneous polynomial of degree d in (s, t): d + 1 coefficients, the i-th that of s^{d-i} t^i.
template <Ring S>
class BinaryForm {
 public:
  /// The zero constant.
  BinaryForm() : BinaryForm(0) {}
  /// The zero form of degree d >= 0.
  explicit BinaryForm(int degree) : f_(static_cast<std::size_t>(degree) + 1, from_int<S>(0)) {}
  /// Takes d + 1 >= 1 coefficients.
  explicit BinaryForm(std::vector<S> coefficients) : f_(std::move(coefficients)) {}

  int degree() const { return static_cast<int>(f_.size()) - 1; }
  const S& operator[](int i) const { return f_[static_cast<std::size_t>(i)]; }
  S& operator[](int i) { return f_[static_cast<std::size_t>(i)]; }

  /// Sum and difference of forms of equal degree.
  BinaryForm& operator+=(const BinaryForm& g) {
    for (int i = 0; i <= degree(); ++i) (*this)[i] += g[i];
    return *this;
  }
  BinaryForm& operator-=(const BinaryForm& g) {
    for (int i = 0; i <= degree(); ++i) (*this)[i] -= g[i];
    return *this;
  }
  friend BinaryForm operator+(BinaryForm f, const BinaryForm& g) { return std::move(f += g); }
  friend BinaryForm operator-(BinaryForm f, const BinaryForm& g) { return std::move(f -= g); }

  friend BinaryForm operator*(const BinaryForm& f, const BinaryForm& g) {
    BinaryForm h(f.degree() + g.degree());
    for (int i = 0; i <= f.degree(); ++i) {
      for (int j = 0; j <= g.degree(); ++j) add_product(h[i + j], f[i], g[j]);
    }
    return h;
  }
  friend BinaryForm operator*(const S& a, BinaryForm f) {
    for (int i = 0; i <= f.degree(); ++i) f[i] *= a;
    return f;
  }

  /// The partial derivative by s; the zero form of degree 0 for a constant.
  BinaryForm derivative_s() const {
    BinaryForm g(degree() > 0 ? degree() - 1 : 0);
    for (int i = 0; i < degree(); ++i) g[i] = from_int<S>(degree() - i) * (*this)[i];
    return g;
  }
  /// The partial derivative by t.
  BinaryForm derivative_t() const {
    BinaryForm g(degree() > 0 ? degree() - 1 : 0);
    for (int i = 0; i < degree(); ++i) g[i] = from_int<S>(i + 1) * (*this)[i + 1];
    return g;
  }

  /// f(s, t) by Horner's rule.
  S operator()(const S& s, const S& t) const {
    S value = (*this)[degree()];
    S power = from_int<S>(1);
    for (int i = degree() - 1; i >= 0; --i) {
      power *= s;
      value = value * t + (*this)[i] * power;
    }
    return value;
  }

  /// Whether every coefficient is zero.
  Truth zero() const {
    Truth all = Truth::yes;
    for (const S& x : f_) all = all & is_zero(x);
    return all;
  }

  /// The first coefficient that is decidedly not zero, if there is one.
  std::optional<int> first_nonzero() const {
    for (int i = 0; i <= degree(); ++i) {
      if (!possibly(is_zero((*this)[i]))) return i;
    }
    return std::nullopt;
  }

 private:
  std::vector<S> f_;
};

}  // namespace torse
