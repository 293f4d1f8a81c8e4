// formulas: the formulas that stand beside the constructions, each against its definition.
#pragma once

#include "torse/fuzz/draw/parameters.hpp"
#include "torse/fuzz/draw/polygons.hpp"
#include "torse/fuzz/property.hpp"

namespace torse::fuzz {

struct SmallFormulas {
  struct In {
    KnotList<Rational> knots = bezier_knots<Rational>(1);
    std::vector<Point3> c{};
    std::vector<Rational> weights{};  ///< as many as c, none 0
    Point3 d0 = Point3::Constant(Rational());
    Functions functions{};
    int piece = 1;
    Rational t{0};
    Rational x{2};                       ///< not 0
    Rational y{3};                       ///< not 0
    std::vector<Rational> polynomial{};  ///< Bernstein coefficients

    template <class Self, class Visitor>
    static void fields(Self& in, Visitor& visit) {
      visit("knots", in.knots);
      visit("c", in.c);
      visit("weights", in.weights);
      visit("d0", in.d0);
      visit("functions", in.functions);
      visit("piece", in.piece);
      visit("t", in.t);
      visit("x", in.x);
      visit("y", in.y);
      visit("polynomial", in.polynomial);
    }
  };

  static const PropertyInfo& info();
  static In draw(Choices& choices, const Scale& scale, Labels& labels);
  static void check(const In& in, Labels& labels);
};

}  // namespace torse::fuzz
