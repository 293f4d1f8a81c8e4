// text.number: what is written for a number is read back as that number.
#pragma once

#include "torse/fuzz/draw/numbers.hpp"
#include "torse/fuzz/property.hpp"

namespace torse::fuzz {

struct NumberText {
  struct In {
    Rational x;
    template <class Self, class Visitor>
    static void fields(Self& in, Visitor& visit) {
      visit("x", in.x);
    }
  };

  static const PropertyInfo& info();
  static In draw(Choices& choices, const Scale& scale, Labels& labels);
  static void check(const In& in, Labels& labels);
};

}  // namespace torse::fuzz
