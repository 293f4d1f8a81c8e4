#include "torse/fuzz/properties/number_text.hpp"

#include "torse/io/number.hpp"

namespace torse::fuzz {

const PropertyInfo& NumberText::info() {
  static const PropertyInfo info{"text.number",
                                 "a number that is written is read back as it was",
                                 500,
                                 {"sign=negative", "kind=fraction", "kind=integer"}};
  return info;
}

NumberText::In NumberText::draw(Choices& choices, const Scale& scale, Labels& labels) {
  In in{draw_number(choices, scale)};
  labels.add("sign", in.x.sign() < 0 ? "negative" : in.x.sign() > 0 ? "positive" : "zero");
  labels.add("kind", in.x.denominator_bits() > 1 ? "fraction" : "integer");
  return in;
}

void NumberText::check(const In& in, Labels&) {
  require(parse_number<Rational>(in.x.text()) == in.x, "the text is read as another number");
}

}  // namespace torse::fuzz
