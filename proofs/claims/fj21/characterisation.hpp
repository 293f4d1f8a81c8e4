// FJ21, section 3: the characterisation of developable surfaces by Lam, M, sigma.
//   Eq3_3     the dependence of the last but one rows, normalised       T3_1     Theorem 3.1, Bezier
//   T3_1_excluded   a developable surface without Lam, M, sigma
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "torse/algebra/dependence.hpp"
#include "torse/developable/factors.hpp"
#include "torse/proofs/claims/fj21/pair.hpp"

namespace torse::proofs::fj21 {

/// The coefficients of lambda_0 p_0 + lambda_1 p_1 = mu_0 q_0 + mu_1 q_1.
template <class S>
struct Coefficients {
  S l0, l1, m0, m1;

  BlossomFunctions<S> functions() const { return from_dependence(l0, l1, m0, m1); }
  NonZero<S> nonzero() const { return {{l0 + l1}, {m0 + m1}}; }
};

template <class S>
Coefficients<S> draw_coefficients(Source<S>& from) {
  S l0 = from.scalar();
  S l1 = from.scalar();
  S m0 = from.scalar();
  return {std::move(l0), std::move(l1), std::move(m0), from.scalar()};
}

/// Makes the last but one rows at t of two curves dependent with the given coefficients. The curves are given by their
/// Bezier rows on [t, t+1], whose second ones are p' and q' on entry; z is free: p_0 = (m_0+m_1) z - l_1 p', p_1 = p_0
/// + (l_0+l_1) p', so that l_0 p_0 + l_1 p_1 = (l_0+l_1)(m_0+m_1) z, and q likewise.
template <class S, class P>
void make_dependent(std::vector<P>& p, std::vector<P>& q, const S& t, const Coefficients<S>& k, const P& z) {
  const auto change = [&](std::vector<P>& local, const S& sum, const S& k0, const S& k1) {
    const P x0 = combine(sum, z, -k1, local[1]);
    const P x1 = combine(sum, z, k0, local[1]);
    const S one = from_int<S>(1);
    local[0] = combine(one - t, x0, t, x1);
    local[1] = combine(-t, x0, one + t, x1);
  };
  change(p, k.m0 + k.m1, k.l0, k.l1);
  change(q, k.l0 + k.l1, k.m0, k.m1);
}

/// FJ21.3.3: the dependence, divided by lambda_0 + lambda_1.
struct Eq3_3 {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 4;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "FJ21.3.3",
        .source = "equation (3.3)",
        .title = "the dependence with Lam, M, sigma",
        .statement =
            R"(\lambda_0p_0+\lambda_1p_1-\mu_0q_0-\mu_1q_1=(\lambda_0+\lambda_1)\bigl((1-\Lambda)p_0+\Lambda p_1
-\sigma((1-M)q_0+Mq_1)\bigr),\ \Lambda=\frac{\lambda_1}{\lambda_0+\lambda_1},\ M=\frac{\mu_1}{\mu_0+\mu_1},\
\sigma=\frac{\mu_0+\mu_1}{\lambda_0+\lambda_1})",
        .kind = Kind::equivalence,
        .hypotheses = {{"lambda_0 + lambda_1 is not 0", true}, {"mu_0 + mu_1 is not 0", false}},
        .mutants = {"lambda_0 and lambda_1 exchanged in Lam", "mu_0 and mu_1 exchanged in M",
                    "1/sigma in the place of sigma"},
        .max_pieces = 1,
        .remark =
            "The paper excludes lambda_0 + lambda_1 = 0 only; mu_0 + mu_1 = 0 (M infinite) has to be excluded as "
            "well."};
    return info;
  }

  template <class S, class P>
  struct In {
    Coefficients<S> k;
    PairInput<S, P> pair;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    Coefficients<S> k = draw_coefficients(from);
    return {std::move(k), PairInput<S, P>::draw(from, size)};
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return in.k.nonzero();
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [l0, l1, m0, m1] = in.k;
    const auto& [p, q, t, unused] = in.pair;
    const KnotList<S> u = bezier_knots<S>(degree_of(p));
    const auto [p0, p1] = last_pair<S, P>(u, p, 1, t);
    const auto [q0, q1] = last_pair<S, P>(u, q, 1, t);
    P dependence = combine(l0, p0, l1, p1);
    add_scaled(dependence, -m0, q0);
    add_scaled(dependence, -m1, q1);
    BlossomFunctions<S> f = in.k.functions();
    if (mutant.is(1)) f.lambda = from_int<S>(1) - f.lambda;
    if (mutant.is(2)) f.m = from_int<S>(1) - f.m;
    if (mutant.is(3)) f.sigma = from_int<S>(1) / f.sigma;
    equations.equal(dependence, scaled(l0 + l1, defect(p, q, t, f)));
  }

  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const S one = from_int<S>(1);
    const PairInput<S, P> pair = line_pair<S, P>(ratio<S>(1, 2), {one, one, one});
    return {{0, {{one, -one, one, one}, pair}}, {1, {{one, one, one, -one}, pair}}};
  }
};

/// FJ21.T3.1 at one parameter: rows with any dependence at t obey 3.5, and rows that obey 3.5 are dependent.
struct T3_1 {
  static constexpr PointKind points = PointKind::coplanar;
  static constexpr int dimension = 4;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "FJ21.T3.1",
        .source = "Theorem 3.1",
        .title = "characterisation by Lam, M, sigma",
        .statement = R"(\operatorname{rank}(p_0^{n-1},p_1^{n-1},q_0^{n-1},q_1^{n-1})(t)\le 3\iff
p[t^{\langle n-1\rangle},\Lambda(t)]=\sigma(t)\,q[t^{\langle n-1\rangle},M(t)])",
        .kind = Kind::equivalence,
        .hypotheses = {{"the dependence has lambda_0 + lambda_1 not 0", true},
                       {"the dependence has mu_0 + mu_1 not 0", false}},
        .mutants = {"Lam and M exchanged", "1/sigma in the place of sigma", "a vertex of q moved",
                    "the relation with t^<n> in the place of t^<n-1>, Lam"},
        .max_pieces = 1,
        .remark =
            "'Generic' in the theorem means: neither lambda_0 + lambda_1 nor mu_0 + mu_1 vanishes identically. The "
            "relation always implies developability. The converse fails, for example, for every tangent surface given "
            "by p and "
            "q = p' (raised to degree n): p_1 - p_0 = q/n is the only dependence and no finite Lam exists; and for "
            "cones and "
            "cylinders with q' parallel to p'. Lam, M, sigma are rational because the dependence is solved over the "
            "rational functions of t."};
    return info;
  }

  template <class S, class P>
  struct In {
    std::vector<P> p;
    std::vector<P> q;
    S t;
    Coefficients<S> k;
  };

  template <class S, class P>
  static In<S, P> build(const S& t, const Coefficients<S>& k, std::vector<P> p, std::vector<P> q, const P& z) {
    make_dependent(p, q, t, k, z);
    std::vector<P> p_rows = from_local(p, t);
    return {std::move(p_rows), from_local(q, t), t, k};
  }

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    const std::vector<P> p = from.template points<P>(size.n + 1);
    const std::vector<P> q = from.template points<P>(size.n + 1);
    const P z = from.template point<P>();
    const S t = from.scalar();
    return build<S, P>(t, draw_coefficients(from), p, q, z);
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return in.k.nonzero();
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    std::vector<P> q = in.q;
    if (mutant.is(3)) add(q.front(), in.p.back());
    BlossomFunctions<S> f = in.k.functions();
    if (mutant.is(1)) std::swap(f.lambda, f.m);
    if (mutant.is(2)) f.sigma = from_int<S>(1) / f.sigma;
    if (mutant.is(4)) f.lambda = in.t;
    const KnotList<S> u = bezier_knots<S>(degree_of(in.p));
    equations.equal(tangent(in.p, in.t, f.lambda), scaled(f.sigma, tangent(q, in.t, f.m)));
    const auto [p0, p1] = last_pair<S, P>(u, in.p, 1, in.t);
    const auto [q0, q1] = last_pair<S, P>(u, q, 1, in.t);
    equations.zero(dependence_residual(std::array<P, 4>{p0, p1, q0, q1}));
  }

  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const S one = from_int<S>(1);
    const PairInput<S, P> pair = line_pair<S, P>(ratio<S>(1, 3), {one, one, one});
    return {{0, build<S, P>(pair.t, {one, -one, one, one}, pair.p, pair.q, pair.p[0])},
            {1, build<S, P>(pair.t, {one, one, one, -one}, pair.p, pair.q, pair.p[0])}};
  }
};

/// The excluded case of FJ21.T3.1: p and q = p' bound a developable surface, but no Lam, M, sigma belong to it.
struct T3_1_excluded {
  static constexpr PointKind points = PointKind::coplanar;
  static constexpr int dimension = 4;
  static const ClaimInfo& info() {
    static const ClaimInfo info{.id = "FJ21.T3.1.excluded",
                                .source = "Theorem 3.1, the excluded case",
                                .title = "a developable surface without Lam, M, sigma",
                                .statement = R"(q=p'\Rightarrow p_1^{n-1}-p_0^{n-1}=\tfrac1n q(t),\quad
p[t^{\langle n-1\rangle},\Lambda]-\sigma q[t^{\langle n-1\rangle},M]
=p+\bigl(\tfrac{\Lambda-t}{n}-\sigma\bigr)p'-\sigma\tfrac{M-t}{n}\,p''\ne 0
\text{ where } p,p',p''\text{ are independent})",
                                .kind = Kind::equivalence,
                                .hypotheses = {},
                                .mutants = {"the hodograph not raised to degree n but scaled by 1/n",
                                            "the sign of the p'' term", "q(t) in the place of q(t)/n"},
                                .max_pieces = 1,
                                .remark =
                                    "The surface of the tangents of a rational curve, drawn between p and its "
                                    "derivative row p': a generic torse, and "
                                    "lambda_0 + lambda_1 vanishes at every t. The exclusion is a property of the two "
                                    "rows, not of the surface."};
    return info;
  }

  template <class S, class P>
  struct In {
    std::vector<P> p;
    S t;
    BlossomFunctions<S> f;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    std::vector<P> p = from.template points<P>(size.n + 1);
    S t = from.scalar();
    return {std::move(p), std::move(t), draw_functions(from)};
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>&) {
    return {};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [p, t, f] = in;
    const S one = from_int<S>(1);
    const S n = from_int<S>(degree_of(p));
    const std::vector<P> q =
        times_linear(hodograph<S>(p), Linear<S>{mutant.is(1) ? one + one / n : one, from_int<S>(0)});
    const KnotList<S> u = bezier_knots<S>(degree_of(p));
    const auto [p0, p1] = last_pair<S, P>(u, p, 1, t);
    const auto [q0, q1] = last_pair<S, P>(u, q, 1, t);
    equations.zero(dependence_residual(std::array<P, 4>{p0, p1, q0, q1}));

    const P dp = bernstein_sum(hodograph<S>(p), t);
    equations.equal(difference(p1, p0), scaled(mutant.is(3) ? one + one / n : one / n, dp));
    P expected = combine(one, bernstein_sum(p, t), (f.lambda - t) / n - f.sigma, dp);
    if (degree_of(p) > 1) {
      const S factor = f.sigma * (f.m - t) / n;
      add_scaled(expected, mutant.is(2) ? factor : -factor, bernstein_sum(hodograph<S>(hodograph<S>(p)), t));
    }
    equations.equal(defect(p, q, t, f), expected);
  }
};

}  // namespace torse::proofs::fj21
