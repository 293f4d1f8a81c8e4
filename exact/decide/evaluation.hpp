// The determinant of a piece at integer parameters, in integers.
//   PieceEvaluator<D>     D = 3: points of a polynomial surface, D = 4: homogeneous rows
//
// The determinant of FJ21.C3.1 (D = 4) or FJ07.3 (D = 3) on piece k = [a, b] is that of the points c_0^{n-1}(x) =
// c[x^<n-1>, a], c_1^{n-1}(x) = c[x^<n-1>, b] and those of d, a polynomial in x of degree D(n-1): it is zero iff it
// vanishes at D(n-1) + 1 parameters. Columns are multiplied by their common denominators; inserting the argument a or b
// gives four polygons of degree n-1, once; at each x they share the values of the basis functions of degree n-1. All
// divisions are by differences of integer knots, and each level is multiplied by a common multiple of its differences
// instead.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "torse/algebra/point.hpp"
#include "torse/exact/decide/integer.hpp"
#include "torse/exact/rational/rational.hpp"

namespace torse {

/// Evaluates the determinant of one piece, up to a positive factor.
template <int D>
class PieceEvaluator {
 public:
  /// Piece k of the surface of degree n with the given integer knots and control points. The knots have to outlive it.
  PieceEvaluator(int degree, const std::vector<Integer>& knots, std::span<const Vec<Rational, D>> c,
                 std::span<const Vec<Rational, D>> d, int k);

  /// Whether the determinant is zero at a + i (b - a) for i = 0, 1, ..., D(n-1), and so everywhere.
  bool vanishes();

 private:
  static constexpr std::size_t size = static_cast<std::size_t>(D);
  using Row = std::array<Integer, size>;

  const Integer& knot(std::size_t level, std::size_t i) const { return knots_[end_ + i - level]; }
  std::vector<Integer> level_factors(std::size_t level) const;
  std::vector<Row> scaled_points(std::span<const Vec<Rational, D>> c, std::span<const Vec<Rational, D>> d) const;
  void insert_ends(const std::vector<Row>& points);
  void evaluate_basis(const Integer& x);
  bool vanishes_at(const Integer& x);

  std::size_t degree_;
  const std::vector<Integer>& knots_;
  std::size_t end_;                              // b is its knot
  std::vector<std::vector<Integer>> factors_;    // of each level 1 ... n: common multiple / difference
  std::array<std::vector<Row>, size> polygons_;  // rows of the matrix as polygons of degree n-1
  std::vector<Integer> basis_, next_;
  std::array<Row, size> matrix_;
};

extern template class PieceEvaluator<3>;
extern template class PieceEvaluator<4>;

}  // namespace torse
