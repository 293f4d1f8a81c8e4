// Parametrization mappings T = sigma(t) between the parameters of two rails (BZZ19, section 3.2): B-spline functions.
//   Mapping                       a spline with points on a line: knots and coefficients beta_0..beta_L
//   mapping_of, coefficients      from and to the list of coefficients
//   coefficients_from_steps       beta_i = sum_{j<=i} eps_j^2 (BZZ19.5)
//   identity_mapping              T = t over any knots
//   mapping_value, mapping_slope  sigma(t), sigma'(t)         derivative_sum     sigma' by its own B-spline (BZZ19.4)
//   fill_basis, lower_basis       the basis functions on a piece
//   monotone, strictly_monotone   what the coefficients tell
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "torse/spline/insertion.hpp"

namespace torse {

/// sigma(t) = sum_i beta_i B_{i,d}(t) (BZZ19.3) over the papers' knot list. The ends that BZZ19 takes (d+1)-fold are
/// d-fold here; the paper's text prints one end knot too many (t_0 = ... = t_{d+1}).
template <Field S>
using Mapping = Spline<S, Vec<S, 1>>;

/// The mapping with these coefficients. Throws InvalidInput naming "points" unless there are L + 1.
template <Field S>
Mapping<S> mapping_of(KnotList<S> u, const std::vector<S>& beta) {
  std::vector<Vec<S, 1>> control;
  control.reserve(beta.size());
  for (const S& b : beta) control.push_back(Vec<S, 1>::Constant(b));
  return Mapping<S>(std::move(u), std::move(control));
}

/// beta_0..beta_L.
template <Field S>
std::vector<S> coefficients(const Mapping<S>& sigma) {
  std::vector<S> beta;
  beta.reserve(sigma.control.size());
  for (const Vec<S, 1>& b : sigma.control) beta.push_back(b[0]);
  return beta;
}

/// beta_i = eps_0^2 + ... + eps_i^2 (BZZ19.5): over an ordered field none is less than the one before, nor than 0.
template <Ring S>
std::vector<S> coefficients_from_steps(std::span<const S> steps) {
  std::vector<S> beta;
  S total = from_int<S>(0);
  for (const S& step : steps) {
    add_product(total, step, step);
    beta.push_back(total);
  }
  return beta;
}

/// sigma(t) = t: its coefficients are the Greville abscissae (u_i + ... + u_{i+d-1}) / d.
template <Field S>
Mapping<S> identity_mapping(const KnotList<S>& u) {
  std::vector<S> beta;
  for (int i = 0; i <= u.last(); ++i) {
    S total = from_int<S>(0);
    for (int j = i; j < i + u.degree(); ++j) total += u[j];
    beta.push_back(total / from_int<S>(u.degree()));
  }
  return mapping_of(u, beta);
}

/// The proper piece that contains t, the one to the right at a knot, the last one at the end of the domain. Throws
/// InvalidInput naming "t" outside the domain, Undecided where the order is not decided.
template <OrderedField S>
int piece_at(const KnotList<S>& u, const S& t) {
  return insertion_interval(u, t) - u.degree() + 2;
}

/// sigma(t). Throws like piece_at.
template <OrderedField S>
S mapping_value(const Mapping<S>& sigma, const S& t) {
  return curve_point(sigma.knots, sigma.points(), piece_at(sigma.knots, t), t)[0];
}

/// sigma'(t), that of the piece to the right at a knot. Throws like piece_at.
template <OrderedField S>
S mapping_slope(const Mapping<S>& sigma, const S& t) {
  return curve_derivative(sigma.knots, sigma.points(), piece_at(sigma.knots, t), t)[0];
}

/// Fills `basis` with the e + 1 basis functions of degree e <= d on piece k that are not zero there, in order, by the
/// recursion of Cox and de Boor. For e = d these are B_{i,d} for i = k-1..k+d-1, for e = d-1 B_{i,d-1} for i =
/// k..k+d-1, which lives on [u_{i-1}, u_{i+d-1}]. The piece must not be empty.
template <Field S>
void fill_basis(const KnotList<S>& u, int k, const S& t, std::span<S> basis) {
  const int m = u.degree() + k - 2;  // the piece is [u_m, u_{m+1}]
  basis[0] = from_int<S>(1);
  for (int r = 1; r < static_cast<int>(basis.size()); ++r) {
    S kept = from_int<S>(0);
    for (int i = 0; i < r; ++i) {
      const std::size_t at_i = static_cast<std::size_t>(i);
      const S& lo = u[m + 1 + i - r];
      const S& hi = u[m + 1 + i];
      const S part = basis[at_i] / (hi - lo);
      basis[at_i] = kept + (hi - t) * part;
      kept = (t - lo) * part;
    }
    basis[static_cast<std::size_t>(r)] = kept;
  }
}

/// The d basis functions of degree d-1 on piece k that are not zero there, B_{i,d-1}(t) for i = k..k+d-1.
template <Field S>
std::vector<S> lower_basis(const KnotList<S>& u, int k, const S& t) {
  std::vector<S> basis(static_cast<std::size_t>(u.degree()), from_int<S>(0));
  fill_basis<S>(u, k, t, basis);
  return basis;
}

/// c'(t) on piece k as the B-spline of degree d-1 with coefficients d (c_i - c_{i-1}) / (u_{i+d-1} - u_{i-1}), which is
/// BZZ19.4 for a mapping. The paper's sum starts at i = 0, whose term is 0/0 over its clamped knots: it starts at 1.
template <Field S, class P>
P derivative_sum(const KnotList<S>& u, std::span<const P> c, int k, const S& t) {
  const int d = u.degree();
  const std::vector<S> basis = lower_basis(u, k, t);
  P total = PointTraits<P>::zero();
  for (int i = k; i < k + d; ++i) {
    const std::size_t at_i = static_cast<std::size_t>(i);
    const S factor = from_int<S>(d) * basis[static_cast<std::size_t>(i - k)] / (u[i + d - 1] - u[i - 1]);
    add_scaled(total, factor, difference(c[at_i], c[at_i - 1]));
  }
  return total;
}

/// Whether sigma nowhere decreases, as far as the coefficients that its proper pieces use tell. Where none of them is
/// less than the one before, it does not (BZZ19, after 4). A coefficient that is less refutes it for d <= 2, where
/// sigma' at the knots is made of the differences alone; for d > 2 it leaves the question open (`unknown`), and
/// exact/quasi/monotony.hpp decides it.
///
/// What a monotone sigma gives is that rulings meet the rails in the same order: no two of them leave the same point of
/// a rail that is passed once, where sigma increases strictly. It gives neither a patch without self-intersection nor
/// a regular one, whatever BZZ19 says: with C2 = C1 + (0, 0, 1) on a curve C1 that comes back above itself by less than
/// 1 the rulings overlap, and an edge of regression may run between the rails (claim BZZ19.5.witnesses).
template <OrderedField S>
Truth monotone(const Mapping<S>& sigma) {
  Truth ordered = Truth::yes;
  for (int k : sigma.knots.proper_pieces()) {
    for (int i = k; i < k + sigma.knots.degree(); ++i) {
      const std::size_t at_i = static_cast<std::size_t>(i);
      ordered = ordered & !less(sigma.control[at_i][0], sigma.control[at_i - 1][0]);
    }
  }
  if (ordered == Truth::no && sigma.knots.degree() > 2) return Truth::unknown;
  return ordered;
}

/// Whether sigma increases strictly, as far as its coefficients tell: a monotone one does unless it is constant on a
/// proper piece, and it is constant there iff the d + 1 coefficients of the piece are equal.
template <OrderedField S>
Truth strictly_monotone(const Mapping<S>& sigma) {
  Truth strict = Truth::yes;
  for (int k : sigma.knots.proper_pieces()) {
    Truth constant = Truth::yes;
    for (int i = k; i < k + sigma.knots.degree(); ++i) {
      const std::size_t at_i = static_cast<std::size_t>(i);
      constant = constant & equal(sigma.control[at_i][0], sigma.control[at_i - 1][0]);
    }
    strict = strict & !constant;
  }
  return monotone(sigma) & strict;
}

}  // namespace torse
