// The input of a case: numbers that every arithmetic holds exactly.
//   Case              the numbers, as floats of 24 bits
//   draw_case         from levels and a seed
//   Inputs<S>, lift   the same in an arithmetic, each number an input of its own
//   input_file        as a file for torse construct and torse study autopsy
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "torse/algebra/eigen.hpp"
#include "torse/scalar/builtin.hpp"
#include "torse/spline/knots.hpp"
#include "torse/studies/design.hpp"

namespace torse::studies {

using FloatPoint = std::array<float, 3>;

/// A curve, a second row of points, and the constants of all routes.
struct Case {
  int degree = 1;
  std::vector<float> knots;      ///< the papers' list, clamped
  std::vector<FloatPoint> c;     ///< the given row
  std::vector<FloatPoint> e;     ///< a second row, for what transforms surfaces
  std::vector<float> weights;    ///< of c
  std::vector<float> e_weights;  ///< of e
  float lambda = 0;              ///< L*
  float m = 0;                   ///< M*
  float sigma = 1;
  float share = 0;                    ///< between 0 and 1: a parameter, and a factor of rulings
  std::array<FloatPoint, 3> anchors;  ///< d_0, d_{L/2} and d_L of three different nets

  int last() const { return static_cast<int>(c.size()) - 1; }
};

/// Deterministic: the same on every machine.
Case draw_case(const Levels& levels, std::uint64_t seed);

/// The numbers in S.
template <class S>
struct Inputs {
  KnotList<S> u;
  std::vector<Vec<S, 3>> c;
  std::vector<Vec<S, 3>> e;
  std::vector<S> weights;
  std::vector<S> e_weights;
  S lambda;
  S m;
  S sigma;
  S share;
  std::array<Vec<S, 3>, 3> anchors;
};

/// Lifts by make(float, number of the input), the numbers counting from 0 in the order of Case's members.
template <class S, class Make>
Inputs<S> lift(const Case& in, Make make) {
  std::size_t slot = 0;
  const auto scalar = [&](float x) { return make(x, slot++); };
  const auto list = [&](const std::vector<float>& xs) {
    std::vector<S> result;
    for (const float x : xs) result.push_back(scalar(x));
    return result;
  };
  const auto point = [&](const FloatPoint& x) {
    Vec<S, 3> result;
    for (std::size_t j = 0; j < 3; ++j) result[static_cast<int>(j)] = scalar(x[j]);
    return result;
  };
  const auto row = [&](const std::vector<FloatPoint>& xs) {
    std::vector<Vec<S, 3>> result;
    for (const FloatPoint& x : xs) result.push_back(point(x));
    return result;
  };
  // Braces evaluate from left to right.
  return Inputs<S>{KnotList<S>(in.degree, list(in.knots)),
                   row(in.c),
                   row(in.e),
                   list(in.weights),
                   list(in.e_weights),
                   scalar(in.lambda),
                   scalar(in.m),
                   scalar(in.sigma),
                   scalar(in.share),
                   {point(in.anchors[0]), point(in.anchors[1]), point(in.anchors[2])}};
}

/// All numbers in the order of their slots.
std::vector<float> numbers_of(const Case& in);

/// JSON text of {"torse": 1, "type": "construct", "method": "bspline", ...} with hexadecimal numbers, d_0 the first
/// anchor.
std::string input_file(const Case& in);

/// "0x1.8p-3", exactly.
std::string hex_text(double x);

}  // namespace torse::studies
