// Cheap bounds of the warp angle on each piece of a polynomial surface in doubles, which settle most pieces. Those that
// they leave open need the quotient of quotient.hpp.
//   PieceBound          sin^2 at the ends of a piece from below, on all of it from above
//   piece_bounds        for all pieces
#pragma once

#include <vector>

#include "torse/exact/warp/rounded_net.hpp"

namespace torse {

/// Certified: sin^2 of the warp angle is at least at_begin and at_end at the ends of the piece, and at most `upper`
/// everywhere on it. Where the bound says nothing they are 0, 0 and infinity.
struct PieceBound {
  double at_begin = 0;
  double at_end = 0;
  double upper = detail::infinity;
};

/// The bounds of the given pieces, which are all pieces that are not empty, in order.
///
/// On a piece let a and b be multiples of c' and d' by the same factor, of degree n-1, and w_0 the blossom of w = d - c
/// at (t^<n-1>, begin), so that w = w_0 + h t (b - a) with t in [0, 1] and the length h of the piece (all of FJ07.3,
/// and a, b, w_0 share their degree). Then with the third coordinate of the cross products in an orthonormal frame
///   X = (a x b)_3, Y = (a x w_0)_3, Z = (b x w_0)_3
/// the third coordinates of the normals a x w and b x w are M = Y + h t X and N = Z + h t X, and
///   [a, b, w] = a_3 Z - b_3 Y + w_{0,3} X.
/// sin(warp) = |w| |[a, b, w]| / (|a x w| |b x w|), and |w| <= (|w|^2 + r^2) / (2r) for every r > 0, with equality for
/// |w| = r. So sin(warp) is at most the largest absolute quotient of the Bernstein coefficients of
///   [a, b, w] (|w|^2 + r^2)   and   2r M N,   both of degree 5n-3,
/// as long as the latter have one sign. The third axis is near the normals of the piece, r near |w|: the bound then
/// exceeds the maximum by little more than the variation of the normal.
///
/// Errors: after its largest coordinate, every factor has a relative error e from rounding, knots and coordinates. A
/// product of degree j in the factors is off by j e + (number of operations) 2^-53 relative to the product of the
/// largest coordinates, times the number of products of coordinates it sums up.
std::vector<PieceBound> piece_bounds(const RoundedNet<3>& net, const std::vector<int>& pieces);

}  // namespace torse
