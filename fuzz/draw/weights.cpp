#include "torse/fuzz/draw/weights.hpp"

#include <algorithm>

#include "torse/fuzz/draw/numbers.hpp"

namespace torse::fuzz {
namespace {

Rational draw_weight(Choices& choices, const Scale& scale, std::uint64_t kind) {
  switch (kind) {
    case 0:
      return Rational(1);
    case 1:
      return Rational(1) + draw_fraction(choices, 3) / Rational(8);
    case 2:
      return draw_positive(choices, scale);
    case 3:
      return draw_nonzero(choices, scale);
    case 4:
      return power_of_two(choices.between(0, 40));
    default:
      return Rational(1) + draw_fraction(choices, 4) * power_of_two(-60);
  }
}

Rational size(const Rational& x) { return x.sign() < 0 ? -x : x; }

}  // namespace

std::vector<Rational> draw_weights(Choices& choices, const Scale& scale, int count) {
  const std::uint64_t kind = choices.below(6);
  std::vector<Rational> weights;
  for (int i = 0; i < count; ++i) weights.push_back(draw_weight(choices, lean(scale, count), kind));
  return weights;
}

std::vector<Rational> draw_row_weights(Choices& choices, const Scale& scale, int count) {
  std::vector<Rational> weights = draw_weights(choices, scale, count);
  if (choices.once_in(5)) {
    for (Rational& w : weights) {
      if (choices.once_in(3)) w = Rational();
    }
  }
  return weights;
}

std::string_view weight_kind(const std::vector<Rational>& weights) {
  Rational least = size(weights.front());
  Rational most = least;
  bool negative = false;
  bool equal = true;
  for (const Rational& w : weights) {
    least = std::min(least, size(w));
    most = std::max(most, size(w));
    negative = negative || w.sign() != weights.front().sign();
    equal = equal && w == weights.front();
  }
  if (least.sign() == 0) return "zero";
  if (negative) return "negative";
  if (equal) return "one";
  return most > least * power_of_two(20) ? "extreme" : "positive";
}

}  // namespace torse::fuzz
