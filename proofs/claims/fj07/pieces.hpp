// FJ07, section 3: the coefficients of the pieces of a developable spline, equations (10) and (11).
//   Eq10, Eq11
#pragma once

#include <utility>
#include <vector>

#include "torse/developable/pieces.hpp"
#include "torse/proofs/claims/fj07/common.hpp"

namespace torse::proofs::fj07 {

inline constexpr Hypothesis proper_pieces{"no piece is empty: the recursions divide by its length", false};

/// FJ07.10: L* and M* in the coordinates of the pieces.
struct Eq10 {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo value{
        .id = "FJ07.10",
        .source = "equation (10)",
        .title = "Lam_k and M_k from piece to piece",
        .statement = R"(With $\Lambda_k=\frac{\Delta u_{n+k-3}}{\Delta u_{n+k-2}}(\Lambda_{k-1}-1)$:
$(1-\Lambda_k)u_{n+k-2}+\Lambda_ku_{n+k-1}=\Lambda^*$ on all pieces, and
$\Lambda_k=(\Delta u_{n+j-2}\Lambda_j+u_{n+j-2}-u_{n+k-2})/\Delta u_{n+k-2}$; $M_k$ likewise.)",
        .kind = Kind::identity,
        .hypotheses = {proper_pieces},
        .mutants = {"Lam + 1", "the ratio of lengths inverted", "the ratio of lengths missing"}};
    return value;
  }

  template <class S, class P>
  struct In {
    KnotList<S> u;
    S x;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    KnotList<S> u(size.n, from.knots(size));
    return {std::move(u), from.scalar()};
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return {proper(in.u)};
  }
  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    return {{0, {example_knots<S>(2, {0, 1, 1, 2, 3}), from_int<S>(5)}}};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, x] = in;
    const S one = from_int<S>(1);
    std::vector<S> local{local_parameter(u, x, 1)};
    for (int k = 2; k <= u.pieces(); ++k) {
      S next = next_local(u, mutant.is(1) ? local.back() + one + one : local.back(), k);
      const S ratio = (u.piece_end(k) - u.piece_begin(k)) / (u.piece_end(k - 1) - u.piece_begin(k - 1));
      if (mutant.is(2)) next *= ratio * ratio;
      if (mutant.is(3)) next *= ratio;
      local.push_back(std::move(next));
    }
    for (int k = 1; k <= u.pieces(); ++k) {
      const S& here = local[static_cast<std::size_t>(k) - 1];
      equations.equal((one - here) * u.piece_begin(k) + here * u.piece_end(k), x);
      for (int j = 1; j <= u.pieces(); ++j) {
        const S& there = local[static_cast<std::size_t>(j) - 1];
        const S moved = (u.piece_end(j) - u.piece_begin(j)) * there + u.piece_begin(j) - u.piece_begin(k);
        equations.equal(moved / (u.piece_end(k) - u.piece_begin(k)), here);
      }
    }
  }
};

/// FJ07.11: lam_k and mu_k from piece to piece; cylinders and cones propagate.
struct Eq11 {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo value{
        .id = "FJ07.11",
        .source = "equation (11)",
        .title = "lam_k and mu_k from piece to piece",
        .statement = R"($\lambda_k=\Lambda_k/M_k$, $\mu_k=1-1/M_k$ obey (11). From any $(\lambda_1,\mu_1)$ the recursion
gives $\lambda_k-1=(\lambda_1-1)\Delta u_{n-1}/e_k$ and $\mu_k-1=(\mu_1-1)\Delta u_{n+k-2}/e_k$,
$e_k=\Delta u_{n-1}+(1-\mu_1)(u_{n-1}-u_{n+k-2})$: $\lambda_k=1$, or $\mu_k=1$, on one piece iff on all.)",
        .kind = Kind::identity,
        .hypotheses = {proper_pieces,
                       {"M* is not the start of a piece: M_k != 0", false},
                       {"mu_1, ..., mu_{N-1} are not 0: M* is no inner joint (as e_2, ..., e_N != 0)", false}},
        .mutants = {"lam and mu exchanged", "the ratio of lengths inverted", "1 + 1/mu", "mu_k in lam_k"},
        .remark =
            "'regardless of the values of mu' needs mu_k != 0: at mu_k = 0 the recursion stops. Cones have no M_k; "
            "the recursion covers them by mu = 1."};
    return value;
  }

  template <class S, class P>
  struct In {
    KnotList<S> u;
    S lambda;
    S m;
    AffineCell<S> first;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    KnotList<S> u(size.n, from.knots(size));
    S lambda = from.scalar();
    S m = from.scalar();
    S lam = from.scalar();
    return {std::move(u), std::move(lambda), std::move(m), {std::move(lam), from.scalar()}};
  }

  /// e_k, k = 1..N.
  template <class S, class P>
  static S e(const In<S, P>& in, int k) {
    const KnotList<S>& u = in.u;
    return u.piece_end(1) - u.piece_begin(1) + (from_int<S>(1) - in.first.mu) * (u.piece_begin(1) - u.piece_begin(k));
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    std::vector<S> starts;
    std::vector<S> joints;
    for (int k = 1; k <= in.u.pieces(); ++k) starts.push_back(in.m - in.u.piece_begin(k));
    for (int k = 2; k <= in.u.pieces(); ++k) joints.push_back(e(in, k));
    return {proper(in.u), std::move(starts), std::move(joints)};
  }
  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const auto with = [](KnotList<S> u, std::int64_t m, std::int64_t mu) {
      return In<S, P>{std::move(u), from_int<S>(7), from_int<S>(m), {from_int<S>(3), from_int<S>(mu)}};
    };
    return {{0, with(example_knots<S>(2, {0, 1, 2, 2, 3}), 5, 3)},
            {1, with(example_knots<S>(2, {0, 1, 2, 3, 4}), 2, 3)},
            {2, with(example_knots<S>(2, {0, 1, 2, 3, 4}), 5, 0)}};
  }

  template <class S, class P>
  static AffineCell<S> step(const KnotList<S>& u, AffineCell<S> cell, int k, Mutant mutant) {
    const S one = from_int<S>(1);
    if (mutant.is(1)) std::swap(cell.lam, cell.mu);
    AffineCell<S> next = next_affine(u, cell, k);
    const S ratio = (u.piece_end(k - 1) - u.piece_begin(k - 1)) / (u.piece_end(k) - u.piece_begin(k));
    if (mutant.is(2)) next.mu = one + (next.mu - one) * ratio * ratio;
    if (mutant.is(3)) next.mu += (one + one) / cell.mu;
    if (mutant.is(4)) next.lam = (cell.lam + next.mu - one) / cell.mu;
    return next;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, lambda, m, first] = in;
    const S one = from_int<S>(1);
    AffineCell<S> cell = affine_from_local(local_parameter(u, lambda, 1), local_parameter(u, m, 1));
    AffineCell<S> free = first;
    for (int k = 1; k <= u.pieces(); ++k) {
      if (k > 1) cell = step<S, P>(u, cell, k, mutant);
      if (k > 1) free = step<S, P>(u, free, k, mutant);
      const S& start = u.piece_begin(k);
      equations.equal(cell.lam, (lambda - start) / (m - start));
      equations.equal(cell.mu, (m - u.piece_end(k)) / (m - start));
      equations.equal(free.lam - one, (first.lam - one) * (u.piece_end(1) - u.piece_begin(1)) / e(in, k));
      equations.equal(free.mu - one, (first.mu - one) * (u.piece_end(k) - start) / e(in, k));
    }
  }
};

}  // namespace torse::proofs::fj07
