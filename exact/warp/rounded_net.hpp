// The double stage: the control net of a ruled surface in doubles, and its warp angle piece by piece.
//   RoundedNet<D>       knots and rows with bounds of their errors, D = 3: points, D = 4: homogeneous rows
//   rounded_net         of a surface in rationals or in doubles
//   rounded_quotient    sin^2 of the warp angle on a piece
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "torse/algebra/eigen.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/exact/warp/quotient.hpp"
#include "torse/spline/knots.hpp"

namespace torse {

/// A ruled surface up to a translation and a scaling. Each number differs from the exact one by at most the bound.
template <int D>
struct RoundedNet {
  int degree;
  std::vector<double> knots;  ///< the papers' list
  std::vector<Vec<double, D>> c;
  std::vector<Vec<double, D>> d;
  double knot_error;        ///< relative, of the difference of any two knots
  double coordinate_error;  ///< absolute
};

/// None where doubles cannot hold the surface: beyond their range, knots that coincide when rounded, a degree too high.
/// Points are translated by c_0 before they are rounded, so a large offset costs no accuracy.
template <int D>
std::optional<RoundedNet<D>> rounded_net(const KnotList<Rational>& u, std::span<const Vec<Rational, D>> c,
                                         std::span<const Vec<Rational, D>> d);

/// A surface given in doubles, which are taken as they are.
template <int D>
std::optional<RoundedNet<D>> rounded_net(const KnotList<double>& u, std::span<const Vec<double, D>> c,
                                         std::span<const Vec<double, D>> d);

/// sin^2 of the warp angle on the piece k, which is not empty; none where its net collapses or leaves the range of
/// doubles.
template <int D>
std::optional<RoundedQuotient> rounded_quotient(const RoundedNet<D>& net, int k);

}  // namespace torse
