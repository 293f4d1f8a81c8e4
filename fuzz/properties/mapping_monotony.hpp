// mapping.monotony: whether a mapping increases is what Sturm's theorem says of its slope.
#pragma once

#include "torse/fuzz/draw/knots.hpp"
#include "torse/fuzz/property.hpp"

namespace torse::fuzz {

struct MappingMonotony {
  struct In {
    KnotList<Rational> knots = bezier_knots<Rational>(1);
    std::vector<Rational> beta{};

    template <class Self, class Visitor>
    static void fields(Self& in, Visitor& visit) {
      visit("knots", in.knots);
      visit("beta", in.beta);
    }
  };

  static const PropertyInfo& info();
  static In draw(Choices& choices, const Scale& scale, Labels& labels);
  static void check(const In& in, Labels& labels);
};

}  // namespace torse::fuzz
