// routes: all ways to the net of FJ07.13 lead to the same net.
#pragma once

#include "torse/fuzz/draw/parameters.hpp"
#include "torse/fuzz/draw/polygons.hpp"
#include "torse/fuzz/property.hpp"

namespace torse::fuzz {

struct Routes {
  struct In {
    KnotList<Rational> knots = bezier_knots<Rational>(1);
    std::vector<Point3> c{};
    Point3 d0 = Point3::Constant(Rational());
    Functions functions{};

    template <class Self, class Visitor>
    static void fields(Self& in, Visitor& visit) {
      visit("knots", in.knots);
      visit("c", in.c);
      visit("d0", in.d0);
      visit("functions", in.functions);
    }
  };

  static const PropertyInfo& info();
  static In draw(Choices& choices, const Scale& scale, Labels& labels);
  static void check(const In& in, Labels& labels);
};

}  // namespace torse::fuzz
