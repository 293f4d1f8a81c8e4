// A constant that has not met its modulus yet: a small exact fraction.
//   Constant      num/den in lowest terms, den > 0, both within 64 bits; + - * / checked
#pragma once

#include <concepts>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "torse/scalar/errors.hpp"
#include "torse/scalar/int128.hpp"

namespace torse {

/// A rational number num/den with den > 0 in lowest terms. `from_int<Zp>(3) / from_int<Zp>(4)` is one until it meets an
/// element of some Z/p, which tells it the modulus. Operations throw Error where a result leaves 64 bits: such a
/// computation has to start from an element with a modulus.
struct Constant {
  std::int64_t num = 0;
  std::int64_t den = 1;

  /// The integer i. Throws Error for i >= 2^63.
  template <std::integral T>
  static Constant integer(T i) {
    if (!std::in_range<std::int64_t>(i)) throw Error("an integer constant has to lie in [-2^63, 2^63)");
    return {static_cast<std::int64_t>(i), 1};
  }

  /// "num" or "num/den".
  std::string text() const {
    std::string s = std::to_string(num);
    if (den != 1) s.append("/").append(std::to_string(den));
    return s;
  }

  friend Constant operator+(Constant a, Constant b) {
    Constant r;
    if (a.den == 1 && b.den == 1 && !__builtin_add_overflow(a.num, b.num, &r.num)) return r;
    return reduced(int128{a.num} * b.den + int128{b.num} * a.den, int128{a.den} * b.den);
  }
  friend Constant operator-(Constant a) { return reduced(-int128{a.num}, a.den); }
  friend Constant operator-(Constant a, Constant b) {
    Constant r;
    if (a.den == 1 && b.den == 1 && !__builtin_sub_overflow(a.num, b.num, &r.num)) return r;
    return reduced(int128{a.num} * b.den - int128{b.num} * a.den, int128{a.den} * b.den);
  }
  friend Constant operator*(Constant a, Constant b) {
    Constant r;
    if (a.den == 1 && b.den == 1 && !__builtin_mul_overflow(a.num, b.num, &r.num)) return r;
    return reduced(int128{a.num} * b.num, int128{a.den} * b.den);
  }
  /// Throws DivisionByZero for b = 0.
  friend Constant operator/(Constant a, Constant b) {
    if (b.num == 0) throw DivisionByZero();
    const int sign = b.num < 0 ? -1 : 1;
    return reduced(int128{a.num} * b.den * sign, int128{a.den} * b.num * sign);
  }

 private:
  /// num/den in lowest terms, for den > 0.
  static Constant reduced(int128 num, int128 den) {
    int128 g = den;
    for (int128 r = num < 0 ? -num : num; r != 0;) {
      const int128 next = g % r;
      g = r;
      r = next;
    }
    num /= g;
    den /= g;
    constexpr int128 least = std::numeric_limits<std::int64_t>::min();
    constexpr int128 largest = std::numeric_limits<std::int64_t>::max();
    if (num < least || num > largest || den > largest) {
      throw Error("a constant without a modulus left the range of 64-bit fractions");
    }
    return {static_cast<std::int64_t>(num), static_cast<std::int64_t>(den)};
  }
};

}  // namespace torse
