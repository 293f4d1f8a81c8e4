// Control points in space: small integers are the simplest.
//   draw_vector, draw_nonzero_vector      one point          draw_polygon      a list of them
//   draw_matrix      an invertible map          mapped      a point under it          polygon_kind      in a word
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "torse/algebra/point.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/fuzz/choices.hpp"
#include "torse/fuzz/scale.hpp"

namespace torse::fuzz {

using Point3 = Vec<Rational, 3>;
using Row4 = Vec<Rational, 4>;

Point3 draw_vector(Choices& choices, const Scale& scale);
Point3 draw_nonzero_vector(Choices& choices, const Scale& scale);

/// `count` points: small integers; coincident, collinear or planar ones; doubles; integers; fractions; huge and tiny.
std::vector<Point3> draw_polygon(Choices& choices, const Scale& scale, int count);

/// "point", "line", "plane" (what the points span, when that is less than space), "coincident" (two neighbours are
/// equal), "huge" (a coordinate of 2^64 or more), "tiny" (a coordinate below 2^-64), "dyadic" or "fraction" (a
/// coordinate that is no integer), "integer".
std::string_view polygon_kind(const std::vector<Point3>& points);

/// A square matrix by rows.
template <int D>
using Matrix = std::array<Vec<Rational, D>, static_cast<std::size_t>(D)>;

/// The product of a lower and an upper triangular matrix of small integers with nonzero diagonals, and a permutation.
template <int D>
Matrix<D> draw_matrix(Choices& choices);

template <int D>
Vec<Rational, D> mapped(const Matrix<D>& matrix, const Vec<Rational, D>& x) {
  Vec<Rational, D> y;
  for (int i = 0; i < D; ++i) {
    y[i] = Rational();
    for (int j = 0; j < D; ++j) y[i] += matrix[static_cast<std::size_t>(i)][j] * x[j];
  }
  return y;
}

}  // namespace torse::fuzz
