// The largest warp angle of a ruled surface with a certificate, after docs/decisions/0004-warp-angle.md.
//   WarpOptions, WarpStage       accuracy and budget; which arithmetic was needed
//   WarpEnclosure, max_warp      bounds of the largest warp angle
//   warp_at_most                 whether it exceeds an angle
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "torse/algebra/eigen.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/exact/warp/angle.hpp"
#include "torse/scalar/truth.hpp"
#include "torse/spline/knots.hpp"

namespace torse {

/// What an enclosure aims at and what it may cost.
struct WarpOptions {
  double tolerance = 1e-3;  ///< relative width of the enclosure, between 1e-9 and 1
  long intervals =
      1'000'000;  ///< of the double stage, for quotients of degree 20 (polynomial cubics); see the decision
};

/// The arithmetics, in the order in which they are tried.
enum class WarpStage { rounded, balls, exact };
std::string_view name_of(WarpStage stage);

/// An isolated parameter between `lower` and `upper` (equal for a rational one) where a normal vanishes: the ruling has
/// length zero, or a boundary curve is stationary or tangent to the ruling. The angle is not defined there; its limit
/// is below the bounds of the enclosure.
struct WarpExclusion {
  int piece;
  Rational lower;
  Rational upper;
};

/// lower <= the supremum of the warp angle <= upper, in degrees, 0 to 90.
struct WarpEnclosure {
  double lower = 0;
  double upper = 0;
  int piece = 0;                          ///< where the angle reaches `lower`; 0 for a developable surface
  Rational parameter;                     ///< the knot list's parameter there
  std::vector<WarpExclusion> exclusions;  ///< each of them once, unless every piece they are on is developable
  WarpStage stage = WarpStage::rounded;   ///< the last one that was needed
  long intervals = 0;                     ///< sub-intervals looked at
  bool complete = true;  ///< the ends agree to the tolerance, or to 2^-1022; false where the budget ran out
};

/// Encloses the largest warp angle over all pieces of positive length. D = 3: points of a polynomial surface, D = 4:
/// homogeneous rows; S = Rational, or double, which is taken as the exact number it is. Developable pieces count as 0,
/// by exact decision. Throws InvalidInput naming "points" for rows that do not fit the knots, and for numbers not
/// finite.
template <class S, int D>
WarpEnclosure max_warp(const KnotList<S>& u, std::span<const Vec<S, D>> c, std::span<const Vec<S, D>> d,
                       const WarpOptions& options = {});

/// Whether the largest warp angle is at most `angle`; unknown where the budget ran out. Equality is decided for 0, 30,
/// 45 and 60 degrees; at other angles it exhausts the budget.
template <class S, int D>
Truth warp_at_most(const KnotList<S>& u, std::span<const Vec<S, D>> c, std::span<const Vec<S, D>> d, const Angle& angle,
                   const WarpOptions& options = {});

}  // namespace torse
