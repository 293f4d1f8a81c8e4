// Numbers, knots and nets in doubles, drawn fast.
//   DoubleNet        the free parameters of FJ07.13 in doubles
//   draw_double_net  one of a given degree and size
//   draw_double      a double of a kind: small integers are the simplest
#pragma once

#include <vector>

#include "torse/fuzz/choices.hpp"
#include "torse/fuzz/input_text.hpp"
#include "torse/fuzz/labels.hpp"
#include "torse/spline/knots.hpp"

namespace torse::fuzz {

/// What doubles are drawn.
enum class DoubleKind { integer, dyadic, full, scattered };
inline constexpr int double_kinds = 4;
/// "integer", "dyadic", "full", "scattered"
const char* name_of(DoubleKind kind);

/// integer: |x| <= 8; dyadic: multiples of 2^-10 up to 64; full: 53 random bits in [-1, 1]; scattered: those times 2^e,
/// |e| <= 40.
double draw_double(Choices& choices, DoubleKind kind);

/// The free parameters of FJ07.13.
struct DoubleNet {
  int degree = 1;
  std::vector<double> knots = {0, 1};
  std::vector<Vec<double, 3>> c = {{0, 0, 0}, {1, 0, 0}};
  Vec<double, 3> d0 = {0, 0, 0};
  double lambda = 0;
  double m = 2;

  template <class Self, class Visitor>
  static void fields(Self& in, Visitor& visit) {
    visit("degree", in.degree);
    visit("knots", in.knots);
    visit("c", in.c);
    visit("d0", in.d0);
    visit("lambda", in.lambda);
    visit("m", in.m);
  }
};

/// Knots that are uniform, of unlike steps up to a ratio of 2^60, or repeated up to `degree` times; L* and M* generic,
/// equal, huge, near a knot or at one. Throws Discard where the steps vanish beside the knots.
DoubleNet draw_double_net(Choices& choices, int degree, int last, Labels& labels);

}  // namespace torse::fuzz
