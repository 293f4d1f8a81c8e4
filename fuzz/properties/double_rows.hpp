// double.rows: every construction and transformation of rows in doubles, within its running error.
#pragma once

#include <string>
#include <vector>

#include "torse/fuzz/draw/doubles.hpp"
#include "torse/fuzz/property.hpp"

namespace torse::fuzz {

/// A function of rows computed in doubles is within its running error of the exact result, and what it makes is a
/// developable surface within that error: every coefficient of the determinant of every piece may be zero.
struct DoubleRows {
  struct In {
    std::string function;         ///< a name of functions()
    DoubleNet net;                ///< points, d_0, L*, M* and knots
    std::vector<double> weights;  ///< of the points; the rows are w (1, c)
    double weight = 1;            ///< of d_0
    double factor = 1;            ///< sigma, alpha, beta or a new knot's place, as the function needs one

    template <class Self, class Visitor>
    static void fields(Self& in, Visitor& visit) {
      visit("function", in.function);
      visit("net", in.net);
      visit("weights", in.weights);
      visit("weight", in.weight);
      visit("factor", in.factor);
    }
  };

  static const PropertyInfo& info();
  static In draw(Choices& choices, const Scale& scale, Labels& labels);
  static void check(const In& in, Labels& labels);
};

}  // namespace torse::fuzz
