// repair.nearest: the nearest developable net.
#pragma once

#include <vector>

#include "torse/fuzz/draw/net.hpp"
#include "torse/fuzz/property.hpp"

namespace torse::fuzz {

struct NearestNets {
  struct In {
    Net<4> net;
    std::vector<Rational> shares;  ///< of the domain, where surface points are compared
    template <class Self, class Visitor>
    static void fields(Self& in, Visitor& visit) {
      visit("net", in.net);
      visit("shares", in.shares);
    }
  };

  static const PropertyInfo& info();
  static In draw(Choices& choices, const Scale& scale, Labels& labels);
  static void check(const In& in, Labels& labels);
};

}  // namespace torse::fuzz
