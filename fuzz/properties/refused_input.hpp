// refused: the documented errors of src/spline and src/developable appear exactly when they should.
#pragma once

#include "torse/fuzz/draw/parameters.hpp"
#include "torse/fuzz/draw/polygons.hpp"
#include "torse/fuzz/property.hpp"

namespace torse::fuzz {

struct RefusedInput {
  struct In {
    std::string call{"linear_net"};
    std::vector<Rational> list{};  ///< knots, in order or not
    int degree = 1;
    std::vector<Point3> c{};
    std::vector<Point3> d{};
    std::vector<Rational> weights{};  ///< as many as c
    Functions functions{};            ///< any, sigma and M* too
    Rational x{0};

    template <class Self, class Visitor>
    static void fields(Self& in, Visitor& visit) {
      visit("call", in.call);
      visit("list", in.list);
      visit("degree", in.degree);
      visit("c", in.c);
      visit("d", in.d);
      visit("weights", in.weights);
      visit("functions", in.functions);
      visit("x", in.x);
    }
  };

  static const PropertyInfo& info();
  static In draw(Choices& choices, const Scale& scale, Labels& labels);
  static void check(const In& in, Labels& labels);
};

}  // namespace torse::fuzz
