// Numbers as text, read exactly into any exact field.
//   BadNumber        what is wrong with a text
//   NumberText       a number taken apart          split_number     text -> NumberText
//   parse_number     text -> S
// Accepted: decimal numbers "12", "-1.5e-3", fractions "p/q" of digits, hexadecimal floats "0x1.8p-3". A sign may only
// stand in front; digits stand on both sides of a point; there are no blanks, no NaN and no infinity.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "torse/scalar/concepts.hpp"
#include "torse/scalar/errors.hpp"

namespace torse {

/// A text that is no number, or one beyond the limits; `what()` is "expected ..., found ...".
class BadNumber : public Error {
 public:
  using Error::Error;
};

/// The number (-) digits / denominator * exponent_base^exponent; digits are to the given base, the denominator to
/// base 10.
struct NumberText {
  bool negative = false;
  int base = 10;
  std::string digits;
  std::string denominator = "1";
  int exponent_base = 10;
  long exponent = 0;
};

/// Takes a number apart. Throws BadNumber for any other text, a zero denominator, and numbers beyond limits.hpp.
NumberText split_number(std::string_view text);

namespace detail {

template <Ring S>
S power(S base, long exponent) {
  S result = from_int<S>(1);
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 == 1) result *= base;
    base *= S(base);
  }
  return result;
}

/// The integer with these digits: halves joined by a product, so that long numbers take few long products.
template <Ring S>
S digits_value(std::string_view digits, int base) {
  constexpr std::size_t chunk = 15;
  if (digits.size() <= chunk) {
    std::int64_t value = 0;
    for (char c : digits) value = value * base + (c <= '9' ? c - '0' : (c | 0x20) - 'a' + 10);
    return from_int<S>(value);
  }
  const std::size_t low = digits.size() / 2;
  const std::string_view head = digits.substr(0, digits.size() - low);
  return digits_value<S>(head, base) * power(from_int<S>(base), static_cast<long>(low)) +
         digits_value<S>(digits.substr(head.size()), base);
}

}  // namespace detail

/// The exact value of a number. Throws BadNumber, and DivisionByZero where the denominator is zero in S only.
template <ExactField S>
S parse_number(std::string_view text) {
  const NumberText number = split_number(text);
  S value = detail::digits_value<S>(number.digits, number.base);
  if (number.denominator != "1") value /= detail::digits_value<S>(number.denominator, 10);
  const S base = from_int<S>(number.exponent_base);
  if (number.exponent > 0) value *= detail::power(base, number.exponent);
  if (number.exponent < 0) value /= detail::power(base, -number.exponent);
  return number.negative ? -value : value;
}

}  // namespace torse
