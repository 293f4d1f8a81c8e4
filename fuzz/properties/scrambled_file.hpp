// text.scrambled: files after random changes of their bytes.
#pragma once

#include "torse/fuzz/draw/damage.hpp"
#include "torse/fuzz/property.hpp"

namespace torse::fuzz {

struct ScrambledFile {
  struct In {
    Bytes text;
    template <class Self, class Visitor>
    static void fields(Self& in, Visitor& visit) {
      visit("text", in.text);
    }
  };

  static const PropertyInfo& info();
  static In draw(Choices& choices, const Scale& scale, Labels& labels);
  static void check(const In& in, Labels& labels);
};

}  // namespace torse::fuzz
