// Rational functions over Q in named indeterminates, kept reduced, through FLINT's fmpz_mpoly_q.
//   SymbolicContext     the indeterminates
//   RationalFunction    an element of Q(x_1, ..., x_m), a scalar of the library
//   Shape               degrees and sizes of the reduced numerator and denominator
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "torse/scalar/traits.hpp"

namespace torse {

class RationalFunction;

/// The indeterminates of a field of rational functions. It never changes, and must outlive every value made from it.
class SymbolicContext {
 public:
  /// One indeterminate for each name. Throws InvalidInput for an empty list.
  explicit SymbolicContext(std::vector<std::string> names);
  SymbolicContext(const SymbolicContext&) = delete;
  SymbolicContext& operator=(const SymbolicContext&) = delete;
  ~SymbolicContext();

  /// The number of indeterminates.
  int size() const { return static_cast<int>(names_.size()); }

  /// The name of indeterminate i.
  const std::string& name(int i) const { return names_.at(static_cast<std::size_t>(i)); }

  /// Indeterminate i, 0 <= i < size(). Throws std::out_of_range.
  RationalFunction variable(int i) const;

 private:
  friend class RationalFunction;
  struct Ring;

  std::vector<std::string> names_;
  std::unique_ptr<Ring> ring_;
};

/// Total degrees, and the least k >= 0 such that the 1-norm (the sum of the absolute values of the integer
/// coefficients) is <= 2^k, of the reduced numerator and denominator. The degree of zero is 0.
struct Shape {
  std::int64_t numerator_degree;
  std::int64_t denominator_degree;
  std::int64_t numerator_bits;
  std::int64_t denominator_bits;
};

/// An element of Q(x_1, ..., x_m): integer polynomials without common factor, the denominator's leading coefficient
/// positive. A constant belongs to every field; combining functions of two contexts throws InvalidInput.
class RationalFunction {
 public:
  /// Zero.
  RationalFunction() { construct(); }
  template <std::integral T>
  explicit RationalFunction(T i) {
    if constexpr (std::signed_integral<T>) {
      construct(static_cast<std::int64_t>(i));
    } else {
      construct(static_cast<std::uint64_t>(i));
    }
  }
  RationalFunction(const RationalFunction& x);
  RationalFunction(RationalFunction&& x) noexcept { take(x); }
  RationalFunction& operator=(const RationalFunction& x);
  RationalFunction& operator=(RationalFunction&& x) noexcept {
    if (this != &x) {
      release();
      take(x);
    }
    return *this;
  }
  ~RationalFunction() { release(); }

  RationalFunction& operator+=(const RationalFunction& x) { return set_sum(*this, x); }
  RationalFunction& operator-=(const RationalFunction& x) { return set_difference(*this, x); }
  RationalFunction& operator*=(const RationalFunction& x) { return set_product(*this, x); }
  /// Throws DivisionByZero.
  RationalFunction& operator/=(const RationalFunction& x) { return set_quotient(*this, x); }

  friend RationalFunction operator+(const RationalFunction& x, const RationalFunction& y) {
    RationalFunction z;
    z.set_sum(x, y);
    return z;
  }
  friend RationalFunction operator-(const RationalFunction& x, const RationalFunction& y) {
    RationalFunction z;
    z.set_difference(x, y);
    return z;
  }
  friend RationalFunction operator*(const RationalFunction& x, const RationalFunction& y) {
    RationalFunction z;
    z.set_product(x, y);
    return z;
  }
  /// Throws DivisionByZero.
  friend RationalFunction operator/(const RationalFunction& x, const RationalFunction& y) {
    RationalFunction z;
    z.set_quotient(x, y);
    return z;
  }
  friend RationalFunction operator+(RationalFunction&& x, const RationalFunction& y) { return std::move(x += y); }
  friend RationalFunction operator-(RationalFunction&& x, const RationalFunction& y) { return std::move(x -= y); }
  friend RationalFunction operator*(RationalFunction&& x, const RationalFunction& y) { return std::move(x *= y); }
  friend RationalFunction operator/(RationalFunction&& x, const RationalFunction& y) { return std::move(x /= y); }
  friend RationalFunction operator-(RationalFunction x) {
    x.negate();
    return x;
  }
  friend bool operator==(const RationalFunction& x, const RationalFunction& y) { return x.equals(y); }

  /// Whether this is the zero function.
  bool is_zero() const;

  /// Whether this is a rational number.
  bool is_constant() const { return context_ == nullptr; }

  /// The number of terms of numerator and denominator together.
  std::int64_t length() const;

  /// Degrees and coefficient sizes of the reduced form.
  Shape shape() const;

  /// The value "p/q" at the rational numbers `point`, one text "p/q" or "p" for each indeterminate. Throws
  /// DivisionByZero at a zero of the denominator and InvalidInput for a wrong size or text.
  std::string evaluate(const std::vector<std::string>& point) const;

  /// "num", "num/den", with parentheses where needed, in the context's names.
  std::string text() const;

 private:
  friend class SymbolicContext;
  struct Access;

  void construct();
  void construct(std::int64_t i);
  void construct(std::uint64_t i);
  void release() noexcept;
  void take(RationalFunction& x) noexcept;
  void negate();
  bool equals(const RationalFunction& x) const;
  // x op y, where this is x or zero.
  RationalFunction& set_sum(const RationalFunction& x, const RationalFunction& y);
  RationalFunction& set_difference(const RationalFunction& x, const RationalFunction& y);
  RationalFunction& set_product(const RationalFunction& x, const RationalFunction& y);
  RationalFunction& set_quotient(const RationalFunction& x, const RationalFunction& y);

  /// Null for a constant, whose storage is an fmpq; otherwise the storage is an fmpz_mpoly_q, never a constant.
  const SymbolicContext* context_ = nullptr;
  alignas(8) std::byte storage_[80];
};

template <>
struct ScalarTraits<RationalFunction> {
  static constexpr std::string_view name = "Q(x)";
  static constexpr bool exact = true;
  static constexpr bool decided = true;
  static constexpr bool ordered = false;
  static constexpr bool prefers_reciprocal = false;

  static RationalFunction from_int(std::int64_t i) { return RationalFunction(i); }
  static Truth is_zero(const RationalFunction& x) { return truth(x.is_zero()); }
  static std::int64_t weight(const RationalFunction& x) { return x.length(); }
  static std::string text(const RationalFunction& x) { return x.text(); }
  static void add_product(RationalFunction& y, const RationalFunction& a, const RationalFunction& b) {
    if (y.is_zero()) {
      y = a * b;
    } else {
      y += a * b;
    }
  }
};

}  // namespace torse
