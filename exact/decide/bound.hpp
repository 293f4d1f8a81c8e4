// How large the determinant of a piece can be: what decides how many primes prove that it vanishes.
//   determinant_bits      for piece k of a ruled surface over Q
//
// The determinant of piece k is a form f of degree D(n-1), D = 3 for points and 4 for homogeneous rows, whose entries
// are the partial derivatives, divided by n here, of the 2 D coordinate forms of the two Bezier rows of the piece.
// 1. An integer multiple. De Boor's algorithm turns control points into Bezier points. Level r = 1..n divides by
//    differences v_hi - v_lo of integer knots; let K_r be a common multiple of those of its level, and W = K_1 ... K_n.
//    Let Q_j be a common denominator of coordinate j of the 2(n+1) control points. Then W Q_j times a Bezier point's
//    coordinate j is an integer, and g = W^D Q_1 ... Q_D f has integer coefficients (times s^{DN-i} t^i).
// 2. Its size. Bezier points are convex combinations of the control points, so coordinate j of either is at most m_j,
// the
//    largest |coordinate j| of the control points. An entry is a sum of binomials C(n-1, i) times a Bezier coordinate
//    (D = 4) or the difference of two (D = 3): its 1-norm, the sum of the absolute coefficients, is at most 2^{n-1} m_j
//    or 2^n m_j. The 1-norm is submultiplicative, and the determinant has D! terms with one factor from each column:
//      |g|_1 <= 6 prod_j (2^n W Q_j m_j)  (D = 3),    |g|_1 <= 24 prod_j (2^{n-1} W Q_j m_j)  (D = 4).
// 3. Hence f = 0 as soon as every coefficient vanishes modulo distinct primes whose product is not smaller than that,
//    none of them dividing a denominator: a multiple of the product that is smaller than it is zero.
#pragma once

#include <span>
#include <vector>

#include "torse/algebra/point.hpp"
#include "torse/exact/decide/integer.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/spline/knots.hpp"

namespace torse {

/// A number b such that the integer form g above of piece k has coefficients below 2^b in absolute value; b <= 0 says
/// that it is zero. `v` holds the knots as integers. D = 3: points, D = 4: homogeneous rows.
template <int D>
long determinant_bits(const KnotList<Rational>& u, const std::vector<Integer>& v, std::span<const Vec<Rational, D>> c,
                      std::span<const Vec<Rational, D>> d, int k);

}  // namespace torse
