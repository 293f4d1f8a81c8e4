// enclosure.plate: the flat plate of a developable surface against the surface.
#pragma once

#include "torse/fuzz/draw/net.hpp"
#include "torse/fuzz/property.hpp"

namespace torse::fuzz {

struct PlateBounds {
  struct In {
    Net<4> net;
    int digits = 2;  ///< the tolerance is 10^-digits of the size of the surface
    int marks = 3;   ///< parts between marked rulings
    bool mirrored = false;
    template <class Self, class Visitor>
    static void fields(Self& in, Visitor& visit) {
      visit("net", in.net);
      visit("digits", in.digits);
      visit("marks", in.marks);
      visit("mirrored", in.mirrored);
    }
  };

  static const PropertyInfo& info();
  static In draw(Choices& choices, const Scale& scale, Labels& labels);
  static void check(const In& in, Labels& labels);
};

}  // namespace torse::fuzz
