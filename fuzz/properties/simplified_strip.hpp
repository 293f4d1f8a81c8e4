// fit.simplified: a simpler surface is as near as it says, has the same corners and is simpler.
#pragma once

#include "torse/fuzz/draw/polygons.hpp"
#include "torse/fuzz/property.hpp"
#include "torse/spline/knots.hpp"

namespace torse::fuzz {

struct SimplifiedStrip {
  struct In {
    KnotList<Rational> knots = bezier_knots<Rational>(1);
    std::vector<Point3> c{};
    std::vector<Point3> d{};
    Rational tolerance{1};
    std::vector<Rational> shares{};  ///< of each piece, where distances are looked at

    template <class Self, class Visitor>
    static void fields(Self& in, Visitor& visit) {
      visit("knots", in.knots);
      visit("c", in.c);
      visit("d", in.d);
      visit("tolerance", in.tolerance);
      visit("shares", in.shares);
    }
  };

  static const PropertyInfo& info();
  static In draw(Choices& choices, const Scale& scale, Labels& labels);
  static void check(const In& in, Labels& labels);
};

}  // namespace torse::fuzz
