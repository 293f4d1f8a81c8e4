// float, double and long double as scalars: rounded arithmetic whose predicates speak of the represented values.
#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>
#include <string_view>

#include "torse/scalar/traits.hpp"

namespace torse {

template <std::floating_point S>
struct ScalarTraits<S> {
  static constexpr std::string_view name = std::same_as<S, float>    ? "float"
                                           : std::same_as<S, double> ? "double"
                                                                     : "long double";
  static constexpr bool exact = false;
  static constexpr bool decided = true;
  static constexpr bool ordered = true;
  static constexpr bool prefers_reciprocal = false;

  static S from_int(std::int64_t i) { return static_cast<S>(i); }
  static Truth is_zero(S x) { return truth(x == 0); }
  static Truth less(S x, S y) { return truth(x < y); }
  static S sqrt(S x) { return std::sqrt(x); }

  /// The shortest-safe decimal form: reading it back gives the same value.
  static std::string text(S x) {
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, "%.*Lg", std::numeric_limits<S>::max_digits10, static_cast<long double>(x));
    return buffer;
  }
};

}  // namespace torse
