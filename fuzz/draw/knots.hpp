// Knot lists: one Bezier piece is the simplest.
//   draw_knots     of a degree, or of any          knot_kind      in a word
#pragma once

#include <string_view>

#include "torse/exact/rational/rational.hpp"
#include "torse/fuzz/choices.hpp"
#include "torse/fuzz/scale.hpp"
#include "torse/spline/knots.hpp"

namespace torse::fuzz {

/// A knot list of this degree with at most scale.pieces pieces: clamped at both ends, at one or at none, knots repeated
/// up to the limit, steps equal, integers, fractions or powers of two whose ratios reach 2^1000.
KnotList<Rational> draw_knots(Choices& choices, const Scale& scale, int degree);
/// The same of any degree up to scale.degree.
KnotList<Rational> draw_knots(Choices& choices, const Scale& scale);

/// "bezier" (one clamped piece); "extreme" (two neighbouring intervals with a ratio beyond 2^20); "full" (an inner knot
/// repeated as often as the degree, which is above 1); "repeated" (an inner knot repeated less often); "clamped",
/// "unclamped" (at both ends) or "mixed".
std::string_view knot_kind(const KnotList<Rational>& u);

}  // namespace torse::fuzz
