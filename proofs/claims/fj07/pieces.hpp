// FJ07, section 3: the pieces of a developable spline, equations (10), (11), (12), (19) and Corollary 1.
//   Eq10, Eq11, Eq12, Corollary1, Eq19
#pragma once

#include <vector>

#include "torse/developable/linear_net.hpp"
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

/// One Bezier piece on [0, 1] by Aumann's relation.
template <class S, class P>
struct AumannInput {
  std::vector<P> c;
  P d0;
  S lambda;
  S m;
  S t;
};

inline constexpr Hypothesis m_not_zero{"M is not 0: the relation then leaves D_{i+1} undetermined", false};

template <class S, class P>
AumannInput<S, P> draw_aumann(Source<S>& from, Size size) {
  std::vector<P> c = from.template points<P>(size.n + 1);
  P d0 = from.template point<P>();
  S lambda = from.scalar();
  S m = from.scalar();
  return {std::move(c), std::move(d0), std::move(lambda), std::move(m), from.scalar()};
}

template <class S, class P>
std::vector<Failure<AumannInput<S, P>>> aumann_failures() {
  const NetInput<S, P> net = example_net<S, P>(0);
  return {{0, {net.c, net.d0, net.lambda, net.m, from_int<S>(4)}}};
}

/// FJ07.12: Aumann's relation from blossoms.
struct Eq12 {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo value{
        .id = "FJ07.12",
        .source = "equation (12)",
        .title = "Aumann's relation",
        .statement = R"($(1-\Lambda)C_i+\Lambda C_{i+1}=(1-M)D_i+MD_{i+1}$, $i=0..n-1$, is
$c[0^{\langle n-1-i\rangle},1^{\langle i\rangle},\Lambda]=d[0^{\langle n-1-i\rangle},1^{\langle i\rangle},M]$, and
$D_{i+1}=(1-\lambda-\mu)C_i+\lambda C_{i+1}+\mu D_i$ with $\lambda=\Lambda/M$, $\mu=1-1/M$.)",
        .kind = Kind::identity,
        .hypotheses = {m_not_zero},
        .mutants = {"Lam and M exchanged", "lam and mu exchanged", "1 - Lam in the place of Lam"},
        .max_pieces = 1};
    return value;
  }

  template <class S, class P>
  using In = AumannInput<S, P>;
  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    return draw_aumann<S, P>(from, size);
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return {{in.m}};
  }
  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    return aumann_failures<S, P>();
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const S one = from_int<S>(1);
    const int n = static_cast<int>(in.c.size()) - 1;
    const KnotList<S> u = bezier_knots<S>(n);
    const std::vector<P> d = aumann_net<S, P>(in.c, in.lambda, in.m, in.d0);
    S lambda = mutant.is(3) ? one - in.lambda : in.lambda;
    S m = in.m;
    if (mutant.is(1)) std::swap(lambda, m);
    AffineCell<S> cell = affine_from_local(in.lambda, in.m);
    if (mutant.is(2)) std::swap(cell.lam, cell.mu);
    for (int i = 0; i < n; ++i) {
      const std::size_t at_i = static_cast<std::size_t>(i);
      std::vector<Parameter<S>> arguments = repeated(at(from_int<S>(0)), n - 1 - i);
      arguments.insert(arguments.end(), at_i, at(one));
      arguments.push_back(at(lambda));
      const P on_c = blossom<S, P>(u, in.c, 1, arguments);
      arguments.back() = at(m);
      equations.equal(on_c, blossom<S, P>(u, d, 1, arguments));
      P vertex = combine(one - cell.lam - cell.mu, in.c[at_i], cell.lam, in.c[at_i + 1]);
      add_scaled(vertex, cell.mu, d[at_i]);
      equations.equal(d[at_i + 1], vertex);
    }
  }
};

/// FJ07.C1: cells with one barycentric combination make a developable Bezier surface.
struct Corollary1 {
  static constexpr PointKind points = PointKind::coplanar;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo value{
        .id = "FJ07.C1",
        .source = "Corollary 1",
        .title = "developable Bezier surfaces by cells",
        .statement =
            R"(The net of (12) has plane cells and spans a developable surface; for $\Lambda=M$ it is a cylinder
with $D_i-C_i=(1-1/M)^i(D_0-C_0)$.)",
        .kind = Kind::identity,
        .hypotheses = {m_not_zero},
        .mutants = {"the last vertex moved", "Lam of the first cell changed", "rulings of the cylinder all equal"},
        .max_pieces = 1,
        .remark =
            "Plane cells alone do not suffice, nor does every developable surface have them with one combination. For "
            "cones the paper prints Lam as the ratio of the sides; the ratio is alpha of (6)."};
    return value;
  }

  template <class S, class P>
  using In = AumannInput<S, P>;
  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    return draw_aumann<S, P>(from, size);
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return {{in.m}};
  }
  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    return aumann_failures<S, P>();
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [c, d0, lambda, m, t] = in;
    std::vector<P> d = aumann_net<S, P>(c, lambda, m, d0);
    if (mutant.is(1)) add(d.back(), difference(d.back(), c.front()));
    if (mutant.is(2)) d.front() = combine(from_int<S>(3), d.front(), from_int<S>(-2), c.front());
    for (std::size_t i = 0; i + 1 < c.size(); ++i) {
      equations.zero(dependence_residual(std::array<P, 4>{c[i], c[i + 1], d[i], d[i + 1]}));
    }
    require_coplanar<S, P>(bezier_knots<S>(static_cast<int>(c.size()) - 1), c, d, t, equations);

    const std::vector<P> cylinder = aumann_net<S, P>(c, m, m, d0);
    const P first = difference(d0, c.front());
    S power = from_int<S>(1);
    for (std::size_t i = 0; i < c.size(); ++i) {
      equations.equal(difference(cylinder[i], c[i]), scaled(power, first));
      if (!mutant.is(3)) power *= (m - from_int<S>(1)) / m;
    }
  }
};

/// FJ07.19: the Bezier nets of the pieces of a developable spline.
struct Eq19 {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo value{
        .id = "FJ07.19",
        .source = "equation (19)",
        .title = "the pieces obey Aumann's relation with Lam_k, M_k",
        .statement = R"(The Bezier net of piece $k$ of the spline of (13) obeys
$(1-\Lambda_k)C_i+\Lambda_kC_{i+1}=(1-M_k)D_i+M_kD_{i+1}$, and the pieces built one after the other by (10) and (12) are
the pieces of that spline.)",
        .kind = Kind::identity,
        .hypotheses = {off_before_last, off_from_last},
        .mutants = {"Lam_k and M_k exchanged", "Lam_k of the whole domain", "pieces started at D_1"}};
    return value;
  }

  template <class S, class P>
  using In = NetInput<S, P>;
  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    return draw_net<S, P>(from, size);
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return {before_last(in.u, in.m), from_last(in.u, in.m)};
  }
  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    return net_failures<S, P>();
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, c, d0, lambda, m] = in;
    const S one = from_int<S>(1);
    const std::vector<P> d = linear_net<S, P>(u, c, lambda, m, d0);
    const std::vector<int> pieces = u.proper_pieces();
    const std::vector<P> first = bezier_points<S, P>(u, d, pieces.front());
    const auto rows = piecewise_net<S, P>(u, c, lambda, m, mutant.is(3) ? first[1] : first[0]);
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      const int k = pieces[p];
      const std::vector<P> c_k = bezier_points<S, P>(u, c, k);
      const std::vector<P> d_k = bezier_points<S, P>(u, d, k);
      equations.equal(d_k, rows[p]);
      const S length = u.piece_end(k) - u.piece_begin(k);
      S lambda_k = (lambda - u.piece_begin(k)) / length;
      S m_k = (m - u.piece_begin(k)) / length;
      if (mutant.is(1)) std::swap(lambda_k, m_k);
      if (mutant.is(2)) lambda_k = (lambda - u[0]) / (u.domain_end() - u[0] + one);
      for (std::size_t i = 0; i + 1 < c_k.size(); ++i) {
        equations.equal(combine(one - lambda_k, c_k[i], lambda_k, c_k[i + 1]),
                        combine(one - m_k, d_k[i], m_k, d_k[i + 1]));
      }
    }
  }
};

}  // namespace torse::proofs::fj07
