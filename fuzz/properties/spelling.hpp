// text.spelling: numbers in all their spellings, and texts that are no numbers.
#pragma once

#include <optional>

#include "torse/fuzz/property.hpp"

namespace torse::fuzz {

struct Spelling {
  struct In {
    Bytes text;
    std::optional<Rational> value;  ///< none for a text that is no number
    template <class Self, class Visitor>
    static void fields(Self& in, Visitor& visit) {
      visit("text", in.text);
      visit("value", in.value);
    }
  };

  static const PropertyInfo& info();
  static In draw(Choices& choices, const Scale& scale, Labels& labels);
  static void check(const In& in, Labels& labels);
};

}  // namespace torse::fuzz
