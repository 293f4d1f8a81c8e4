// Pieces of a curve as polynomials of its own parameter t, and back.
//   PolynomialRow<S, D>     D coordinates, each a polynomial in t          in_parameter   a form of a piece in t
//   piece_polynomials       the coordinates of piece k               derivative     of a row
//   bezier_rows             the control points of such polynomials over [a, b]
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "torse/algebra/bernstein.hpp"
#include "torse/algebra/polynomial.hpp"
#include "torse/spline/basis.hpp"

namespace torse {

template <ExactField S, int D>
using PolynomialRow = std::array<Polynomial<S>, static_cast<std::size_t>(D)>;

/// The form f(s, r) with s = (b-t)/(b-a), r = (t-a)/(b-a) as a polynomial in t, by Horner's rule.
template <ExactField S>
Polynomial<S> in_parameter(const BinaryForm<S>& f, const S& a, const S& b) {
  const S over = from_int<S>(1) / (b - a);
  const Polynomial<S> s(std::vector<S>{b * over, -over});
  const Polynomial<S> r(std::vector<S>{-a * over, over});
  Polynomial<S> power(1);
  Polynomial<S> value = Polynomial<S>::constant(f[f.degree()]);
  for (int i = f.degree() - 1; i >= 0; --i) {
    power *= s;
    Polynomial<S> term = power;
    value = value * r + term.scale(f[i]);
  }
  return value;
}

/// The coordinates of sum_i N_i c_i on piece k as polynomials in the global parameter. The piece must not be empty.
template <ExactField S, int D>
PolynomialRow<S, D> piece_polynomials(const KnotList<S>& u, std::span<const Vec<S, D>> c, int k) {
  const auto forms = piece_forms<S, D>(basis_forms(u, k), c, k);
  PolynomialRow<S, D> row;
  for (std::size_t j = 0; j < row.size(); ++j) row[j] = in_parameter(forms[j], u.piece_begin(k), u.piece_end(k));
  return row;
}

/// The derivative of each coordinate.
template <ExactField S, std::size_t D>
std::array<Polynomial<S>, D> derivative(const std::array<Polynomial<S>, D>& row) {
  std::array<Polynomial<S>, D> result;
  for (std::size_t j = 0; j < D; ++j) result[j] = row[j].derivative();
  return result;
}

/// The degree + 1 Bezier points over [a, b] of polynomials of at most that degree: with t = a + (b-a) s and
/// sum_j f_j s^j, the i-th point is sum_j C(i, j)/C(degree, j) f_j.
template <ExactField S, std::size_t D>
std::vector<Vec<S, static_cast<int>(D)>> bezier_rows(const std::array<Polynomial<S>, D>& row, int degree, const S& a,
                                                     const S& b) {
  using P = Vec<S, static_cast<int>(D)>;
  std::vector<P> points(static_cast<std::size_t>(degree) + 1, PointTraits<P>::zero());
  const Polynomial<S> local(std::vector<S>{a, b - a});
  for (std::size_t coordinate = 0; coordinate < D; ++coordinate) {
    const Polynomial<S> f = row[coordinate].compose(local);
    for (int j = 0; j <= f.degree(); ++j) {
      const S scaled = f[j] / binomial<S>(degree, j);
      for (int i = j; i <= degree; ++i) {
        add_product(points[static_cast<std::size_t>(i)][static_cast<int>(coordinate)], binomial<S>(i, j), scaled);
      }
    }
  }
  return points;
}

}  // namespace torse
