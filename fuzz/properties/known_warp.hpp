// enclosure.known: the warp angle of hyperbolic paraboloids, whose largest value is known exactly.
#pragma once

#include <vector>

#include "torse/fuzz/draw/space_map.hpp"
#include "torse/fuzz/property.hpp"

namespace torse::fuzz {

/// c(t) = (t, 0, 0) and d(t) = (t, 1, h t): sin^2 of the warp angle is h^2 / (1 + h^2 + h^2 t^2).
struct KnownWarp {
  struct In {
    Rational h{1};
    std::vector<Rational> knots{Rational(0), Rational(1)};  ///< of a net of degree 1, increasing
    SpaceMap motion = identity_map();
    Rational limit{45};  ///< degrees
    template <class Self, class Visitor>
    static void fields(Self& in, Visitor& visit) {
      visit("h", in.h);
      visit("knots", in.knots);
      visit("motion", in.motion);
      visit("limit", in.limit);
    }
  };

  static const PropertyInfo& info();
  static In draw(Choices& choices, const Scale& scale, Labels& labels);
  static void check(const In& in, Labels& labels);
};

}  // namespace torse::fuzz
