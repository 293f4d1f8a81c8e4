// FJ21, sections 3 and 4: blossoms of homogeneous rows.
//   Eq3_5     the tangent as a blossom, on every piece of a spline
//   Eq4_4     points, derivatives and 4.3 through p[t^<n-1>, 0] and p[t^<n-1>, 1]
#pragma once

#include <utility>
#include <vector>

#include "torse/proofs/claims/fj21/pair.hpp"
#include "torse/spline/basis.hpp"

namespace torse::proofs::fj21 {

/// FJ21.3.5: p[t^<n-1>, X] on every piece of a spline: a combination of the last but one points (3.4), and the point of
/// the tangent at p(t) with parameter X, both by Cox and de Boor's basis.
struct Eq3_5 {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 4;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "FJ21.3.5",
        .source = "equations (3.4), (3.5)",
        .title = "the blossom p[t,..,t,Lam] on a spline",
        .statement =
            R"(p[t^{\langle n-1\rangle},\Lambda]=(1-\Lambda_k)p_0^{n-1}(t)+\Lambda_k\,p_1^{n-1}(t)
=p(t)+\tfrac{\Lambda-t}{n}\,p'(t),
\qquad\Lambda_k=\frac{\Lambda-u_{n+k-2}}{u_{n+k-1}-u_{n+k-2}})",
        .hypotheses = {},
        .mutants = {"the global Lam in the place of the piece's Lam_k", "p'/(n+1) in the place of p'/n",
                    "Lam and t exchanged in the second form"}};
    return info;
  }

  template <class S, class P>
  struct In {
    KnotList<S> u;
    std::vector<P> p;
    S t;
    S lambda;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    KnotList<S> u(size.n, from.knots(size));
    std::vector<P> p = from.template points<P>(size.last() + 1);
    S t = from.scalar();
    return {std::move(u), std::move(p), std::move(t), from.scalar()};
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>&) {
    return {};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, p, t, lambda] = in;
    const int n = u.degree();
    for (int k : u.proper_pieces()) {
      const P point = tangent_point<S, P>(u, p, k, t, at(lambda));
      const S length = u.piece_end(k) - u.piece_begin(k);
      const S local = mutant.is(1) ? lambda : (lambda - u.piece_begin(k)) / length;
      const auto [p0, p1] = last_pair<S, P>(u, p, k, t);
      equations.equal(point, combine(from_int<S>(1) - local, p0, local, p1));

      const std::vector<BinaryForm<S>> basis = basis_forms(u, k);
      const S right = (t - u.piece_begin(k)) / length;
      const S left = from_int<S>(1) - right;
      const S step = (mutant.is(3) ? t - lambda : lambda - t) / (from_int<S>(mutant.is(2) ? n + 1 : n) * length);
      P by_basis = PointTraits<P>::zero();
      for (int i = 0; i <= n; ++i) {
        const BinaryForm<S>& f = basis[static_cast<std::size_t>(i)];
        const S slope = f.derivative_t()(left, right) - f.derivative_s()(left, right);
        add_scaled(by_basis, f(left, right) + step * slope, p[static_cast<std::size_t>(k - 1 + i)]);
      }
      equations.equal(point, by_basis);
    }
  }
};

/// FJ21.4.4 and the line after it: p, p' and the decomposition 4.3 in p[t^<n-1>, 0], p[t^<n-1>, 1] and those of q.
struct Eq4_4 {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 4;
  static const ClaimInfo& info() {
    static const ClaimInfo info{.id = "FJ21.4.4",
                                .source = "equation (4.4)",
                                .title = "points and derivatives by blossoms",
                                .statement = R"(p(t)=(1-t)p_0+t\,p_1,\ p'(t)=n(p_1-p_0);\quad
p'-\lambda W-\mu W'-\nu p=(n(1+\mu)+t(\lambda-\nu))p_1+((1-t)(\lambda-\nu)-n(1+\mu))p_0-(\lambda t+n\mu)q_1
-(\lambda(1-t)-n\mu)q_0,
\quad p_i=p[t^{\langle n-1\rangle},i],\ q_i=q[t^{\langle n-1\rangle},i])",
                                .hypotheses = {},
                                .mutants = {"p_0 and p_1 exchanged in p(t)", "n+1 in the place of n", "the sign of nu"},
                                .max_pieces = 1};
    return info;
  }

  template <class S, class P>
  struct In {
    PairInput<S, P> pair;  ///< lambda, mu, nu in the place of Lam, M, sigma
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    return {PairInput<S, P>::draw(from, size)};
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>&) {
    return {};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [p, q, t, f] = in.pair;
    const S lambda = f.lambda;
    const S mu = f.m;
    const S nu = mutant.is(3) ? -f.sigma : f.sigma;
    const S one = from_int<S>(1);
    const S n = from_int<S>(mutant.is(2) ? degree_of(p) + 1 : degree_of(p));
    const KnotList<S> u = bezier_knots<S>(degree_of(p));
    const auto [p0, p1] = last_pair<S, P>(u, p, 1, t);
    const auto [q0, q1] = last_pair<S, P>(u, q, 1, t);
    const P p_t = bernstein_sum(p, t);
    const P dp = bernstein_sum(hodograph<S>(p), t);
    const P q_t = bernstein_sum(q, t);
    const P dq = bernstein_sum(hodograph<S>(q), t);
    equations.equal(p_t, mutant.is(1) ? combine(t, p0, one - t, p1) : combine(one - t, p0, t, p1));
    equations.equal(dp, scaled(n, difference(p1, p0)));
    equations.equal(q_t, combine(one - t, q0, t, q1));
    equations.equal(dq, scaled(n, difference(q1, q0)));

    P grouped = combine(n * (one + mu) + t * (lambda - nu), p1, (one - t) * (lambda - nu) - n * (one + mu), p0);
    add_scaled(grouped, -(lambda * t + n * mu), q1);
    add_scaled(grouped, n * mu - lambda * (one - t), q0);
    P decomposition = dp;
    add_scaled(decomposition, -lambda, difference(q_t, p_t));
    add_scaled(decomposition, -mu, difference(dq, dp));
    add_scaled(decomposition, -f.sigma, p_t);
    equations.equal(decomposition, grouped);
  }
};

}  // namespace torse::proofs::fj21
