// The concept ladder: Ring < Field < OrderedField < RealField. An algorithm asks for the lowest rung it needs.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

#include "torse/scalar/traits.hpp"

namespace torse {

/// A commutative ring with one whose default value is zero and whose operators return values (no expression templates).
template <class S>
concept Ring = std::semiregular<S> && requires(const S& a, const S& b, S& y) {
  { a + b } -> std::same_as<S>;
  { a - b } -> std::same_as<S>;
  { a* b } -> std::same_as<S>;
  { -a } -> std::same_as<S>;
  { y += a } -> std::same_as<S&>;
  { y -= a } -> std::same_as<S&>;
  { y *= a } -> std::same_as<S&>;
  { ScalarTraits<S>::from_int(std::int64_t{}) } -> std::same_as<S>;
  { ScalarTraits<S>::is_zero(a) } -> std::same_as<Truth>;
  { ScalarTraits<S>::text(a) } -> std::convertible_to<std::string>;
  { ScalarTraits<S>::name } -> std::convertible_to<std::string_view>;
  { ScalarTraits<S>::exact } -> std::convertible_to<bool>;
  { ScalarTraits<S>::decided } -> std::convertible_to<bool>;
};

/// A ring with division; dividing by a known zero throws DivisionByZero (floating scalars follow IEEE 754 instead).
template <class S>
concept Field = Ring<S> && requires(const S& a, const S& b, S& y) {
  { a / b } -> std::same_as<S>;
  { y /= a } -> std::same_as<S&>;
};

/// A field with a (possibly undecided) order.
template <class S>
concept OrderedField = Field<S> && ScalarTraits<S>::ordered && requires(const S& a, const S& b) {
  { ScalarTraits<S>::less(a, b) } -> std::same_as<Truth>;
};

/// An ordered field with square roots.
template <class S>
concept RealField = OrderedField<S> && requires(const S& a) {
  { ScalarTraits<S>::sqrt(a) } -> std::same_as<S>;
};

/// A field whose zero test is always decided and whose operations never round.
template <class S>
concept ExactField = Field<S> && ScalarTraits<S>::exact && ScalarTraits<S>::decided;

}  // namespace torse
