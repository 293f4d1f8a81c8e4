// What the library asks of a scalar beyond + - * /: one table per type, `ScalarTraits<S>`.
//   is_zero, less        predicates, three-valued
//   from_int             the image of an integer
//   as_text              a readable form
//   add_product          y += a b, where an arithmetic can do it in place
#pragma once

#include <cstdint>
#include <string>

#include "torse/scalar/truth.hpp"

namespace torse {

/// The table of a scalar type. A specialisation has
///   static constexpr std::string_view name;      a short name, "double", "Q", ...
///   static constexpr bool exact;                 no operation rounds
///   static constexpr bool decided;               is_zero (and less) never answer unknown
///   static constexpr bool ordered;               `less` is there and the field is ordered
///   static constexpr bool prefers_reciprocal;    x/a, y/a, z/a cost less as one reciprocal and three products
///   static S from_int(std::int64_t);             the image of an integer
///   static Truth is_zero(const S&);
///   static Truth less(const S&, const S&);       ordered fields only
///   static S sqrt(const S&);                     real fields only
///   static std::string text(const S&);
/// See docs/add-a-scalar.md.
template <class S>
struct ScalarTraits;

/// The image of the integer `i` in S.
template <class S>
S from_int(std::int64_t i) {
  return ScalarTraits<S>::from_int(i);
}

/// The image of num/den in S. Throws DivisionByZero where den is zero in S.
template <class S>
S ratio(std::int64_t num, std::int64_t den) {
  return from_int<S>(num) / from_int<S>(den);
}

/// Whether x is zero.
template <class S>
Truth is_zero(const S& x) {
  return ScalarTraits<S>::is_zero(x);
}

/// Whether x and y are equal.
template <class S>
Truth equal(const S& x, const S& y) {
  return ScalarTraits<S>::is_zero(x - y);
}

/// Whether x < y in an ordered field.
template <class S>
Truth less(const S& x, const S& y) {
  return ScalarTraits<S>::less(x, y);
}

/// A readable form of x.
template <class S>
std::string as_text(const S& x) {
  return ScalarTraits<S>::text(x);
}

/// y += a b. Arithmetics with costly temporaries provide `ScalarTraits<S>::add_product`.
template <class S>
void add_product(S& y, const S& a, const S& b) {
  if constexpr (requires { ScalarTraits<S>::add_product(y, a, b); }) {
    ScalarTraits<S>::add_product(y, a, b);
  } else {
    y += a * b;
  }
}

}  // namespace torse
