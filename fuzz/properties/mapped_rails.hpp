// rails.mapped: the ruled surface over a mapping is its rails exactly, and snapping changes the mapping as it says.
#pragma once

#include "torse/fuzz/draw/rails.hpp"

namespace torse::fuzz {

struct MappedRails {
  struct In {
    Rail c{};
    Rail d{};
    KnotList<Rational> knots = bezier_knots<Rational>(1);  ///< of the mapping, within the domain of c
    std::vector<Rational> beta{};                          ///< not decreasing, within the domain of d

    template <class Self, class Visitor>
    static void fields(Self& in, Visitor& visit) {
      visit("c", in.c);
      visit("d", in.d);
      visit("knots", in.knots);
      visit("beta", in.beta);
    }
  };

  static const PropertyInfo& info();
  static In draw(Choices& choices, const Scale& scale, Labels& labels);
  static void check(const In& in, Labels& labels);
};

}  // namespace torse::fuzz
