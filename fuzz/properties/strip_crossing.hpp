// strip.crossing: rulings that cross by construction are never said not to, and those that cannot are never said to.
#pragma once

#include <string>

#include "torse/fuzz/draw/polygons.hpp"
#include "torse/fuzz/property.hpp"
#include "torse/spline/knots.hpp"

namespace torse::fuzz {

struct StripCrossing {
  struct In {
    KnotList<Rational> knots = bezier_knots<Rational>(1);
    std::vector<Point3> c{};
    std::vector<Point3> d{};
    std::string kind{"onward"};  ///< tells whether rulings cross, by construction

    template <class Self, class Visitor>
    static void fields(Self& in, Visitor& visit) {
      visit("knots", in.knots);
      visit("c", in.c);
      visit("d", in.d);
      visit("kind", in.kind);
    }
  };

  static const PropertyInfo& info();
  static In draw(Choices& choices, const Scale& scale, Labels& labels);
  static void check(const In& in, Labels& labels);
};

}  // namespace torse::fuzz
