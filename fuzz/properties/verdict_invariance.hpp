// verdict.affine, verdict.projective: nets that are moved, rewritten and moved again.
#pragma once

#include <vector>

#include "torse/fuzz/draw/net.hpp"
#include "torse/fuzz/draw/space_map.hpp"
#include "torse/fuzz/property.hpp"

namespace torse::fuzz {

/// D = 3: polynomial nets under affine maps, D = 4: homogeneous rows under projective ones. What is rewritten is
/// rewritten by the library.
template <int D>
struct VerdictInvariance {
  struct In {
    Net<D> net;
    SpaceMap map;
    Rational c_factor{1};  ///< of the rows c and d, for D = 4
    Rational d_factor{1};
    Rational begin{0};  ///< of the new domain
    Rational end{1};
    bool reversed = false;          ///< whether the parameter runs backwards
    bool swapped = false;           ///< whether c and d are exchanged
    bool elevated = false;          ///< whether the degree is raised
    std::vector<Rational> knots{};  ///< to be inserted
    template <class Self, class Visitor>
    static void fields(Self& in, Visitor& visit) {
      visit("net", in.net);
      visit("map", in.map);
      visit("c_factor", in.c_factor);
      visit("d_factor", in.d_factor);
      visit("begin", in.begin);
      visit("end", in.end);
      visit("reversed", in.reversed);
      visit("swapped", in.swapped);
      visit("elevated", in.elevated);
      visit("knots", in.knots);
    }
  };

  static const PropertyInfo& info();
  static In draw(Choices& choices, const Scale& scale, Labels& labels);
  static void check(const In& in, Labels& labels);
};

}  // namespace torse::fuzz
