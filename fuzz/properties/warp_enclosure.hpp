// enclosure.warp, enclosure.rational_warp: the certified warp angle against angles at parameters.
#pragma once

#include <vector>

#include "torse/fuzz/draw/net.hpp"
#include "torse/fuzz/draw/space_map.hpp"
#include "torse/fuzz/property.hpp"

namespace torse::fuzz {

/// D = 3: polynomial nets, D = 4: homogeneous rows.
template <int D>
struct WarpEnclosures {
  struct In {
    Net<D> net;                    ///< with doubles, its numbers are those
    bool doubles = false;          ///< whether the surface is also given in doubles
    int tolerance = 3;             ///< of the enclosure: 10^-tolerance
    int intervals = 1000;          ///< its budget
    Rational limit{1};             ///< degrees, for the decision
    SpaceMap motion;               ///< a motion or similarity
    std::vector<Rational> shares;  ///< of each piece, where the angle is computed
    template <class Self, class Visitor>
    static void fields(Self& in, Visitor& visit) {
      visit("net", in.net);
      visit("doubles", in.doubles);
      visit("tolerance", in.tolerance);
      visit("intervals", in.intervals);
      visit("limit", in.limit);
      visit("motion", in.motion);
      visit("shares", in.shares);
    }
  };

  static const PropertyInfo& info();
  static In draw(Choices& choices, const Scale& scale, Labels& labels);
  static void check(const In& in, Labels& labels);
};

}  // namespace torse::fuzz
