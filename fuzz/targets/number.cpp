// The text of numbers: what is accepted, and its value, against paths that share no code with the reader.
//   The grammar      by a table of states
//   The value        decimals and hexadecimal floats as strtod rounds them, fractions as GMP reads them
//   The text again   of the value, read back
#include <cmath>
#include <cstdlib>
#include <string>

#include "torse/exact/rational/rational.hpp"
#include "torse/fuzz/targets/target.hpp"
#include "torse/io/limits.hpp"
#include "torse/io/number.hpp"

namespace torse::targets {
namespace {

/// What a text is by docs/formats.md, apart from the limits.
enum class Kind { none, number, fraction, zero_denominator };

bool digit(char c) { return '0' <= c && c <= '9'; }
bool hex_digit(char c) { return digit(c) || ('a' <= (c | 0x20) && (c | 0x20) <= 'f'); }

/// A finite automaton: S sign read, D digits, P point read, F digits behind the point, E exponent's letter read, G its
/// sign, X its digits, Q the stroke of a fraction, R its denominator.
Kind kind_of(std::string_view text) {
  const std::string_view bare = text.substr(!text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0);
  const bool hex = bare.starts_with("0x") || bare.starts_with("0X");
  char state = 'S';
  bool zero = true;
  for (char c : hex ? bare.substr(2) : bare) {
    const bool mantissa = hex ? hex_digit(c) : digit(c);
    const bool letter = (c | 0x20) == (hex ? 'p' : 'e');
    if ((state == 'S' || state == 'D') && mantissa) {
      state = 'D';
    } else if (state == 'D' && c == '.') {
      state = 'P';
    } else if (state == 'D' && c == '/' && !hex) {
      state = 'Q';
    } else if ((state == 'P' || state == 'F') && mantissa) {
      state = 'F';
    } else if ((state == 'D' || state == 'F') && letter) {
      state = 'E';
    } else if (state == 'E' && (c == '+' || c == '-')) {
      state = 'G';
    } else if ((state == 'E' || state == 'G' || state == 'X') && digit(c)) {
      state = 'X';
    } else if ((state == 'Q' || state == 'R') && digit(c)) {
      state = 'R';
      zero = zero && c == '0';
    } else {
      return Kind::none;
    }
  }
  if (state == 'R') return zero ? Kind::zero_denominator : Kind::fraction;
  return state == 'D' || state == 'F' || state == 'X' ? Kind::number : Kind::none;
}

/// Whether the exponent of a number is within the limits.
bool within_limits(const std::string& text) {
  const bool hex = text.find_first_of("xX") != std::string::npos;
  const std::size_t letter = text.find_first_of(hex ? "pP" : "eE");
  if (letter == std::string::npos) return true;
  const double exponent = std::fabs(std::strtod(text.c_str() + letter + 1, nullptr));
  return exponent <= static_cast<double>(hex ? limits::binary_exponent : limits::decimal_exponent);
}

void check_value(const std::string& text, Kind kind, const Rational& value) {
  if (kind == Kind::fraction) {
    require(value == Rational::from_text(text.substr(text[0] == '+' ? 1 : 0)), "GMP reads the same fraction");
  } else {
    const double nearest = std::strtod(text.c_str(), nullptr);
    require(value.to_double() == nearest, "strtod reads the same double");
  }
  require(parse_number<Rational>(value.text()) == value, "the text of the value has the value");
}

void check(const std::string& text) {
  const Kind kind = kind_of(text);
  try {
    const Rational value = parse_number<Rational>(text);
    require(kind == Kind::number || kind == Kind::fraction, "only numbers are accepted");
    check_value(text, kind, value);
  } catch (const BadNumber&) {
    const bool refused = kind == Kind::none || kind == Kind::zero_denominator || !within_limits(text);
    require(refused, "every number within the limits is accepted");
  }
}

}  // namespace
}  // namespace torse::targets

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  torse::targets::check(std::string(torse::targets::text_of(data, size)));
  return 0;
}
