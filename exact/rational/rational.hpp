// Exact rational numbers on GMP's mpq_t: an eager value type, always in lowest terms.
//   RationalStore     the thread's recycled mpq_t, so that temporaries do not allocate
//   Rational          + - * /, total order, exact from_double, correctly rounded to_double, text
//   ScalarTraits<Rational>
#pragma once

#include <gmp.h>

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "torse/scalar/errors.hpp"
#include "torse/scalar/traits.hpp"

namespace torse {

/// A short stack of initialised numbers per thread. A Rational takes its storage from it and gives it back, so an
/// expression's temporaries cost no allocation. Constant-initialised: the first number given back opens it, the end of
/// the thread closes it, and numbers that outlive it (statics) are freed directly.
class RationalStore {
 public:
  /// Fills `q` with an initialised number of unspecified value.
  void take(mpq_ptr q) {
    if (count_ > 0) {
      *q = slots_[--count_];
    } else {
      mpq_init(q);
    }
  }

  /// Takes over the storage of `q`.
  void give(mpq_ptr q) {
    if (count_ < limit_ && mpq_numref(q)->_mp_alloc + mpq_denref(q)->_mp_alloc <= most_limbs) {
      slots_[count_++] = *q;
    } else {
      give_slowly(q);
    }
  }

 private:
  struct Keeper;
  static constexpr int capacity = 64;
  static constexpr int most_limbs = 256;

  void give_slowly(mpq_ptr q);

  int count_ = 0;
  int limit_ = 0;
  __mpq_struct slots_[capacity] = {};
};

/// An element of Q. Values are canonical after every operation; a moved-from value is some valid number. There is no
/// conversion from floating point but the named, exact `from_double`.
class Rational {
 public:
  /// Zero.
  Rational() : Rational(Raw{}) { mpq_set_ui(q_, 0, 1); }

  /// The integer `i`.
  template <std::integral T>
  requires(sizeof(T) <= sizeof(long)) explicit Rational(T i) : Rational(Raw{}) {
    if constexpr (std::is_signed_v<T>) {
      mpq_set_si(q_, i, 1);
    } else {
      mpq_set_ui(q_, i, 1);
    }
  }

  Rational(const Rational& other) : Rational(Raw{}) { mpq_set(q_, other.q_); }
  Rational(Rational&& other) noexcept : Rational(Raw{}) { std::swap(*q_, *other.q_); }
  ~Rational() { store_.give(q_); }

  Rational& operator=(const Rational& other) {
    mpq_set(q_, other.q_);
    return *this;
  }
  Rational& operator=(Rational&& other) noexcept {
    std::swap(*q_, *other.q_);
    return *this;
  }

  /// The exact value of `x`: every finite double is a dyadic rational. Throws InvalidInput for NaN and infinities.
  static Rational from_double(double x);

  /// Reads "p" or "p/q" with decimal digits and an optional sign in front of p. Throws InvalidInput for other text and
  /// for q = 0.
  static Rational from_text(std::string_view text);

  /// A copy of a GMP number, brought to lowest terms. Throws DivisionByZero for a zero denominator.
  static Rational from_mpq(mpq_srcptr q);

  /// The double nearest to the value, ties to even; beyond the largest double, an infinity.
  double to_double() const;

  /// "p" or "p/q" in lowest terms.
  std::string text() const;

  /// -1, 0 or 1.
  int sign() const { return mpq_sgn(q_); }

  /// The number of bits of |numerator| (0 for zero) and of the denominator.
  std::size_t numerator_bits() const { return sign() == 0 ? 0 : mpz_sizeinbase(mpq_numref(q_), 2); }
  std::size_t denominator_bits() const { return mpz_sizeinbase(mpq_denref(q_), 2); }

  /// The GMP number, valid as long as this object is.
  mpq_srcptr mpq() const { return q_; }

  Rational& operator+=(const Rational& b) {
    mpq_add(q_, q_, b.q_);
    return *this;
  }
  Rational& operator-=(const Rational& b) {
    mpq_sub(q_, q_, b.q_);
    return *this;
  }
  Rational& operator*=(const Rational& b) {
    mpq_mul(q_, q_, b.q_);
    return *this;
  }
  /// Throws DivisionByZero for b = 0.
  Rational& operator/=(const Rational& b) {
    b.require_nonzero();
    mpq_div(q_, q_, b.q_);
    return *this;
  }

  /// y += a b.
  static void add_product(Rational& y, const Rational& a, const Rational& b) {
    Rational product{Raw{}};
    mpq_mul(product.q_, a.q_, b.q_);
    mpq_add(y.q_, y.q_, product.q_);
  }

  friend bool operator==(const Rational& a, const Rational& b) { return mpq_equal(a.q_, b.q_) != 0; }
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b) { return mpq_cmp(a.q_, b.q_) <=> 0; }

  friend Rational operator-(const Rational& a) {
    Rational r{Raw{}};
    mpq_neg(r.q_, a.q_);
    return r;
  }
  friend Rational operator-(Rational&& a) {
    mpq_neg(a.q_, a.q_);
    return std::move(a);
  }

  /// f(a, b) for one of GMP's operations, computed in the storage of a temporary operand where there is one.
  template <void (*f)(mpq_ptr, mpq_srcptr, mpq_srcptr), class A, class B>
  static Rational apply(A&& a, B&& b) {
    if constexpr (std::same_as<A, Rational>) {
      f(a.q_, a.q_, b.q_);
      return std::forward<A>(a);
    } else if constexpr (std::same_as<B, Rational>) {
      f(b.q_, a.q_, b.q_);
      return std::forward<B>(b);
    } else {
      Rational r{Raw{}};
      f(r.q_, a.q_, b.q_);
      return r;
    }
  }

  /// Throws DivisionByZero for zero.
  void require_nonzero() const {
    if (sign() == 0) throw_division_by_zero();
  }

 private:
  struct Raw {};
  explicit Rational(Raw) { store_.take(q_); }

  [[noreturn]] static void throw_division_by_zero();

  mpq_t q_;
  static inline constinit thread_local RationalStore store_{};
};

/// A Rational in any value category: the operators deduce it, so that they see which operands are temporaries.
template <class T>
concept AnyRational = std::same_as<std::remove_cvref_t<T>, Rational>;

template <AnyRational A, AnyRational B>
Rational operator+(A&& a, B&& b) {
  return Rational::apply<mpq_add>(std::forward<A>(a), std::forward<B>(b));
}
template <AnyRational A, AnyRational B>
Rational operator-(A&& a, B&& b) {
  return Rational::apply<mpq_sub>(std::forward<A>(a), std::forward<B>(b));
}
template <AnyRational A, AnyRational B>
Rational operator*(A&& a, B&& b) {
  return Rational::apply<mpq_mul>(std::forward<A>(a), std::forward<B>(b));
}
/// Throws DivisionByZero for b = 0.
template <AnyRational A, AnyRational B>
Rational operator/(A&& a, B&& b) {
  b.require_nonzero();
  return Rational::apply<mpq_div>(std::forward<A>(a), std::forward<B>(b));
}

template <>
struct ScalarTraits<Rational> {
  static constexpr std::string_view name = "Q";
  static constexpr bool exact = true;
  static constexpr bool decided = true;
  static constexpr bool ordered = true;
  static constexpr bool prefers_reciprocal = false;

  static Rational from_int(std::int64_t i) { return Rational(i); }
  static Truth is_zero(const Rational& x) { return truth(x.sign() == 0); }
  static Truth less(const Rational& x, const Rational& y) { return truth(x < y); }
  static std::string text(const Rational& x) { return x.text(); }
  static void add_product(Rational& y, const Rational& a, const Rational& b) { Rational::add_product(y, a, b); }
  /// The least common multiple of the denominators.
  static Rational common_denominator(const std::vector<Rational>& list);
  /// The monic greatest common divisor of two polynomials that are not zero, coefficients of 1, t, t^2, ... (by FLINT).
  static std::vector<Rational> polynomial_gcd(const std::vector<Rational>& f, const std::vector<Rational>& g);
};

}  // namespace torse
