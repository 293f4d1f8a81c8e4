// Weights of control points: 1 is the simplest.
//   draw_weights      nonzero ones          draw_row_weights      zeros too          weight_kind      in a word
#pragma once

#include <string_view>
#include <vector>

#include "torse/exact/rational/rational.hpp"
#include "torse/fuzz/choices.hpp"
#include "torse/fuzz/scale.hpp"

namespace torse::fuzz {

/// `count` weights: all 1; small positive ones; ratios up to 2^40; both signs; almost equal.
std::vector<Rational> draw_weights(Choices& choices, const Scale& scale, int count);
/// The same, or some of them 0: for homogeneous rows, which may be points at infinity. Files have no such weights.
std::vector<Rational> draw_row_weights(Choices& choices, const Scale& scale, int count);

/// "zero" (one of them), "negative" (both signs), "one" (all are equal), "extreme" (a ratio above 2^20), "positive" (or
/// all negative).
std::string_view weight_kind(const std::vector<Rational>& weights);

}  // namespace torse::fuzz
