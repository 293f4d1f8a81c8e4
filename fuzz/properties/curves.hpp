// curves: what src/spline does with a curve, beside the polynomials of its pieces.
#pragma once

#include "torse/fuzz/draw/polygons.hpp"
#include "torse/fuzz/property.hpp"

namespace torse::fuzz {

struct Curves {
  struct In {
    KnotList<Rational> knots = bezier_knots<Rational>(1);
    std::vector<Row4> rows{};
    std::vector<Rational> arguments{};  ///< as many as the degree, for a blossom of piece `piece`
    int piece = 1;
    Rational from{0};  ///< in the domain, from <= to
    Rational to{1};

    template <class Self, class Visitor>
    static void fields(Self& in, Visitor& visit) {
      visit("knots", in.knots);
      visit("rows", in.rows);
      visit("arguments", in.arguments);
      visit("piece", in.piece);
      visit("from", in.from);
      visit("to", in.to);
    }
  };

  static const PropertyInfo& info();
  static In draw(Choices& choices, const Scale& scale, Labels& labels);
  static void check(const In& in, Labels& labels);
};

}  // namespace torse::fuzz
