// FJ21, section 4: the decomposition p' = lambda W + mu W' + nu p and its relation to Lam, M, sigma.
//   Eq4_3     the decomposition under a common factor f       C4_1     Corollary 4.1 in both directions
#pragma once

#include <utility>
#include <vector>

#include "torse/developable/factors.hpp"
#include "torse/proofs/claims/fj21/pair.hpp"

namespace torse::proofs::fj21 {

template <class S>
FrameFunctions<S> draw_frame(Source<S>& from) {
  S lambda = from.scalar();
  S mu = from.scalar();
  return {std::move(lambda), std::move(mu), from.scalar()};
}

/// FJ21.4.3: how lambda, mu, nu change under p~ = f p, q~ = f q. Only f and f' at t matter: f is taken linear.
struct Eq4_3 {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 4;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "FJ21.4.3",
        .source = "equation (4.3)",
        .title = "decomposition of p' and its gauge",
        .statement =
            R"(p'-\lambda W-\mu W'-\nu p=0\iff\tilde p'-\tilde\lambda\tilde W-\tilde\mu\tilde W'-\tilde\nu\tilde p=0
\text{ for }\tilde p=fp,\ \tilde q=fq:\quad\tilde\lambda=\lambda-\mu\tfrac{f'}{f},\ \tilde\mu=\mu,\
\tilde\nu=\nu+\tfrac{f'}{f})",
        .kind = Kind::equivalence,
        .hypotheses = {{"f(t) is not 0", false}},
        .mutants = {"lambda + mu f'/f", "nu - f'/f", "f' in the place of f'/f"},
        .max_pieces = 1,
        .remark =
            "f'/f = -nu cancels nu. That f is rational only if nu is a sum of n_i/(t - t_i) with integers n_i; in "
            "general "
            "exp(-int nu) leaves the rational functions. The decomposition exists where W' and p, q are independent: "
            "not only cylinders are excluded, as (4.2) says, but every patch whose W(t) is a multiple of one fixed "
            "row, a "
            "cone too."};
    return info;
  }

  template <class S, class P>
  struct In {
    std::vector<P> p;
    std::vector<P> q;
    S t;
    FrameFunctions<S> frame;
    Linear<S> f;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    std::vector<P> p = from.template points<P>(size.n + 1);
    std::vector<P> q = from.template points<P>(size.n + 1);
    S t = from.scalar();
    FrameFunctions<S> frame = draw_frame(from);
    S constant = from.scalar();
    return {std::move(p), std::move(q), std::move(t), std::move(frame), {std::move(constant), from.scalar()}};
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return {{in.f(in.t)}};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [p, q, t, frame, f] = in;
    FrameFunctions<S> changed = gauged(frame, f(t), f.slope);
    if (mutant.is(1)) changed.lambda = frame.lambda + frame.mu * f.slope / f(t);
    if (mutant.is(2)) changed.nu = frame.nu - f.slope / f(t);
    if (mutant.is(3)) changed = gauged(frame, from_int<S>(1), f.slope);
    equations.equal(frame_defect(times_linear(p, f), times_linear(q, f), t, changed),
                    scaled(f(t), frame_defect(p, q, t, frame)));
    equations.zero(gauged(frame, f(t), -(frame.nu * f(t))).nu);
  }

  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const S one = from_int<S>(1);
    const PairInput<S, P> pair = line_pair<S, P>(one, {one, one, one});
    return {{0, {pair.p, pair.q, one, {one, one, one}, {one, -one}}}};
  }
};

/// FJ21.C4.1: the two relations are the same one, with either set of functions computed from the other.
struct C4_1 {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 4;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "FJ21.C4.1",
        .source = "Corollary 4.1",
        .title = "Lam, M, sigma and lambda, mu, nu",
        .statement = R"(\Lambda=\frac{n(\mu+1)+(\lambda-\nu)t}{\lambda-\nu},\ M=\frac{\lambda t+n\mu}{\lambda},\
\sigma=\frac{\lambda}{\lambda-\nu};\quad\lambda=\frac{n\sigma}{E},\ \mu=\frac{\sigma(M-t)}{E},\
\nu=\frac{n(\sigma-1)}{E},\
E=\Lambda-\sigma M+t(\sigma-1);\quad
p'-\lambda W-\mu W'-\nu p=\tfrac nE\bigl(p[t^{\langle n-1\rangle},\Lambda]-\sigma q[t^{\langle n-1\rangle},M]\bigr))",
        .kind = Kind::equivalence,
        .hypotheses = {{"E is not 0", false},
                       {"sigma is not 0", false},
                       {"lambda is not 0", false},
                       {"lambda - nu is not 0", false}},
        .mutants = {"n+1 in the place of n", "sigma M in the place of M in mu", "lambda in the place of lambda - nu",
                    "t - M in the place of M - t"},
        .max_pieces = 1,
        .remark =
            "E = 0 puts the edge of regression at v = infinity, where p', W, W', p do not determine lambda, mu, nu: "
            "for sigma = 1 "
            "that is Lam = M, a cone or cylinder. lambda = 0 makes M infinite, lambda = nu makes Lam infinite."};
    return info;
  }

  template <class S, class P>
  struct In {
    PairInput<S, P> pair;
    FrameFunctions<S> frame;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    PairInput<S, P> pair = PairInput<S, P>::draw(from, size);
    return {std::move(pair), draw_frame(from)};
  }

  template <class S>
  static S denominator(const S& t, const BlossomFunctions<S>& f) {
    return f.lambda - f.sigma * f.m + t * (f.sigma - from_int<S>(1));
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return {{denominator(in.pair.t, in.pair.f)}, {in.pair.f.sigma}, {in.frame.lambda}, {in.frame.lambda - in.frame.nu}};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [p, q, t, f] = in.pair;
    const FrameFunctions<S>& frame = in.frame;
    const int degree = degree_of(p);
    const int n = mutant.is(1) ? degree + 1 : degree;

    FrameFunctions<S> to = to_frame(n, t, f);
    if (mutant.is(2)) to.mu = f.sigma * (f.sigma * f.m - t) / denominator(t, f);
    if (mutant.is(4)) to.mu = -to.mu;
    equations.equal(frame_defect(p, q, t, to), scaled(from_int<S>(degree) / denominator(t, f), defect(p, q, t, f)));

    BlossomFunctions<S> back = to_blossom(n, t, frame);
    if (mutant.is(3)) back.sigma = from_int<S>(1) + frame.nu / frame.lambda;
    equations.equal(scaled(frame.lambda - frame.nu, defect(p, q, t, back)), frame_defect(p, q, t, frame));

    const BlossomFunctions<S> f_again = to_blossom(n, t, to_frame(n, t, f));
    equations.equal(f_again.lambda, f.lambda);
    equations.equal(f_again.m, f.m);
    equations.equal(f_again.sigma, f.sigma);
    const FrameFunctions<S> frame_again = to_frame(n, t, to_blossom(n, t, frame));
    equations.equal(frame_again.lambda, frame.lambda);
    equations.equal(frame_again.mu, frame.mu);
    equations.equal(frame_again.nu, frame.nu);
  }

  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const S zero = from_int<S>(0);
    const S one = from_int<S>(1);
    const S two = from_int<S>(2);
    const FrameFunctions<S> frame{two, one, one};
    const BlossomFunctions<S> f{one, two, one};
    return {{0, {line_pair<S, P>(zero, {two, two, one}), frame}},
            {1, {line_pair<S, P>(zero, {one, two, zero}), frame}},
            {2, {line_pair<S, P>(zero, f), {zero, one, one}}},
            {3, {line_pair<S, P>(zero, f), {one, one, one}}}};
  }
};

}  // namespace torse::proofs::fj21
