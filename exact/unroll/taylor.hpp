// One step of the development, enclosed; for .cpp files only.
//   Step             what a step adds
//   taylor_step      by Taylor series with Cauchy's bound on what they leave out
//   breaking_step    across the interval of a break
//
// On |s| <= eta around the middle of a step the rates are analytic; a ball evaluation on |s| <= rho = 16 eta bounds
// |along - i across| by m and |turn| by g with g rho <= 1. The turned speed F = (along - i across) e^{-iT}, T' = turn,
// T(0) = 0, has |F| <= m e there, so its k-th Taylor coefficient is at most m e rho^-k, and the integral from 0 to eta
// of all that is beyond the order N is at most eta m e 16^-N 16/15.
#pragma once

#include <optional>

#include "torse/exact/unroll/stretch.hpp"

namespace torse {

/// What changes over a step.
struct Step {
  arb::Real turn;      ///< the angle by which the ruling turns clockwise
  arb::Complex chord;  ///< of P, for a ruling that points along 1 at the beginning
  arb::Real length_c;
  arb::Real length_d;
  arb::Real area;  ///< of the plane strip
};

/// The step from tau = from to to on a stretch that is not breaking; none where it is too long for this method, and it
/// has to be halved.
std::optional<Step> taylor_step(const Stretch& stretch, const Rational& from, const Rational& to);

/// The step over a breaking stretch. Of the turn only |turn| <= |e'| = |W' x W|/W.W is used, and that a curve is not
/// longer than its largest speed says.
Step breaking_step(const Stretch& stretch);

}  // namespace torse
