// The grammar of numbers.
#include "torse/io/number.hpp"

#include <algorithm>

#include "torse/io/limits.hpp"
#include "torse/io/text.hpp"

namespace torse {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_hex_digit(char c) { return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }

/// What is left of a text while it is read from the left.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : rest_(text) {}

  bool skip(std::string_view any_of) {
    if (rest_.empty() || any_of.find(rest_.front()) == std::string_view::npos) return false;
    rest_.remove_prefix(1);
    return true;
  }

  template <class Predicate>
  std::string_view take(Predicate accepts) {
    const auto end = std::find_if_not(rest_.begin(), rest_.end(), accepts);
    const std::string_view run = rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
    rest_.remove_prefix(run.size());
    return run;
  }

  std::string_view rest() const { return rest_; }
  bool done() const { return rest_.empty(); }

 private:
  std::string_view rest_;
};

[[noreturn]] void fail(std::string_view text) {
  throw BadNumber("expected a number such as 12, -1.5e-3, \"2/3\" or \"0x1.8p-3\", found " + in_quotes(text));
}

/// Skips a sign if there is one; true for a minus.
bool read_sign(Scanner& scanner) {
  if (scanner.skip("-")) return true;
  scanner.skip("+");
  return false;
}

/// The exponent after its letter. Throws BadNumber beyond the limit.
long read_exponent(Scanner& scanner, std::string_view text, long limit) {
  const bool negative = read_sign(scanner);
  const std::string_view digits = scanner.take(is_digit);
  if (digits.empty()) fail(text);
  long value = 0;
  for (char c : digits) value = std::min(value * 10 + (c - '0'), limit + 1);
  if (value > limit) {
    throw BadNumber("expected an exponent from -" + std::to_string(limit) + " to " + std::to_string(limit) +
                    ", found " + in_quotes(text));
  }
  return negative ? -value : value;
}

}  // namespace

NumberText split_number(std::string_view text) {
  if (text.size() > limits::number_characters) {
    throw BadNumber("expected a number of at most " + std::to_string(limits::number_characters) +
                    " characters, found " + std::to_string(text.size()));
  }
  NumberText number;
  Scanner scanner(text);
  number.negative = read_sign(scanner);
  const bool hex = scanner.rest().starts_with("0x") || scanner.rest().starts_with("0X");
  if (hex) {
    scanner.skip("0");
    scanner.skip("xX");
    number.base = 16;
    number.exponent_base = 2;
  }
  const auto accepts = hex ? is_hex_digit : is_digit;
  number.digits = scanner.take(accepts);
  if (number.digits.empty()) fail(text);
  if (!hex && scanner.skip("/")) {
    number.denominator = scanner.take(is_digit);
    if (number.denominator.empty() || !scanner.done()) fail(text);
    if (number.denominator.find_first_not_of('0') == std::string::npos) {
      throw BadNumber("expected a denominator that is not zero, found " + in_quotes(text));
    }
    return number;
  }
  long places = 0;
  if (scanner.skip(".")) {
    const std::string_view fraction = scanner.take(accepts);
    if (fraction.empty()) fail(text);
    number.digits += fraction;
    places = static_cast<long>(fraction.size()) * (hex ? 4 : 1);
  }
  if (scanner.skip(hex ? "pP" : "eE")) {
    number.exponent = read_exponent(scanner, text, hex ? limits::binary_exponent : limits::decimal_exponent);
  }
  if (!scanner.done()) fail(text);
  number.exponent -= places;
  return number;
}

}  // namespace torse
