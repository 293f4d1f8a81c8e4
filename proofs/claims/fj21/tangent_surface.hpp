// FJ21, section 6: patches with constant Lam, M and sigma = 1 and tangent surfaces.
//   T6_1            Theorem 6.1 in both directions, Lam != M
//   T6_1_cone       its exception Lam = M: cones and cylinders
#pragma once

#include <utility>
#include <vector>

#include "torse/developable/pieces.hpp"
#include "torse/developable/regression.hpp"
#include "torse/proofs/claims/fj21/pair.hpp"

namespace torse::proofs::fj21 {

/// FJ21.T6.1: r of degree n+1 gives the patch, and every patch comes from one r.
struct T6_1 {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 4;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "FJ21.T6.1",
        .source = "Theorem 6.1",
        .title = "constant Lam, M, sigma = 1: tangent surfaces",
        .statement =
            R"(p=r+\tfrac{M-t}{n+1}r',\
q=r+\tfrac{\Lambda-t}{n+1}r'\iff p[t^{\langle n-1\rangle},\Lambda]=q[t^{\langle n-1\rangle},M]\ (\Lambda\ne M),
\quad r=\frac{(\Lambda-t)p+(t-M)q}{\Lambda-M},\ q-p=\tfrac{\Lambda-M}{n+1}r',\
p'=\tfrac{n}{n+1}r'+\tfrac{M-t}{n+1}r'',\ \Delta^n(q-p)=(\Lambda-M)\Delta^{n+1}r)",
        .kind = Kind::equivalence,
        .hypotheses = {{"Lam is not M", false}},
        .mutants = {"n in the place of n+1", "Lam and M exchanged in p and q", "t - M in the place of M - t",
                    "r' in the place of r' (Lam-M)"},
        .max_pieces = 1,
        .remark =
            "The linear statement needs Lam != M and nothing else: r (n+2 rows) corresponds one to one to the pairs "
            "(p, q). What "
            "the words 'rational curves of degree n', 'ruling generators of degree n' and 'tangent surface' add: (1) q "
            "- p has degree "
            "n iff r has degree n+1; lower r still give patches. (2) p has degree n unless b + (n+1) M a = 0 for r = a "
            "t^{n+1} + "
            "b t^n + ..; q likewise with Lam. (3) r not one point in space: else p, q are that point. (4) r not a "
            "line: else no "
            "surface; r planar gives a plane. (5) the weight of r is not C (t-M)^{n+1} or C (t-Lam)^{n+1}, else p or q "
            "lies at "
            "infinity. (6) Lam = M gives cones and cylinders, FJ21.T6.1.cone. FJ21.T6.1.witnesses has an example for "
            "each."};
    return info;
  }

  template <class S, class P>
  struct In {
    std::vector<P> r;  ///< any curve of degree n+1
    std::vector<P> w;  ///< any rulings q - p of degree n
    P start;           ///< p_0: with w, Lam and M it decides p
    S lambda;
    S m;
    S t;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    std::vector<P> r = from.template points<P>(size.n + 2);
    std::vector<P> w = from.template points<P>(size.n + 1);
    P start = from.template point<P>();
    S lambda = from.scalar();
    S m = from.scalar();
    return {std::move(r), std::move(w), std::move(start), std::move(lambda), std::move(m), from.scalar()};
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return {{in.lambda - in.m}};
  }

  /// The highest difference of a row: its leading coefficient.
  template <class P>
  static P leading(std::vector<P> rows) {
    while (rows.size() > 1) {
      for (std::size_t i = 0; i + 1 < rows.size(); ++i) rows[i] = difference(rows[i + 1], rows[i]);
      rows.pop_back();
    }
    return rows.front();
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [r, w, start, lambda, m, t] = in;
    const S one = from_int<S>(1);
    const int n = degree_of(w);
    const S over = from_int<S>(mutant.is(1) ? n : n + 1);
    const S width = lambda - m;
    const BlossomFunctions<S> f{lambda, m, one};

    const std::vector<P> p = edge_patch(r, mutant.is(2) ? lambda : m);
    const std::vector<P> q = edge_patch(r, mutant.is(2) ? m : lambda);
    const P r_t = bernstein_sum(r, t);
    const P dr = bernstein_sum(hodograph<S>(r), t);
    const S to_m = (mutant.is(3) ? t - m : m - t) / over;
    equations.equal(value(p, t), combine(one, r_t, to_m, dr));
    equations.equal(value(q, t), combine(one, r_t, (lambda - t) / over, dr));
    equations.equal(tangent(p, t, lambda), tangent(q, t, m));
    equations.equal(edge_curve(p, q, f), r);
    equations.equal(derivative(p, t),
                    combine(from_int<S>(n) / over, dr, to_m, bernstein_sum(hodograph<S>(hodograph<S>(r)), t)));
    P top = leading(q);
    subtract(top, leading(p));
    equations.equal(top, scaled(mutant.is(4) ? one : width, leading(r)));

    // The converse: Lam, M, w and p_0 free; the relation decides the differences of p.
    std::vector<P> left{start};
    for (int j = 0; j < n; ++j) {
      const std::size_t at = static_cast<std::size_t>(j);
      left.push_back(combine((one - m) / width, w[at], m / width, w[at + 1]));
      add(left[at + 1], left[at]);
    }
    std::vector<P> right = left;
    for (std::size_t j = 0; j < right.size(); ++j) add(right[j], w[j]);
    equations.equal(tangent(left, t, lambda), tangent(right, t, m));
    const std::vector<P> edge = edge_curve(left, right, f);
    equations.equal(edge_patch(edge, m), left);
    equations.equal(edge_patch(edge, lambda), right);
    equations.equal(scaled(over, bernstein_sum(w, t)), scaled(width, bernstein_sum(hodograph<S>(edge), t)));
  }

  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const S one = from_int<S>(1);
    const PairInput<S, P> pair = line_pair<S, P>(one, {one, one, one});
    return {{0, {{pair.p[0], pair.p[1], pair.q[0]}, pair.q, pair.p[0], one, one, one}}};
  }
};

/// The exception Lam = M of FJ21.T6.1: q = p + (t-M)^n A, all rulings through one point A.
struct T6_1_cone {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 4;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "FJ21.T6.1.cone",
        .source = "Theorem 6.1, the exception Lam = M",
        .title = "Lam = M: cones and cylinders",
        .statement =
            R"(\Lambda=M,\ \sigma=1:\quad p[t^{\langle n-1\rangle},M]=q[t^{\langle n-1\rangle},M]\iff q=p+(t-M)^nA,\quad
(\Lambda-t)p+(t-M)q=(t-M)^{n+1}A)",
        .kind = Kind::equivalence,
        .hypotheses = {{"M is not 0: p and q_0 decide q", false}},
        .mutants = {"(t-M)^{n+1} in the place of (t-M)^n", "t + M in the place of t - M", "p in the place of q - p"},
        .max_pieces = 1,
        .remark =
            "A cone with vertex A, a cylinder if A has weight 0; q = p if A = 0. Every cone and cylinder has such "
            "patches, so "
            "constant Lam, M, sigma = 1 cover all rational developable surfaces only with Lam = M allowed. The "
            "hypothesis is of the "
            "construction, not of the equivalence."};
    return info;
  }

  template <class S, class P>
  struct In {
    std::vector<P> p;
    P a;
    P start;  ///< q_0 of the converse
    S m;
    S t;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    std::vector<P> p = from.template points<P>(size.n + 1);
    P a = from.template point<P>();
    P start = from.template point<P>();
    S m = from.scalar();
    return {std::move(p), std::move(a), std::move(start), std::move(m), from.scalar()};
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return {{in.m}};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [p, a, start, m, t] = in;
    const int n = degree_of(p);
    const S one = from_int<S>(1);
    const S root = mutant.is(2) ? -m : m;
    std::vector<P> power{a};  // the rows of (t-M)^n A
    for (int i = 0; i < n; ++i) power = times_linear(power, Linear<S>{-root, one});
    std::vector<P> q = mutant.is(3) ? std::vector<P>(p.size(), PointTraits<P>::zero()) : p;
    for (std::size_t i = 0; i < q.size(); ++i) add(q[i], power[i]);
    equations.equal(tangent(p, t, m), tangent(q, t, m));

    S factor = one;
    for (int i = mutant.is(1) ? -1 : 0; i <= n; ++i) factor *= t - m;
    equations.equal(combine(m - t, value(p, t), t - m, value(q, t)), scaled(factor, a));

    // The converse: the net with Lam = M through p and q_0, where (t-M)^n A is A (-M)^n at 0.
    const std::vector<P> net = aumann_net<S, P>(p, m, m, start);
    P at_0 = difference(start, p.front());
    S back = one;
    for (int i = 0; i < n; ++i) back *= (t - m) / -m;
    equations.equal(difference(bernstein_sum(net, t), bernstein_sum(p, t)), scaled(back, at_0));
  }

  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const S one = from_int<S>(1);
    const PairInput<S, P> pair = line_pair<S, P>(one, {one, one, one});
    return {{0, {pair.p, pair.q[0], pair.q[1], from_int<S>(0), one}}};
  }
};

}  // namespace torse::proofs::fj21
