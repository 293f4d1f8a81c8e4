// What keeps a ruled surface from lying flat, and where its strips have to be cut for the integration; decided over Q.
//   PieceStrip       a piece: its polynomials, oriented, and the zeros of their factors
//   piece_strips     all pieces of positive length
//   Joint            the normals on both sides of a knot            joint_of
//   find_obstacles   poles, rails that meet, folds
#pragma once

#include <array>
#include <span>
#include <vector>

#include "torse/developable/unroll.hpp"
#include "torse/exact/decide/singularities.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/exact/roots/real_roots.hpp"

namespace torse {

/// A piece on [begin, end]. Its polynomials are in tau = (t - begin)/(end - begin).
struct PieceStrip {
  int piece;
  Rational begin;
  Rational end;
  StripForms<Rational> forms;
  /// Where a rail or its speed across the rulings vanishes, 0 < tau < 1, in order: between two of them every factor has
  /// one sign, and the rates are analytic.
  std::vector<RealRoot> breaks;
};

/// The pieces of a ruled spline with homogeneous rows p, q. A piece without a surface or with a pole keeps the signs of
/// its factors and has no breaks.
std::vector<PieceStrip> piece_strips(const KnotList<Rational>& u, std::span<const Vec<Rational, 4>> p,
                                     std::span<const Vec<Rational, 4>> q);

/// Where two strips meet: normals on the side that the sheet turns to the viewer, each with 1 or -1 as its largest
/// coordinate, and the common ruling from c to d.
struct Joint {
  std::array<Rational, 3> before;
  std::array<Rational, 3> after;
  std::array<Rational, 3> ruling;
};

/// Both strips have a surface and no poles, and the ruling between them has a length.
Joint joint_of(const PieceStrip& left, const PieceStrip& right);

/// Where and why the surface cannot be unrolled as one plate; none if it can.
///   pole         the weight of a rail is 0
///   vanishing    the rails meet, other than at the two ends of the surface
///   no_surface   the rulings sweep a line only
///   stationary   the sheet turns back along a ruling, inside a piece or at a knot: its normal changes to the opposite
///   edge         the normals at the two ends of the rulings are more than 90 degrees apart; on a developable surface
///                this is where the edge of regression lies between the rails, and the sheet folds over itself
std::vector<SingularSet> find_obstacles(const std::vector<PieceStrip>& strips);

}  // namespace torse
