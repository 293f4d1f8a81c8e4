// Digits are moved about as text, so that nothing is shared with the parser of numbers.
#include "torse/fuzz/draw/spelling.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "torse/fuzz/draw/numbers.hpp"

namespace torse::fuzz {
namespace {

Rational power(int base, int exponent) {
  Rational result(1);
  for (int i = 0; i < exponent; ++i) result *= Rational(base);
  return result;
}

bool is_integer(const Rational& x) { return x.denominator_bits() == 1; }

/// The least k >= 0 with x base^k an integer; none up to `most`.
std::optional<int> places_of(Rational x, int base, int most) {
  for (int k = 0; k <= most; ++k) {
    if (is_integer(x)) return k;
    x *= Rational(base);
  }
  return std::nullopt;
}

/// The hexadecimal digits of a natural number given by decimal ones: long division by 16.
std::string hexadecimal(std::string decimal) {
  std::string digits;
  do {
    std::string quotient;
    int rest = 0;
    for (const char c : decimal) {
      rest = rest * 10 + (c - '0');
      if (!quotient.empty() || rest >= 16) quotient += static_cast<char>('0' + rest / 16);
      rest %= 16;
    }
    digits += "0123456789abcdef"[rest];
    decimal = quotient;
  } while (!decimal.empty());
  return {digits.rbegin(), digits.rend()};
}

std::string zeros(Choices& choices) { return std::string(choices.below(3), '0'); }

std::string sign_text(Choices& choices, bool negative) { return negative ? "-" : choices.once_in(6) ? "+" : ""; }

/// The digits with a point before the last `places` of them.
std::string with_point(std::string digits, std::size_t places) {
  if (places == 0) return digits;
  if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
  return digits.insert(digits.size() - places, 1, '.');
}

std::string exponent_text(Choices& choices, const char* letters, int exponent) {
  if (exponent == 0 && choices.below(2) == 0) return {};
  const std::string sign = exponent < 0 ? "-" : choices.once_in(2) ? "+" : "";
  const std::string letter(1, letters[choices.below(2)]);
  return letter + sign + zeros(choices) + std::to_string(exponent < 0 ? -exponent : exponent);
}

std::string fraction_text(Choices& choices, const Rational& x) {
  const Rational size = x.sign() < 0 ? -x : x;
  std::string text = size.text();
  std::string denominator = "1";
  if (const std::size_t slash = text.find('/'); slash != std::string::npos) {
    denominator = text.substr(slash + 1);
    text.erase(slash);
  }
  const Rational factor(choices.between(1, 9));
  const auto times_factor = [&](const std::string& digits) { return (Rational::from_text(digits) * factor).text(); };
  const std::string sign = sign_text(choices, x.sign() < 0);
  const std::string above = zeros(choices) + times_factor(text);
  return sign + above + '/' + zeros(choices) + times_factor(denominator);
}

/// |x| = digits * base^-k, then the point anywhere and an exponent that makes up for it.
std::string decimal_text(Choices& choices, const Rational& x, int k) {
  const Rational size = x.sign() < 0 ? -x : x;
  k += choices.between(0, 3);
  const std::string digits = (size * power(10, k)).text();
  const int places = choices.between(0, 4) == 0 ? k : choices.between(0, static_cast<int>(digits.size()) + 2);
  const std::string lead = choices.once_in(8) ? zeros(choices) : "";
  const std::string sign = sign_text(choices, x.sign() < 0);
  return sign + lead + with_point(digits, static_cast<std::size_t>(places)) + exponent_text(choices, "eE", places - k);
}

std::string hexadecimal_text(Choices& choices, const Rational& x, int k) {
  const Rational size = x.sign() < 0 ? -x : x;
  k += choices.between(0, 5);
  std::string digits = hexadecimal((size * power(2, k)).text());
  const int places = choices.between(0, static_cast<int>(digits.size()) + 1);
  if (choices.once_in(2)) {
    std::ranges::transform(digits, digits.begin(), [](char c) { return c >= 'a' ? static_cast<char>(c - 32) : c; });
  }
  std::string text = sign_text(choices, x.sign() < 0);
  text += choices.once_in(2) ? "0X" : "0x";
  text += zeros(choices) + with_point(digits, static_cast<std::size_t>(places));
  return text + exponent_text(choices, "pP", 4 * places - k);
}

struct Rule {
  std::string_view name;
  std::vector<std::string_view> patterns;  ///< # stands for digits
};

constexpr std::string_view nul("#\0#", 3);

const std::vector<Rule>& rules() {
  static const std::vector<Rule> list{
      {"word", {"NaN", "nan", "inf", "-Infinity", "infinity", "null", "true", "one", "#x", "#f", "#d0"}},
      {"empty", {""}},
      {"zero denominator", {"#/0", "-#/000", "0/0", "+0/0"}},
      {"fraction", {"#/", "/#", "#/-#", "#/+#", "#/#/#", "#.5/#", "#/#.5", "#/#e1", "#e1/#", "0x#/#", "#/0x#", "#//#"}},
      {"point", {"#.", ".#", "#.e#", "#.#.#", ".", "-.#", "#,#", "#..#"}},
      {"exponent", {"#e", "#e+", "#E-", "#e#.5", "e#", "#ee#", "#e--#", "#e#e#", "#e0x1", "#e#p#"}},
      {"hexadecimal",
       {"0x", "0xp#", "0x.8", "0x#.", "0x#.p1", "0xg", "x#", "0x#p", "0x#pf", "#p#", "#a", "0x#p1.5", "0x0x#", "-0x",
        "0x-#", "0x#e+1"}},
      {"sign", {"--#", "+-#", "-", "+", "#-", "#+", "-+#", "#-#"}},
      {"blank", {" #", "# ", "# #", "- #", "#/ #", "#\t", "\n#", "#e #", " "}},
      {"other character",
       {"#_#", "#'#", "$#", "#%", "(#)", "\xd9\xa1", "\xef\xbc\x91", "\xe2\x88\x92#", "#*#", "#L", nul}},
      {"exponent too large", {"1e4001", "-1e-4001", "#e99999999999999999999999", "0x1p20001", "0x1p-20001", "0e4001"}},
  };
  return list;
}

}  // namespace

std::string spelled(Choices& choices, const Rational& x) {
  constexpr int most_places = 400;
  const std::uint64_t kind = choices.below(8);
  if (kind >= 2 && kind <= 4) {
    if (const auto k = places_of(x, 10, most_places)) return decimal_text(choices, x, *k);
  }
  if (kind == 5 || kind == 6) {
    if (const auto k = places_of(x, 2, most_places)) return hexadecimal_text(choices, x, *k);
  }
  return kind == 7 ? fraction_text(choices, x) : x.text();
}

BadSpelling draw_bad_spelling(Choices& choices) {
  const Rule& rule = rules()[choices.below(rules().size())];
  const std::string_view pattern = rule.patterns[choices.below(rule.patterns.size())];
  std::string text;
  for (const char c : pattern) {
    if (c == '#') {
      text += std::to_string(choices.below(100) + 1);
    } else {
      text += c;
    }
  }
  return {rule.name, text};
}

bool is_json_number(std::string_view text) {
  const auto digits = [&text] {
    const std::size_t count = std::min(text.find_first_not_of("0123456789"), text.size());
    const std::string_view run = text.substr(0, count);
    text.remove_prefix(count);
    return run;
  };
  const auto skip = [&text](std::string_view any_of) {
    const bool there = !text.empty() && any_of.find(text.front()) != std::string_view::npos;
    if (there) text.remove_prefix(1);
    return there;
  };
  skip("-");
  const std::string_view whole = digits();
  if (whole.empty() || (whole.size() > 1 && whole.front() == '0')) return false;
  if (skip(".") && digits().empty()) return false;
  if (skip("eE")) {
    skip("+-");
    if (digits().empty()) return false;
  }
  return text.empty();
}

}  // namespace torse::fuzz
