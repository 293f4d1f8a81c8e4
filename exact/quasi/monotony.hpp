// Whether a parametrization mapping is increasing, decided exactly for every degree.
//   Monotony             strict, weak or none        MonotonyVerdict     with a witness
//   decide_monotony      by the real roots of sigma' where the coefficients do not tell
#pragma once

#include <optional>

#include "torse/exact/rational/rational.hpp"
#include "torse/quasi/mapping.hpp"

namespace torse {

/// How sigma goes over its domain: strictly increasing, never decreasing but constant on a piece, or decreasing
/// somewhere.
enum class Monotony { strict, weak, none };

/// The answer with what shows it: for `weak` the middle of a piece on which sigma is constant, for `none` a parameter
/// inside a piece with sigma' < 0.
struct MonotonyVerdict {
  Monotony kind = Monotony::strict;
  std::optional<Rational> witness{};
};

/// Decides it. Coefficients that do not decrease are looked at first; else the sign of sigma' between its real roots
/// is taken piece by piece.
MonotonyVerdict decide_monotony(const Mapping<Rational>& sigma);

}  // namespace torse
