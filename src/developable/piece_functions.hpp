// Lam, M, sigma of a piece as rational functions of its parameter, from the control net alone.
//   Sweep                 what the rulings of a developable piece sweep: a surface, a curve, a line
//   PieceFunctions        the dependence alpha p + beta p' = gamma q + delta q', and Lam, M, sigma, lambda, mu, nu from
//   it recover_piece         of piece k             recover_pieces      of all pieces of positive length
//
// p[t^<n-1>, x] = p + (x-t)/n p', so Theorem 3.1 of FJ21 is a linear dependence of p, p', q, q' over the field S(t),
// with
//   Lam = t + n beta/alpha,  M = t + n delta/gamma,  sigma = gamma/alpha.
// The four rows of a developable piece have rank at most 3 there. With rank 3 the dependence is unique up to a factor;
// rank 2 or less means that there is no surface: if p and q are independent, they span p' and q' too, so their plane in
// S(t)^4 is closed under d/dt and all rulings are one line; else d = c.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "torse/algebra/determinant.hpp"
#include "torse/algebra/polynomial_fraction.hpp"
#include "torse/developable/functions.hpp"
#include "torse/spline/piece_polynomials.hpp"

namespace torse {

/// What the rulings of a piece sweep: a surface; a curve, where every ruling has length zero (d = c); or a line, where
/// all rulings lie on it.
enum class Sweep { surface, curve, line };

/// A developable piece [begin, end] of degree n with homogeneous rows p, q and the dependence
/// alpha p + beta p' = gamma q + delta q', four polynomials without a common factor, not all zero. Where the sweep is
/// not a surface the dependence is not unique: all four are zero and no function exists.
template <ExactField S>
struct PieceFunctions {
  using Function = PolynomialFraction<S>;

  int piece;
  S begin;
  S end;
  int degree;
  Sweep sweep;
  PolynomialRow<S, 4> p;
  PolynomialRow<S, 4> q;
  Polynomial<S> alpha{};
  Polynomial<S> beta{};
  Polynomial<S> gamma{};
  Polynomial<S> delta{};
  /// The greatest common divisor of the 3 x 3 minors of p, p', q, q': its roots are the parameters where they have rank
  /// below 3. Zero where the sweep is not a surface.
  Polynomial<S> minors{};

  /// Whether the dependence leaves q out: then c is one point, M does not exist, and sigma is 0 if Lam is finite.
  bool c_is_a_point() const { return sweep == Sweep::surface && gamma.zero() && delta.zero(); }
  /// Whether it leaves p out: then d is one point, Lam and sigma do not exist.
  bool d_is_a_point() const { return sweep == Sweep::surface && alpha.zero() && beta.zero(); }
  /// Whether lambda_0 + lambda_1 = 0 in FJ21.3.3, the case that Theorem 3.1 excludes: Lam is at infinity, where the
  /// blossom p[t^<n-1>, x] has the direction p', and sigma has no finite value.
  bool lambda_infinite() const { return alpha.zero() && !beta.zero(); }
  /// Whether mu_0 + mu_1 = 0: M is at infinity and sigma is 0 (without a value if Lam is at infinity too).
  bool m_infinite() const { return gamma.zero() && !delta.zero(); }

  /// Lam, M, sigma where they exist and are finite.
  std::optional<Function> lambda() const { return from_tangent(beta, alpha); }
  std::optional<Function> m() const { return from_tangent(delta, gamma); }
  std::optional<Function> sigma() const {
    if (alpha.zero()) return std::nullopt;
    return Function(gamma, alpha);
  }
  /// Lam, M, sigma together, where all are finite.
  std::optional<BlossomFunctions<Function>> blossom() const {
    if (alpha.zero() || gamma.zero()) return std::nullopt;
    return BlossomFunctions<Function>{*lambda(), *m(), *sigma()};
  }
  /// lambda, mu, nu of p' = lambda W + mu W' + nu p with W = q - p (FJ21.4.3); they exist iff beta != delta, also where
  /// Lam or M is at infinity.
  std::optional<FrameFunctions<Function>> frame() const {
    const Polynomial<S> below = beta - delta;
    if (below.zero()) return std::nullopt;
    return FrameFunctions<Function>{Function(gamma, below), Function(delta, below), Function(gamma - alpha, below)};
  }
  /// Whether Lam, M and sigma are finite constants.
  bool constant() const {
    const std::optional<BlossomFunctions<Function>> f = blossom();
    return f && f->lambda.constant_value() && f->m.constant_value() && f->sigma.constant_value();
  }

 private:
  std::optional<Function> from_tangent(const Polynomial<S>& slope, const Polynomial<S>& weight) const {
    if (weight.zero()) return std::nullopt;
    return Function(weight * Polynomial<S>::variable() + from_int<Polynomial<S>>(degree) * slope, weight);
  }
};

namespace detail {

/// Four rows of four polynomials: their dependence by cofactors.
template <ExactField S>
class PolynomialMatrix {
 public:
  explicit PolynomialMatrix(std::array<PolynomialRow<S, 4>, 4> rows) : rows_(std::move(rows)) {}

  /// The cofactor of row i among the coordinates but `left_out`, with its sign: sum_i cofactor(i, j) rows_[i] = 0 for
  /// rows of rank 3 at most.
  Polynomial<S> cofactor(std::size_t i, std::size_t left_out) const {
    std::array<Vec<Polynomial<S>, 3>, 3> m;
    for (std::size_t row = 0, to = 0; row < 4; ++row) {
      if (row == i) continue;
      for (std::size_t j = 0, at = 0; j < 4; ++j) {
        if (j != left_out) m[to][static_cast<int>(at++)] = rows_[row][j];
      }
      ++to;
    }
    const Polynomial<S> minor = det3(m[0], m[1], m[2]);
    return i % 2 == 0 ? minor : -minor;
  }

  /// The dependence of rows of rank 3 without a common factor, all zero for a lower rank, none for independent rows.
  /// `minors` becomes the greatest common divisor of all cofactors.
  std::optional<std::array<Polynomial<S>, 4>> dependence(Polynomial<S>& minors) const {
    std::array<Polynomial<S>, 4> x;
    std::size_t left_out = 0;
    const auto is_zero_polynomial = [](const Polynomial<S>& f) { return f.zero(); };
    for (; left_out < 4 && std::ranges::all_of(x, is_zero_polynomial); ++left_out) {
      for (std::size_t i = 0; i < 4; ++i) x[i] = cofactor(i, left_out);
    }
    minors = common_divisor(x);
    if (minors.zero()) return x;
    for (Polynomial<S>& f : x) f = exact_quotient(f, minors);
    // Three coordinates of sum_i x_i rows_[i] are 0; the one left out is the determinant over `minors`.
    Polynomial<S> rest;
    for (std::size_t i = 0; i < 4; ++i) rest += x[i] * rows_[i][left_out - 1];
    if (!rest.zero()) return std::nullopt;
    // The cofactors of every other coordinate are a multiple of the same dependence.
    const std::size_t known = static_cast<std::size_t>(std::ranges::find_if_not(x, is_zero_polynomial) - x.begin());
    for (; left_out < 4 && minors.degree() > 0; ++left_out) {
      minors = gcd(minors, exact_quotient(cofactor(known, left_out), x[known]));
    }
    return x;
  }

 private:
  std::array<PolynomialRow<S, 4>, 4> rows_;
};

/// n p[t^<n-1>, 0] = n p - t p', of degree n - 1.
template <ExactField S>
PolynomialRow<S, 4> blossom_at_zero(int n, const PolynomialRow<S, 4>& p) {
  PolynomialRow<S, 4> row;
  for (std::size_t j = 0; j < 4; ++j) {
    std::vector<S> a = p[j].coefficients();
    for (std::size_t i = 0; i < a.size(); ++i) a[i] *= from_int<S>(n - static_cast<int>(i));
    row[j] = Polynomial<S>(std::move(a));
  }
  return row;
}

/// A factor that clears the denominators of a row, for fields that have them: products are much cheaper then.
template <ExactField S>
S clearing_factor(const PolynomialRow<S, 4>& row) {
  if constexpr (requires(const std::vector<S>& list) { ScalarTraits<S>::common_denominator(list); }) {
    std::vector<S> all;
    for (const Polynomial<S>& f : row) all.insert(all.end(), f.coefficients().begin(), f.coefficients().end());
    return ScalarTraits<S>::common_denominator(all);
  } else {
    return from_int<S>(1);
  }
}

template <ExactField S>
PolynomialRow<S, 4> scaled_row(PolynomialRow<S, 4> row, const S& factor) {
  for (Polynomial<S>& f : row) f.scale(factor);
  return row;
}

}  // namespace detail

/// The pairwise determinants p_i q_j - p_j q_i up to a common constant: zero together where p and q are proportional.
template <ExactField S>
std::vector<Polynomial<S>> ruling_coordinates(const PolynomialRow<S, 4>& p, const PolynomialRow<S, 4>& q) {
  const PolynomialRow<S, 4> x = detail::scaled_row<S>(p, detail::clearing_factor<S>(p));
  const PolynomialRow<S, 4> y = detail::scaled_row<S>(q, detail::clearing_factor<S>(q));
  std::vector<Polynomial<S>> l;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) l.push_back(x[i] * y[j] - x[j] * y[i]);
  }
  return l;
}

/// The functions of piece k of a ruled spline with homogeneous rows p, q. The rows p[t^<n-1>, 0], p', q[t^<n-1>, 0], q'
/// of degree n - 1 have the span of p, p', q, q'; the cofactors of a coordinate are their dependence. Throws
/// InvalidInput naming "piece[k]" for a piece that is not developable.
template <ExactField S>
PieceFunctions<S> recover_piece(const KnotList<S>& u, std::span<const Vec<S, 4>> p, std::span<const Vec<S, 4>> q,
                                int k) {
  const int n = u.degree();
  PieceFunctions<S> f{.piece = k,
                      .begin = u.piece_begin(k),
                      .end = u.piece_end(k),
                      .degree = n,
                      .sweep = Sweep::surface,
                      .p = piece_polynomials<S, 4>(u, p, k),
                      .q = piece_polynomials<S, 4>(u, q, k)};
  const S p_factor = detail::clearing_factor<S>(f.p);
  const S q_factor = detail::clearing_factor<S>(f.q);
  const PolynomialRow<S, 4> cp = detail::scaled_row<S>(f.p, p_factor);
  const PolynomialRow<S, 4> cq = detail::scaled_row<S>(f.q, q_factor);
  const detail::PolynomialMatrix<S> rows(
      {detail::blossom_at_zero<S>(n, cp), derivative(cp), detail::blossom_at_zero<S>(n, cq), derivative(cq)});
  const std::optional<std::array<Polynomial<S>, 4>> dependence = rows.dependence(f.minors);
  if (!dependence) throw InvalidInput("piece[" + std::to_string(k) + "]", "is not developable");
  const std::array<Polynomial<S>, 4>& x = *dependence;
  if (f.minors.zero()) {
    const std::vector<Polynomial<S>> l = ruling_coordinates<S>(f.p, f.q);
    const bool independent = std::ranges::any_of(l, [](const Polynomial<S>& e) { return !e.zero(); });
    f.sweep = independent ? Sweep::line : Sweep::curve;
    return f;
  }
  // x_0 (n p - t p') + x_1 p' = alpha p + beta p'
  const Polynomial<S> t = Polynomial<S>::variable();
  f.alpha = (from_int<Polynomial<S>>(n) * x[0]).scale(p_factor);
  f.beta = (x[1] - t * x[0]).scale(p_factor);
  f.gamma = (from_int<Polynomial<S>>(-n) * x[2]).scale(q_factor);
  f.delta = (t * x[2] - x[3]).scale(q_factor);
  return f;
}

/// The functions of all pieces of positive length, in order.
template <ExactField S>
std::vector<PieceFunctions<S>> recover_pieces(const KnotList<S>& u, std::span<const Vec<S, 4>> p,
                                              std::span<const Vec<S, 4>> q) {
  std::vector<PieceFunctions<S>> result;
  for (int k : u.proper_pieces()) result.push_back(recover_piece<S>(u, p, q, k));
  return result;
}

}  // namespace torse
