// The condition of developability, the oracle of the library: it shares no code with the constructions. A piece of a
// ruled surface is developable iff the determinant of its first partial derivatives vanishes identically.
//   span_matrix                 the matrix of forms of piece k whose determinant decides
//   form_determinant            of a 3 x 3 or 4 x 4 matrix of forms
//   span_determinant            the determinant polynomial of piece k (FJ07.3; FJ21.C3.1, degree 4(n-1))
//   DevelopabilityWitness       piece, coefficient and value that refute
//   find_witness                the first of them over all pieces, or none: the surface is developable
//   pointwise_determinant       [d', c', d-c] at one parameter (FJ07.3, FJ21.2.1)
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "torse/algebra/bernstein.hpp"
#include "torse/algebra/determinant.hpp"
#include "torse/scalar/formula.hpp"
#include "torse/spline/basis.hpp"
#include "torse/spline/blossom.hpp"

namespace torse {

namespace detail {

template <Ring S>
BinaryForm<S> minor2(const BinaryForm<S>& a, const BinaryForm<S>& b, const BinaryForm<S>& c, const BinaryForm<S>& d) {
  return a * d - b * c;
}

}  // namespace detail

/// A square matrix of forms of equal degree.
template <Ring S, int D>
using FormMatrix = std::array<std::array<BinaryForm<S>, static_cast<std::size_t>(D)>, static_cast<std::size_t>(D)>;

/// The determinant by Laplace's expansion along the first two rows.
template <Ring S>
BinaryForm<S> form_determinant(const FormMatrix<S, 4>& m) {
  const auto top = [&](std::size_t i, std::size_t j) { return detail::minor2(m[0][i], m[0][j], m[1][i], m[1][j]); };
  const auto low = [&](std::size_t i, std::size_t j) { return detail::minor2(m[2][i], m[2][j], m[3][i], m[3][j]); };
  BinaryForm<S> det = top(0, 1) * low(2, 3);
  det -= top(0, 2) * low(1, 3);
  det += top(0, 3) * low(1, 2);
  det += top(1, 2) * low(0, 3);
  det -= top(1, 3) * low(0, 2);
  det += top(2, 3) * low(0, 1);
  return det;
}

/// The determinant by the first row.
template <Ring S>
BinaryForm<S> form_determinant(const FormMatrix<S, 3>& m) {
  return m[0][0] * detail::minor2(m[1][1], m[1][2], m[2][1], m[2][2]) -
         m[0][1] * detail::minor2(m[1][0], m[1][2], m[2][0], m[2][2]) +
         m[0][2] * detail::minor2(m[1][0], m[1][1], m[2][0], m[2][1]);
}

/// dP/ds, dP/dt, dQ/ds, dQ/dt on piece k of a rational ruled surface with homogeneous rows p, q.
template <Field S>
FormMatrix<S, 4> span_matrix(const KnotList<S>& u, std::span<const Vec<S, 4>> p, std::span<const Vec<S, 4>> q, int k) {
  const std::vector<BinaryForm<S>> basis = basis_forms(u, k);
  const auto pf = piece_forms<S, 4>(basis, p, k);
  const auto qf = piece_forms<S, 4>(basis, q, k);
  FormMatrix<S, 4> m;
  for (std::size_t j = 0; j < 4; ++j) {
    m[0][j] = pf[j].derivative_s();
    m[1][j] = pf[j].derivative_t();
    m[2][j] = qf[j].derivative_s();
    m[3][j] = qf[j].derivative_t();
  }
  return m;
}

/// dC/dt - dC/ds, dD/ds - dC/ds, dD/dt - dC/ds on piece k of a polynomial ruled surface.
template <Field S>
FormMatrix<S, 3> span_matrix(const KnotList<S>& u, std::span<const Vec<S, 3>> c, std::span<const Vec<S, 3>> d, int k) {
  const std::vector<BinaryForm<S>> basis = basis_forms(u, k);
  const auto cf = piece_forms<S, 3>(basis, c, k);
  const auto df = piece_forms<S, 3>(basis, d, k);
  FormMatrix<S, 3> m;
  for (std::size_t j = 0; j < 3; ++j) {
    const BinaryForm<S> origin = cf[j].derivative_s();
    m[0][j] = cf[j].derivative_t() - origin;
    m[1][j] = df[j].derivative_s() - origin;
    m[2][j] = df[j].derivative_t() - origin;
  }
  return m;
}

/// The determinant of dP/ds, dP/dt, dQ/ds, dQ/dt on piece k of a rational ruled surface with homogeneous rows p, q: n^4
/// times det(p_0^{n-1}, p_1^{n-1}, q_0^{n-1}, q_1^{n-1}) of FJ21 Corollary 3.1, of degree 4(n-1). The piece is
/// developable iff it vanishes identically.
template <Field S>
BinaryForm<S> span_determinant(const KnotList<S>& u, std::span<const Vec<S, 4>> p, std::span<const Vec<S, 4>> q,
                               int k) {
  const FormulaScope<S> scope("FJ21.C3.1", "determinant of piece", k);
  return form_determinant<S>(span_matrix<S>(u, p, q, k));
}

/// The determinant [c', d-c, d'] of FJ07.3 on piece k of a polynomial ruled surface, up to a positive constant, as a
/// form of degree 3(n-1): the affine determinant of c_0^{n-1}, c_1^{n-1}, d_0^{n-1}, d_1^{n-1}.
template <Field S>
BinaryForm<S> span_determinant(const KnotList<S>& u, std::span<const Vec<S, 3>> c, std::span<const Vec<S, 3>> d,
                               int k) {
  const FormulaScope<S> scope("FJ07.3", "determinant of piece", k);
  return form_determinant<S>(span_matrix<S>(u, c, d, k));
}

/// What refutes developability: Bernstein coefficient `coefficient` of the determinant of piece `piece` is not zero.
template <Field S>
struct DevelopabilityWitness {
  int piece;
  int coefficient;
  S value;
};

/// The first piece and Bernstein coefficient where the determinant does not vanish, over all pieces; none proves that
/// the surface is developable. D = 3: points of a polynomial surface, D = 4: homogeneous rows. Throws Undecided where a
/// coefficient is neither zero nor not.
template <Field S, int D>
std::optional<DevelopabilityWitness<S>> find_witness(const KnotList<S>& u, std::span<const Vec<S, D>> c,
                                                     std::span<const Vec<S, D>> d) {
  bool open = false;
  for (int k : u.proper_pieces()) {
    const BinaryForm<S> det = span_determinant(u, c, d, k);
    if (const std::optional<int> i = det.first_nonzero()) {
      return DevelopabilityWitness<S>{k, *i, det[*i] / binomial<S>(det.degree(), *i)};
    }
    open = open || !definitely(det.zero());
  }
  if (open) throw Undecided("developability: a coefficient of the determinant is neither zero nor not");
  return std::nullopt;
}

/// [d', c', d-c] at the parameter t of piece k (FJ07.3), from points and derivatives of the curves.
template <Field S>
S pointwise_determinant(const KnotList<S>& u, std::span<const Vec<S, 3>> c, std::span<const Vec<S, 3>> d, int k,
                        const S& t) {
  return det3(curve_derivative(u, d, k, t), curve_derivative(u, c, k, t),
              difference(curve_point(u, d, k, t), curve_point(u, c, k, t)));
}

/// (d-c).(c' x d') at the parameter t of piece k (FJ21.2.1) times w(t)^4 omega(t)^4 for homogeneous rows p = w (1, c)
/// and q = omega (1, d): the derivatives are w c' = P' - w' c by the quotient rule.
template <Field S>
S pointwise_determinant(const KnotList<S>& u, std::span<const Vec<S, 4>> p, std::span<const Vec<S, 4>> q, int k,
                        const S& t) {
  const auto scaled_derivative = [](const Vec<S, 4>& x, const Vec<S, 4>& dx) {  // w^2 c'
    Vec<S, 3> v;
    for (int j = 0; j < 3; ++j) v[j] = dx[j + 1] * x[0] - dx[0] * x[j + 1];
    return v;
  };
  const Vec<S, 4> x = curve_point(u, p, k, t);
  const Vec<S, 4> y = curve_point(u, q, k, t);
  const Vec<S, 3> dc = scaled_derivative(x, curve_derivative(u, p, k, t));
  const Vec<S, 3> dd = scaled_derivative(y, curve_derivative(u, q, k, t));
  Vec<S, 3> ruling;  // w omega (d - c)
  for (int j = 0; j < 3; ++j) ruling[j] = y[j + 1] * x[0] - x[j + 1] * y[0];
  return x[0] * y[0] * det3(ruling, dc, dd);
}

}  // namespace torse
