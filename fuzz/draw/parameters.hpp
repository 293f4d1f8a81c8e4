// L*, M* and sigma of the linear construction, and parameters in general.
//   draw_parameter      anywhere on the line          draw_off_knots      but not at a knot
//   parameter_kind      in a word                     draw_inside         in a piece of the domain
//   Functions, draw_functions                         L*, M*, sigma
#pragma once

#include <string_view>

#include "torse/exact/rational/rational.hpp"
#include "torse/fuzz/choices.hpp"
#include "torse/fuzz/scale.hpp"
#include "torse/spline/knots.hpp"

namespace torse::fuzz {

/// Before the domain (the simplest), at a knot, close to one, within the domain, at a huge value of either sign, or any
/// number.
Rational draw_parameter(Choices& choices, const Scale& scale, const KnotList<Rational>& u);
/// The same moved off the knots.
Rational draw_off_knots(Choices& choices, const Scale& scale, const KnotList<Rational>& u);
/// A parameter of the closed piece k, most often an inner one.
Rational draw_inside(Choices& choices, const KnotList<Rational>& u, int k);

/// "knot", "near" (within 2^-20 of the length of the list), "huge" (beyond 2^20 lengths), "inside" or "outside" the
/// domain.
std::string_view parameter_kind(const KnotList<Rational>& u, const Rational& x);

/// The constants of FJ21.7.1; FJ07.13 has sigma = 1.
struct Functions {
  Rational lambda{-1};
  Rational m{-2};
  Rational sigma{1};

  template <class Self, class Visitor>
  static void fields(Self& in, Visitor& visit) {
    visit("lambda", in.lambda);
    visit("m", in.m);
    visit("sigma", in.sigma);
  }
};

/// L* anywhere, M* off the knots, sometimes the same; sigma not zero, 1 unless `rational`.
Functions draw_functions(Choices& choices, const Scale& scale, const KnotList<Rational>& u, bool rational);

}  // namespace torse::fuzz
