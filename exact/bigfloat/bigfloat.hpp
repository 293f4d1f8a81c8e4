// Multiprecision floating point on MPFR with the precision in the type.
//   BigFloat<Bits>                  + - * /, sqrt, comparison; every operation correctly rounded to Bits bits
//   ScalarTraits<BigFloat<Bits>>
// MPFR is used directly: Boost's mpfr_float counts decimal digits and has no type of exactly 24, 53 or 113 bits.
#pragma once

#include <mpfr.h>

#include <algorithm>
#include <array>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

#include "torse/exact/rational/rational.hpp"
#include "torse/scalar/errors.hpp"
#include "torse/scalar/traits.hpp"

namespace torse {

/// A floating-point number of exactly Bits bits, rounded to nearest with ties to even, with MPFR's wide exponent range.
/// Division by zero, infinities and NaN follow IEEE 754, as for the built-in types. The significand lives inside the
/// object, so values never allocate. There is no conversion from built-in floating point but the named `from_double`.
template <int Bits>
class BigFloat {
 public:
  static_assert(2 <= Bits && Bits < 100000);
  static constexpr int precision = Bits;

  /// Zero.
  BigFloat() { mpfr_custom_init_set(value_, MPFR_ZERO_KIND, 0, Bits, limbs_); }

  /// The integer `i`, rounded.
  template <std::integral T>
  requires(sizeof(T) <= sizeof(std::intmax_t)) explicit BigFloat(T i) : BigFloat() {
    if constexpr (std::is_signed_v<T>) {
      mpfr_set_si(value_, i, MPFR_RNDN);
    } else {
      mpfr_set_ui(value_, i, MPFR_RNDN);
    }
  }

  BigFloat(const BigFloat& other) { *this = other; }
  BigFloat& operator=(const BigFloat& other) {
    if (this == &other) return *this;
    *value_ = *other.value_;
    std::copy_n(other.limbs_, limb_count, limbs_);
    mpfr_custom_move(value_, limbs_);
    return *this;
  }

  /// `x` rounded, which is exact for Bits >= 53.
  static BigFloat from_double(double x) {
    BigFloat r;
    mpfr_set_d(r.value_, x, MPFR_RNDN);
    return r;
  }

  /// The nearest value to the rational number `x`.
  static BigFloat from_rational(const Rational& x) {
    BigFloat r;
    mpfr_set_q(r.value_, x.mpq(), MPFR_RNDN);
    return r;
  }

  /// The nearest double.
  double to_double() const { return mpfr_get_d(value_, MPFR_RNDN); }

  /// The exact value. Throws InvalidInput for NaN and infinities.
  Rational to_rational() const;

  /// A decimal form that reads back as the same value.
  std::string text() const;

  /// The square root; NaN for a negative number.
  BigFloat square_root() const {
    BigFloat r;
    mpfr_sqrt(r.value_, value_, MPFR_RNDN);
    return r;
  }

  /// The MPFR number, valid as long as this object is.
  mpfr_srcptr mpfr() const { return value_; }

  BigFloat& operator+=(const BigFloat& b) { return set<mpfr_add>(*this, b); }
  BigFloat& operator-=(const BigFloat& b) { return set<mpfr_sub>(*this, b); }
  BigFloat& operator*=(const BigFloat& b) { return set<mpfr_mul>(*this, b); }
  BigFloat& operator/=(const BigFloat& b) { return set<mpfr_div>(*this, b); }

  friend BigFloat operator+(const BigFloat& a, const BigFloat& b) { return BigFloat().set<mpfr_add>(a, b); }
  friend BigFloat operator-(const BigFloat& a, const BigFloat& b) { return BigFloat().set<mpfr_sub>(a, b); }
  friend BigFloat operator*(const BigFloat& a, const BigFloat& b) { return BigFloat().set<mpfr_mul>(a, b); }
  friend BigFloat operator/(const BigFloat& a, const BigFloat& b) { return BigFloat().set<mpfr_div>(a, b); }
  friend BigFloat operator-(BigFloat a) {
    mpfr_neg(a.value_, a.value_, MPFR_RNDN);
    return a;
  }

  friend bool operator==(const BigFloat& a, const BigFloat& b) { return mpfr_equal_p(a.value_, b.value_) != 0; }
  friend std::partial_ordering operator<=>(const BigFloat& a, const BigFloat& b) {
    if (mpfr_unordered_p(a.value_, b.value_) != 0) return std::partial_ordering::unordered;
    return mpfr_cmp(a.value_, b.value_) <=> 0;
  }

 private:
  static constexpr std::size_t limb_count = (Bits + GMP_NUMB_BITS - 1) / GMP_NUMB_BITS;
  using Operation = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);

  template <Operation f>
  BigFloat& set(const BigFloat& a, const BigFloat& b) {
    f(value_, a.value_, b.value_, MPFR_RNDN);
    return *this;
  }

  mpfr_t value_;
  mp_limb_t limbs_[limb_count] = {};
};

template <int Bits>
Rational BigFloat<Bits>::to_rational() const {
  if (mpfr_number_p(value_) == 0) throw InvalidInput("number", "a rational number cannot be NaN or infinite");
  mpq_t q;
  mpq_init(q);
  mpfr_get_q(q, value_);
  Rational r = Rational::from_mpq(q);
  mpq_clear(q);
  return r;
}

template <int Bits>
std::string BigFloat<Bits>::text() const {
  // 1 + ceil(Bits log10(2)) digits tell all values of this precision apart.
  constexpr int digits = 1 + (Bits * 30103 + 99999) / 100000;
  const int length = mpfr_snprintf(nullptr, 0, "%.*Rg", digits, value_);
  std::string s(static_cast<std::size_t>(length) + 1, '\0');
  mpfr_snprintf(s.data(), s.size(), "%.*Rg", digits, value_);
  s.pop_back();
  return s;
}

namespace detail {

/// "113 bits" for Bits = 113.
template <int Bits>
constexpr auto bits_text = [] {
  constexpr std::size_t digits = Bits < 10 ? 1 : Bits < 100 ? 2 : Bits < 1000 ? 3 : Bits < 10000 ? 4 : 5;
  std::array<char, digits + 5> s{};
  std::copy_n(" bits", 5, s.begin() + digits);
  for (int i = digits - 1, rest = Bits; i >= 0; --i, rest /= 10)
    s[static_cast<std::size_t>(i)] = static_cast<char>('0' + rest % 10);
  return s;
}();

}  // namespace detail

template <int Bits>
struct ScalarTraits<BigFloat<Bits>> {
  static constexpr std::string_view name{detail::bits_text<Bits>.data(), detail::bits_text<Bits>.size()};
  static constexpr bool exact = false;
  static constexpr bool decided = true;
  static constexpr bool ordered = true;
  static constexpr bool prefers_reciprocal = false;

  static BigFloat<Bits> from_int(std::int64_t i) { return BigFloat<Bits>(i); }
  static Truth is_zero(const BigFloat<Bits>& x) { return truth(mpfr_zero_p(x.mpfr()) != 0); }
  static Truth less(const BigFloat<Bits>& x, const BigFloat<Bits>& y) { return truth(x < y); }
  static BigFloat<Bits> sqrt(const BigFloat<Bits>& x) { return x.square_root(); }
  static std::string text(const BigFloat<Bits>& x) { return x.text(); }
};

}  // namespace torse
