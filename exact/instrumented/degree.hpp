// A scalar that bounds degrees and coefficients instead of computing: run on it, an algorithm yields the degree for the
// Schwartz-Zippel lemma and the coefficient size for the count of bad primes.
//   UpperBound   a positive number rounded up, of any size
//   Degree       bounds on the numerator and the denominator of a rational expression in drawn inputs
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "torse/scalar/errors.hpp"
#include "torse/scalar/traits.hpp"

namespace torse {

/// An upper bound mantissa * 2^exponent, 1 <= mantissa < 2, of a number >= 1. An operation whose result is not exact is
/// rounded up: the next double above a correctly rounded result is not below the exact one.
class UpperBound {
 public:
  /// The bound 1.
  UpperBound() = default;

  /// A bound of i >= 1.
  explicit UpperBound(std::uint64_t i) : UpperBound(static_cast<double>(i), i <= (std::uint64_t{1} << 53), 0) {}

  /// An integer k with value <= 2^k; the least one for the value held.
  std::int64_t log2() const { return mantissa_ == 1 ? exponent_ : exponent_ + 1; }

  friend UpperBound operator*(const UpperBound& x, const UpperBound& y) {
    const double product = x.mantissa_ * y.mantissa_;
    const bool is_exact = std::fma(x.mantissa_, y.mantissa_, -product) == 0;
    return UpperBound(product, is_exact, x.exponent_ + y.exponent_);
  }

  friend UpperBound operator+(const UpperBound& x, const UpperBound& y) {
    if (x.exponent_ < y.exponent_) return y + x;
    const std::int64_t shift = std::min<std::int64_t>(x.exponent_ - y.exponent_, 1000);
    const double small = std::ldexp(y.mantissa_, -static_cast<int>(shift));
    const double sum = x.mantissa_ + small;
    return UpperBound(sum, sum - x.mantissa_ == small, x.exponent_);
  }

 private:
  UpperBound(double value, bool is_exact, std::int64_t exponent) {
    int shift = 0;
    mantissa_ =
        2 * std::frexp(is_exact ? value : std::nextafter(value, std::numeric_limits<double>::infinity()), &shift);
    exponent_ = exponent + shift - 1;
  }

  double mantissa_ = 1;
  std::int64_t exponent_ = 0;
};

/// A rational expression in drawn inputs, as a product of powers of integer polynomials, each known by bounds only.
///
/// Every value stands for +-prod_k a_k^{e_k} with integer polynomials a_k ("atoms") in the inputs and integers e_k; an
/// atom carries an upper bound of its total degree and of its 1-norm |a|, the sum of the absolute values of its
/// coefficients. The bounds hold by induction over the operations:
///   input()      one variable: degree 1, norm 1.
///   from_int(i)  a constant: degree 0, norm |i|; 0 is kept as a known zero, +-1 as the empty product.
///   x y, x / y   exponents add or subtract. An atom that cancels was divided by, so it is not the zero polynomial and
///                does not vanish at a point where the computation ran to its end.
///   x +- y       g (r +- s), with g the product of the atoms to the smaller of their two exponents: x = +-g r, y = +-g
///   s
///                with polynomials r, s. The new atom +-r +-s has degree <= max(deg r, deg s) and norm <= |r| + |s|.
///                Equal denominators thus stay as they are and different ones give their least common multiple.
/// For products, deg(a b) <= deg a + deg b and |a b| <= |a| |b|.
///
/// So at every point where the computation runs, the value in a field of prime order p is N/D for integer polynomials
/// N, D with deg N <= numerator_degree() and |N| <= 2^numerator_bits(), and D does not vanish there. If N is not the
/// zero polynomial, it is zero modulo at most numerator_bits() / log2 p of the primes p and larger ones; modulo any
/// other, at most deg N / #S of all points with coordinates in S are zeros of N. Points where the computation divides
/// by zero are points less, so the error per accepted point is deg N / #S over the fraction that is accepted.
class Degree {
 public:
  /// Zero.
  Degree() = default;

  /// A constant.
  template <std::integral T>
  explicit Degree(T i) {
    const std::uint64_t size = magnitude(i);
    is_zero_ = size == 0;
    if (size > 1) factors_.push_back({fresh_id(), 1, 0, UpperBound(size), true});
  }

  /// A new drawn input.
  static Degree input() { return atom(1, UpperBound(), false); }

  /// Whether this is zero (only known for the constant 0 and products with it) or a nonzero constant.
  Truth zero() const {
    if (is_zero_) return Truth::yes;
    const bool nonzero = std::ranges::all_of(factors_, [](const Factor& f) { return f.nonzero; });
    return nonzero ? Truth::no : Truth::unknown;
  }

  std::int64_t numerator_degree() const { return degree(+1); }
  std::int64_t denominator_degree() const { return degree(-1); }
  /// A k such that the numerator's 1-norm is <= 2^k.
  std::int64_t numerator_bits() const { return norm(+1).log2(); }
  std::int64_t denominator_bits() const { return norm(-1).log2(); }

  Degree& operator*=(const Degree& y) {
    if (is_zero_ || y.is_zero_) return *this = Degree();
    factors_ = combined(factors_, y.factors_, [](std::int64_t e, std::int64_t f) { return e + f; });
    return *this;
  }

  /// Throws DivisionByZero for a known zero.
  Degree& operator/=(const Degree& y) {
    if (y.is_zero_) throw DivisionByZero();
    if (is_zero_) return *this;
    factors_ = combined(factors_, y.factors_, [](std::int64_t e, std::int64_t f) { return e - f; });
    return *this;
  }

  Degree& operator+=(const Degree& y) {
    if (y.is_zero_) return *this;
    if (is_zero_) return *this = y;
    Degree common;
    common.is_zero_ = false;
    common.factors_ = combined(factors_, y.factors_, [](std::int64_t e, std::int64_t f) { return std::min(e, f); });
    const Degree r = *this / common;
    const Degree s = y / common;
    const Degree sum = atom(std::max(r.numerator_degree(), s.numerator_degree()), r.norm(+1) + s.norm(+1), false);
    return *this = common * sum;
  }

  Degree& operator-=(const Degree& y) { return *this += y; }

  friend Degree operator+(Degree x, const Degree& y) { return std::move(x += y); }
  friend Degree operator-(Degree x, const Degree& y) { return std::move(x -= y); }
  friend Degree operator*(Degree x, const Degree& y) { return std::move(x *= y); }
  friend Degree operator/(Degree x, const Degree& y) { return std::move(x /= y); }
  friend Degree operator-(Degree x) { return x; }

 private:
  struct Factor {
    std::uint64_t id;
    std::int64_t exponent;
    std::int64_t degree;
    UpperBound norm;
    bool nonzero;
  };

  template <std::integral T>
  static std::uint64_t magnitude(T i) {
    if constexpr (std::signed_integral<T>) {
      return i < 0 ? std::uint64_t{0} - static_cast<std::uint64_t>(i) : static_cast<std::uint64_t>(i);
    } else {
      return static_cast<std::uint64_t>(i);
    }
  }

  static std::uint64_t fresh_id() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
  }

  static Degree atom(std::int64_t degree, const UpperBound& norm, bool nonzero) {
    Degree x;
    x.is_zero_ = false;
    x.factors_.push_back({fresh_id(), 1, degree, norm, nonzero});
    return x;
  }

  /// The factors of x and y with the exponents combine(e, f); 0 stands for a factor that is not there.
  template <class Combine>
  static std::vector<Factor> combined(const std::vector<Factor>& x, const std::vector<Factor>& y, Combine combine) {
    std::vector<Factor> result;
    result.reserve(x.size() + y.size());
    const auto append = [&result](Factor factor, std::int64_t exponent) {
      factor.exponent = exponent;
      if (exponent != 0) result.push_back(factor);
    };
    auto i = x.begin();
    auto j = y.begin();
    while (i != x.end() || j != y.end()) {
      if (j == y.end() || (i != x.end() && i->id < j->id)) {
        append(*i, combine(i->exponent, 0));
        ++i;
      } else if (i == x.end() || j->id < i->id) {
        append(*j, combine(0, j->exponent));
        ++j;
      } else {
        append(*i, combine(i->exponent, j->exponent));
        ++i;
        ++j;
      }
    }
    return result;
  }

  /// The degree of the numerator (sign 1) or the denominator (sign -1).
  std::int64_t degree(int sign) const {
    std::int64_t total = 0;
    for (const Factor& factor : factors_) {
      if (sign * factor.exponent > 0) total += sign * factor.exponent * factor.degree;
    }
    return total;
  }

  UpperBound norm(int sign) const {
    UpperBound product;
    for (const Factor& factor : factors_) {
      for (std::int64_t k = 0; k < sign * factor.exponent; ++k) product = product * factor.norm;
    }
    return product;
  }

  bool is_zero_ = true;
  /// By increasing id; no exponent is 0.
  std::vector<Factor> factors_;
};

template <>
struct ScalarTraits<Degree> {
  static constexpr std::string_view name = "degree";
  static constexpr bool exact = true;
  static constexpr bool decided = false;
  static constexpr bool ordered = false;
  static constexpr bool prefers_reciprocal = false;

  static Degree from_int(std::int64_t i) { return Degree(i); }
  static Truth is_zero(const Degree& x) { return x.zero(); }

  static std::string text(const Degree& x) {
    if (definitely(x.zero())) return "0";
    return "degree " + std::to_string(x.numerator_degree()) + "/" + std::to_string(x.denominator_degree()) + ", bits " +
           std::to_string(x.numerator_bits()) + "/" + std::to_string(x.denominator_bits());
  }
};

}  // namespace torse
