// Lam, M, sigma of one cell, the way back from a net to the functions that made it.
//   dependence_of        the coefficients of the linear dependence of four homogeneous rows
//   cell_functions       L*, M*, sigma of cell i of a rational net (FJ21.7.1)
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>

#include "torse/algebra/determinant.hpp"
#include "torse/developable/functions.hpp"
#include "torse/spline/knots.hpp"

namespace torse {

/// x_0, ..., x_3, not all zero, with sum_i x_i row_i = 0, for four dependent rows of rank 3: the cofactors that belong
/// to the first coordinate at which they do not all vanish. Throws InvalidInput naming `place` for independent rows and
/// for rows of rank below 3, whose dependence is not unique.
template <Field S>
std::array<S, 4> dependence_of(const std::array<Vec<S, 4>, 4>& rows, const std::string& place) {
  if (!possibly(is_zero(det4<S>(rows[0], rows[1], rows[2], rows[3])))) {
    throw InvalidInput(place, "the four vertices of the cell are not coplanar");
  }
  for (int left_out = 0; left_out < 4; ++left_out) {
    std::array<Vec<S, 3>, 4> reduced;
    for (std::size_t i = 0; i < 4; ++i) {
      for (int j = 0, to = 0; j < 4; ++j) {
        if (j != left_out) reduced[i][to++] = rows[i][j];
      }
    }
    const auto minor = [&](std::size_t a, std::size_t b, std::size_t c) {
      return det3<S>(reduced[a], reduced[b], reduced[c]);
    };
    std::array<S, 4> x{minor(1, 2, 3), -minor(0, 2, 3), minor(0, 1, 3), -minor(0, 1, 2)};
    for (const S& coefficient : x) {
      if (!possibly(is_zero(coefficient))) return x;
    }
  }
  throw InvalidInput(place, "the four vertices of the cell lie on a line: Lambda, M and sigma are not unique");
}

/// L*, M*, sigma from cell i: (u_{i+n}-L*) p_i + (L*-u_i) p_{i+1} = sigma ((u_{i+n}-M*) q_i + (M*-u_i) q_{i+1})
/// (FJ21.7.1; for a Bezier piece on [0, 1] these are Lam and M). Throws InvalidInput naming "cell[i]" where they are
/// not unique or do not exist, "Lambda" or "M" where one of them is infinite.
template <Field S>
BlossomFunctions<S> cell_functions(const KnotList<S>& u, std::span<const Vec<S, 4>> p, std::span<const Vec<S, 4>> q,
                                   int i) {
  const std::size_t at = static_cast<std::size_t>(i);
  const std::array<S, 4> x = dependence_of<S>({p[at], p[at + 1], q[at], q[at + 1]}, "cell[" + std::to_string(i) + "]");
  BlossomFunctions<S> f = from_dependence<S>(x[0], x[1], -x[2], -x[3]);
  const S width = u[i + u.degree()] - u[i];
  f.lambda = u[i] + width * f.lambda;
  f.m = u[i] + width * f.m;
  return f;
}

}  // namespace torse
