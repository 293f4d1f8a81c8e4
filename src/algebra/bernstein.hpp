// Polynomials in Bernstein form over a field: f(t) = sum_i b_i C(d, i) (1-t)^{d-i} t^i.
//   Bernstein<S>     coefficients, + - *, value, elevation, derivative, composition, subdivision, zero test
//   binomial         C(n, k) in S        binomials     the row C(n, 0), ..., C(n, n)
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "torse/algebra/binary_form.hpp"
#include "torse/scalar/int128.hpp"

namespace torse {

/// C(n, 0), ..., C(n, n) in S: by the multiplicative formula over the integers up to n = 61, which keeps the products
/// within 64 bits, beyond that by Pascal's rule in S.
template <Ring S>
std::vector<S> binomials(int n) {
  std::vector<S> row{from_int<S>(1)};
  const int first = n <= 61 ? n : 61;
  std::int64_t value = 1;
  for (int k = 1; k <= first; ++k) {
    value = static_cast<std::int64_t>(static_cast<int128>(value) * (first - k + 1) / k);
    row.push_back(from_int<S>(value));
  }
  for (int m = first + 1; m <= n; ++m) {
    row.push_back(from_int<S>(1));
    for (int i = m - 1; i > 0; --i) row[static_cast<std::size_t>(i)] += row[static_cast<std::size_t>(i) - 1];
  }
  return row;
}

/// C(n, k) in S, 0 outside 0 <= k <= n. Callers that need a whole row take `binomials`.
template <Ring S>
S binomial(int n, int k) {
  if (k < 0 || k > n) return from_int<S>(0);
  if (n > 61) return binomials<S>(n)[static_cast<std::size_t>(k)];
  std::int64_t value = 1;
  for (int i = 1; i <= k; ++i) value = static_cast<std::int64_t>(static_cast<int128>(value) * (n - k + i) / i);
  return from_int<S>(value);
}

/// A polynomial of degree at most d by its d + 1 Bernstein coefficients on [0, 1].
template <Field S>
class Bernstein {
 public:
  /// Takes d + 1 >= 1 coefficients.
  explicit Bernstein(std::vector<S> coefficients) : b_(std::move(coefficients)) {}

  /// From the homogeneous form: coefficients divided by binomials.
  static Bernstein from_form(const BinaryForm<S>& f) {
    std::vector<S> b;
    const std::vector<S> weights = binomials<S>(f.degree());
    for (int i = 0; i <= f.degree(); ++i) b.push_back(f[i] / weights[static_cast<std::size_t>(i)]);
    return Bernstein(std::move(b));
  }
  /// The homogeneous form: coefficients times binomials.
  BinaryForm<S> form() const {
    BinaryForm<S> f(degree());
    const std::vector<S> weights = binomials<S>(degree());
    for (int i = 0; i <= degree(); ++i) f[i] = (*this)[i] * weights[static_cast<std::size_t>(i)];
    return f;
  }

  int degree() const { return static_cast<int>(b_.size()) - 1; }
  const S& operator[](int i) const { return b_[static_cast<std::size_t>(i)]; }
  const std::vector<S>& coefficients() const { return b_; }

  /// f(t) by de Casteljau's algorithm.
  S operator()(const S& t) const {
    std::vector<S> row = b_;
    const S s = from_int<S>(1) - t;
    for (std::size_t size = row.size(); size > 1; --size) {
      for (std::size_t i = 0; i + 1 < size; ++i) row[i] = s * row[i] + t * row[i + 1];
    }
    return row.front();
  }

  /// The same polynomial written with degree d >= degree().
  Bernstein elevated(int d) const {
    std::vector<S> b = b_;
    for (int n = degree() + 1; n <= d; ++n) {
      std::vector<S> raised{b.front()};
      for (int i = 1; i < n; ++i) {
        const std::size_t at = static_cast<std::size_t>(i);
        raised.push_back((from_int<S>(i) * b[at - 1] + from_int<S>(n - i) * b[at]) / from_int<S>(n));
      }
      raised.push_back(b.back());
      b = std::move(raised);
    }
    return Bernstein(std::move(b));
  }

  friend Bernstein operator+(const Bernstein& f, const Bernstein& g) { return f.termwise(g, from_int<S>(1)); }
  friend Bernstein operator-(const Bernstein& f, const Bernstein& g) { return f.termwise(g, from_int<S>(-1)); }
  friend Bernstein operator*(const Bernstein& f, const Bernstein& g) { return from_form(f.form() * g.form()); }

  /// f', of degree d - 1 (degree 0 for a constant).
  Bernstein derivative() const {
    if (degree() == 0) return Bernstein({from_int<S>(0)});
    std::vector<S> b;
    b.reserve(static_cast<std::size_t>(degree()));
    for (int i = 0; i < degree(); ++i) b.push_back(from_int<S>(degree()) * ((*this)[i + 1] - (*this)[i]));
    return Bernstein(std::move(b));
  }

  /// f(g(t)), of degree deg f * deg g: de Casteljau's algorithm with the polynomial g in the place of the parameter.
  Bernstein compose(const Bernstein& g) const {
    std::vector<BinaryForm<S>> row;
    for (const S& b : b_) row.push_back(BinaryForm<S>(std::vector<S>{b}));
    const Bernstein one(std::vector<S>(static_cast<std::size_t>(g.degree()) + 1, from_int<S>(1)));
    const BinaryForm<S> t = g.form();
    const BinaryForm<S> s = one.form() - t;
    for (std::size_t size = row.size(); size > 1; --size) {
      for (std::size_t i = 0; i + 1 < size; ++i) row[i] = s * row[i] + t * row[i + 1];
    }
    return from_form(row.front());
  }

  /// The polynomials of [0, t] and [t, 1], each over its own [0, 1].
  std::pair<Bernstein, Bernstein> subdivide(const S& t) const {
    std::vector<S> row = b_;
    std::vector<S> left{row.front()};
    std::vector<S> right{row.back()};
    const S s = from_int<S>(1) - t;
    for (std::size_t size = row.size(); size > 1; --size) {
      for (std::size_t i = 0; i + 1 < size; ++i) row[i] = s * row[i] + t * row[i + 1];
      left.push_back(row.front());
      right.push_back(row[size - 2]);
    }
    return {Bernstein(std::move(left)), Bernstein(std::vector<S>(right.rbegin(), right.rend()))};
  }

  /// Whether the polynomial is identically zero: Bernstein polynomials are a basis.
  Truth zero() const {
    Truth all = Truth::yes;
    for (const S& b : b_) all = all & is_zero(b);
    return all;
  }

 private:
  Bernstein termwise(const Bernstein& g, const S& factor) const {
    const int d = degree() > g.degree() ? degree() : g.degree();
    Bernstein f = elevated(d);
    const Bernstein h = g.elevated(d);
    for (int i = 0; i <= d; ++i) add_product(f.b_[static_cast<std::size_t>(i)], factor, h[i]);
    return f;
  }

  std::vector<S> b_;
};

}  // namespace torse
