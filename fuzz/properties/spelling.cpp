#include "torse/fuzz/properties/spelling.hpp"

#include "torse/exact/rational/cpp_rational.hpp"
#include "torse/fuzz/draw/numbers.hpp"
#include "torse/fuzz/draw/spelling.hpp"
#include "torse/io/number.hpp"

namespace torse::fuzz {
namespace {

/// m 10^e or any other number.
Rational draw_value(Choices& choices, const Scale& scale) {
  if (choices.below(3) != 1) return draw_number(choices, scale);
  Rational value = draw_integer(choices, scale.bits);
  const int exponent = choices.between(0, 20);
  const bool small = choices.once_in(2);
  for (int i = 0; i < exponent; ++i) small ? value /= Rational(10) : value *= Rational(10);
  return value;
}

/// The exponents at which the format ends.
Spelling::In draw_extreme(Choices& choices) {
  const int m = choices.between(-9, 9);
  const bool hex = choices.once_in(2);
  const bool small = choices.once_in(2);
  Rational power(1);
  for (int i = 0; i < 4000; ++i) power *= Rational(hex ? 32 : 10);
  const std::string text = (m < 0 ? "-" : "") + std::string(hex ? "0x" : "") + std::to_string(m < 0 ? -m : m) +
                           (hex ? 'p' : 'e') + (small ? "-" : "") + (hex ? "20000" : "4000");
  return {{text}, small ? Rational(m) / power : Rational(m) * power};
}

const char* kind_of(const std::string& text) {
  if (text.find_first_of("xX") != std::string::npos) return "hexadecimal";
  if (text.find('/') != std::string::npos) return "fraction";
  if (text.find_first_of("eE") != std::string::npos) return "exponent";
  return text.find('.') != std::string::npos ? "point" : "integer";
}

/// The value as text, or what is wrong with the number.
template <class S>
std::string read(const std::string& text) {
  try {
    return parse_number<S>(text).text();
  } catch (const BadNumber&) {
    return "refused";
  }
}

}  // namespace

const PropertyInfo& Spelling::info() {
  static const PropertyInfo info{
      "text.spelling",
      "a number is read as its exact value in every spelling, by both arithmetics; any other text is refused",
      200,
      {"kind=integer", "kind=point", "kind=exponent", "kind=fraction", "kind=hexadecimal", "kind=extreme",
       "broken=word", "broken=empty", "broken=zero denominator", "broken=fraction", "broken=point", "broken=exponent",
       "broken=hexadecimal", "broken=sign", "broken=blank", "broken=other character", "broken=exponent too large"}};
  return info;
}

Spelling::In Spelling::draw(Choices& choices, const Scale& scale, Labels& labels) {
  if (choices.once_in(500)) {
    labels.add("kind", "extreme");
    return draw_extreme(choices);
  }
  if (choices.below(3) == 2) {
    const BadSpelling bad = draw_bad_spelling(choices);
    labels.add("broken", std::string(bad.rule));
    return {{bad.text}, std::nullopt};
  }
  Rational x = draw_value(choices, scale);
  const std::string text = spelled(choices, x);
  labels.add("kind", kind_of(text));
  return {{text}, std::move(x)};
}

void Spelling::check(const In& in, Labels&) {
  const std::string meant = in.value ? in.value->text() : "refused";
  require(read<Rational>(in.text.text) == meant, "read as another number, or not as it should be");
  require(read<CppRational>(in.text.text) == meant, "read as another number by Boost's rationals");
}

}  // namespace torse::fuzz
