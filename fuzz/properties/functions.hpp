// functions: Lambda, M, sigma of a patch, their other forms and what becomes of them when the patch is rewritten.
#pragma once

#include "torse/fuzz/draw/parameters.hpp"
#include "torse/fuzz/draw/polygons.hpp"
#include "torse/fuzz/property.hpp"

namespace torse::fuzz {

struct FunctionsOfAPatch {
  struct In {
    std::vector<Row4> p{};  ///< a Bezier row on [0, 1]; the other one follows by FJ21.7.1
    Row4 q0 = Row4::Constant(Rational());
    Functions functions{};
    Rational t{0};
    std::vector<Rational> factors{};  ///< f_0, f_1, g_0, g_1 of the linear factors f and g
    Rational b{2};                    ///< of the Moebius parameter; not 0

    template <class Self, class Visitor>
    static void fields(Self& in, Visitor& visit) {
      visit("p", in.p);
      visit("q0", in.q0);
      visit("functions", in.functions);
      visit("t", in.t);
      visit("factors", in.factors);
      visit("b", in.b);
    }
  };

  static const PropertyInfo& info();
  static In draw(Choices& choices, const Scale& scale, Labels& labels);
  static void check(const In& in, Labels& labels);
};

}  // namespace torse::fuzz
