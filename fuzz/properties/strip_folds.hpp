// strip.folds: whether a strip folds over is what Sturm's theorem says of the product of its normals.
#pragma once

#include "torse/fuzz/draw/net.hpp"

namespace torse::fuzz {

struct StripFolds {
  struct In {
    Net<4> net{};
    bool polynomial = true;

    template <class Self, class Visitor>
    static void fields(Self& in, Visitor& visit) {
      visit("net", in.net);
      visit("polynomial", in.polynomial);
    }
  };

  static const PropertyInfo& info();
  static In draw(Choices& choices, const Scale& scale, Labels& labels);
  static void check(const In& in, Labels& labels);
};

}  // namespace torse::fuzz
