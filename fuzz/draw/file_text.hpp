// The files that torse reads, as text with what it means.
//   SplineMeant, ParameterMeant, FileMeant     the exact numbers of a file
//   DrawnFile        a tree that means them        draw_file    of any type
#pragma once

#include <string>
#include <vector>

#include "torse/fuzz/draw/json.hpp"
#include "torse/fuzz/input_text.hpp"
#include "torse/fuzz/labels.hpp"
#include "torse/fuzz/scale.hpp"

namespace torse::fuzz {

/// A curve, or one row of a ruled surface: the papers' knot list, points and weights.
struct SplineMeant {
  int degree = 0;
  std::vector<Rational> knots;
  std::vector<Vec<Rational, 3>> points;
  std::vector<Rational> weights;
  template <class Self, class Visitor>
  static void fields(Self& in, Visitor& visit) {
    visit("degree", in.degree);
    visit("knots", in.knots);
    visit("points", in.points);
    visit("weights", in.weights);
  }
};

/// A parameter of a construction: one number, a vector or coefficients.
struct ParameterMeant {
  std::string key;
  std::vector<Rational> numbers;
  template <class Self, class Visitor>
  static void fields(Self& in, Visitor& visit) {
    visit("key", in.key);
    visit("numbers", in.numbers);
  }
};

/// What a file means. `d` is empty for a curve and for "construct", `method` and `parameters` for all but "construct".
struct FileMeant {
  std::string type;
  SplineMeant c;
  SplineMeant d;
  std::string method;
  std::vector<ParameterMeant> parameters;
  template <class Self, class Visitor>
  static void fields(Self& in, Visitor& visit) {
    visit("type", in.type);
    visit("c", in.c);
    visit("d", in.d);
    visit("method", in.method);
    visit("parameters", in.parameters);
  }
};

/// A valid file before it is laid out.
struct DrawnFile {
  FileMeant meant;
  JsonTree tree;
};

/// A file of any type. Knots are absent where they may be, or the papers' list, or the CAD list; weights are absent
/// where they may be.
DrawnFile draw_file(Choices& choices, const Scale& scale, Labels& labels);

}  // namespace torse::fuzz
