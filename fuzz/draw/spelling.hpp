// Numbers as texts: every way of writing an exact value that a file may use, and texts that are no numbers.
//   spelled          a value in one of its spellings: p/q, decimal, with an exponent, hexadecimal
//   BadSpelling      a text that is no number, with the rule that it breaks       draw_bad_spelling    one of them
//   is_json_number   whether a text may stand in JSON without quotes
#pragma once

#include <string>
#include <string_view>

#include "torse/exact/rational/rational.hpp"
#include "torse/fuzz/choices.hpp"

namespace torse::fuzz {

/// A text whose value is x: "p/q", not always in lowest terms; and where the denominator allows it a decimal number
/// with or without a point and an exponent, or a hexadecimal float. The text is made from the value, digit by digit;
/// the simplest one is that of x.text().
std::string spelled(Choices& choices, const Rational& x);

/// A text that is no number.
struct BadSpelling {
  std::string_view rule;  ///< what it breaks, as "point" or "zero denominator"
  std::string text;
};

/// A text that docs/formats.md does not allow for a number.
BadSpelling draw_bad_spelling(Choices& choices);

/// Whether the text is a number of RFC 8259: no plus sign and no leading zero, no fraction, nothing hexadecimal.
bool is_json_number(std::string_view text);

}  // namespace torse::fuzz
