// Splines as one polynomial a piece, and back to control points by symmetric functions. No de Boor here.
//   Pieces<D>        the polynomials of a curve on the intervals between its breaks
//   pieces_of        those of control points, by the recursion of the basis functions
//   control_row      the control points over any knot list on which the curve is a spline
//   value_at         a value of one piece
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "torse/algebra/eigen.hpp"
#include "torse/fuzz/plain/polynomial.hpp"
#include "torse/spline/knots.hpp"

namespace torse::fuzz::plain {

template <int D>
using PolyRow = std::array<Poly, static_cast<std::size_t>(D)>;

/// Row j is the curve on [breaks[j], breaks[j + 1]].
template <int D>
struct Pieces {
  std::vector<Rational> breaks;
  std::vector<PolyRow<D>> rows;

  int count() const { return static_cast<int>(rows.size()); }
};

/// The knots of the domain without repetition.
std::vector<Rational> breaks_of(const KnotList<Rational>& u);

template <int D>
Pieces<D> pieces_of(const KnotList<Rational>& u, const std::vector<Vec<Rational, D>>& control);

/// The control points c[u_i, ..., u_{i+n-1}], where the blossom of t^j is e_j / C(n, j), e_j the elementary symmetric
/// function. The domain of u is part of that of the curve, and each knot is repeated as often as the curve needs. A
/// control point that acts on no piece is that of a piece close by.
template <int D>
std::vector<Vec<Rational, D>> control_row(const Pieces<D>& curve, const KnotList<Rational>& u);

template <int D>
Vec<Rational, D> value_at(const PolyRow<D>& row, const Rational& t) {
  Vec<Rational, D> x;
  for (int j = 0; j < D; ++j) x[j] = value(row[static_cast<std::size_t>(j)], t);
  return x;
}

template <int D>
PolyRow<D> derivative(const PolyRow<D>& row) {
  PolyRow<D> result;
  for (std::size_t j = 0; j < row.size(); ++j) result[j] = derivative(row[j]);
  return result;
}

}  // namespace torse::fuzz::plain
