// The second, independent exact back end: Boost's cpp_rational, which shares no code with GMP.
//   CppRational       + - * /, total order, text
//   ScalarTraits<CppRational>
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <compare>
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "torse/scalar/errors.hpp"
#include "torse/scalar/traits.hpp"

namespace torse {

/// An element of Q. A thin wrapper: Boost's number converts implicitly from double, this type does not.
class CppRational {
 public:
  using Value =
      boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;

  /// Zero.
  CppRational() = default;

  /// The integer `i`.
  template <std::integral T>
  explicit CppRational(T i) : value_(i) {}

  /// Reads "p" or "p/q". Throws InvalidInput for other text and for q = 0.
  static CppRational from_text(const std::string& text) {
    CppRational r;
    try {
      r.value_ = Value(text);
    } catch (const std::exception&) {
      throw InvalidInput("number", "expected p or p/q, got \"" + text + '"');
    }
    return r;
  }

  /// "p" or "p/q" in lowest terms.
  std::string text() const { return value_.str(); }

  /// -1, 0 or 1.
  int sign() const { return value_.sign(); }

  CppRational& operator+=(const CppRational& b) {
    value_ += b.value_;
    return *this;
  }
  CppRational& operator-=(const CppRational& b) {
    value_ -= b.value_;
    return *this;
  }
  CppRational& operator*=(const CppRational& b) {
    value_ *= b.value_;
    return *this;
  }
  /// Throws DivisionByZero for b = 0.
  CppRational& operator/=(const CppRational& b) {
    if (b.sign() == 0) throw DivisionByZero();
    value_ /= b.value_;
    return *this;
  }

  friend CppRational operator+(CppRational a, const CppRational& b) { return std::move(a += b); }
  friend CppRational operator-(CppRational a, const CppRational& b) { return std::move(a -= b); }
  friend CppRational operator*(CppRational a, const CppRational& b) { return std::move(a *= b); }
  friend CppRational operator/(CppRational a, const CppRational& b) { return std::move(a /= b); }
  friend CppRational operator-(CppRational a) {
    a.value_ = -a.value_;
    return a;
  }

  friend bool operator==(const CppRational& a, const CppRational& b) { return a.value_ == b.value_; }
  friend std::strong_ordering operator<=>(const CppRational& a, const CppRational& b) {
    return a.value_.compare(b.value_) <=> 0;
  }

 private:
  Value value_;
};

template <>
struct ScalarTraits<CppRational> {
  static constexpr std::string_view name = "Q (cpp_rational)";
  static constexpr bool exact = true;
  static constexpr bool decided = true;
  static constexpr bool ordered = true;
  static constexpr bool prefers_reciprocal = false;

  static CppRational from_int(std::int64_t i) { return CppRational(i); }
  static Truth is_zero(const CppRational& x) { return truth(x.sign() == 0); }
  static Truth less(const CppRational& x, const CppRational& y) { return truth(x < y); }
  static std::string text(const CppRational& x) { return x.text(); }
};

}  // namespace torse
