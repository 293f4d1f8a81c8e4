// FJ21, section 6: the edge of regression.
//   Eq6       alpha, beta and v(t)                          Eq6_1     r = (1-v) p + v q, and its degree
//   C6_1      Corollary 6.1: r is tangent to the rulings
#pragma once

#include <utility>
#include <vector>

#include "torse/developable/regression.hpp"
#include "torse/proofs/claims/fj21/pair.hpp"

namespace torse::proofs::fj21 {

/// E = Lam - t + sigma (t-M).
template <class S>
S edge_denominator(const S& t, const BlossomFunctions<S>& f) {
  return f.lambda - t + f.sigma * (t - f.m);
}

/// FJ21.6: at v(t) the derivative along a coordinate line is alpha W + beta r; alpha, beta against Lam, M, sigma.
struct Eq6 : Takes<PairInput> {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 4;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "FJ21.6",
        .source = "section 6, before Corollary 6.1",
        .title = "singular points: alpha, beta, v",
        .statement = R"((1-v)p'+vq'=\alpha(q-p)+\beta((1-v)p+vq),\
\alpha=\frac{n\sigma(\Lambda-M)}{(\Lambda-t+\sigma(t-M))^2},\ \beta=\frac{n(\sigma-1)}{\Lambda-t+\sigma(t-M)},\
v=\frac{\sigma(t-M)}{\Lambda-t+\sigma(t-M)};\quad
\Lambda=t+\frac{n(1-v)}{\alpha+(v-1)\beta},\ M=t-\frac{nv}{\alpha+v\beta},\
\sigma=\frac{\alpha+v\beta}{\alpha+(v-1)\beta})",
        .kind = Kind::equivalence,
        .hypotheses = {{"E = Lam - t + sigma (t-M) is not 0", false}, {"sigma is not 0", false}},
        .mutants = {"E in the place of E^2 in alpha", "sigma + 1 in the place of sigma - 1 in beta",
                    "M - t in the place of t - M in v", "n+1 in the place of n"},
        .max_pieces = 1,
        .remark =
            "The difference of the two sides is n/E times the defect of the blossom relation, so the relation holds "
            "iff this "
            "does. E = 0: the singular point is q - p, at v = infinity. sigma = 0 only spoils the printed formula for "
            "M."};
    return info;
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return {{edge_denominator(in.t, in.f)}, {in.f.sigma}};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [p, q, t, f] = in;
    const S one = from_int<S>(1);
    const S n = from_int<S>(degree_of(p));
    S v = edge_parameter(t, f);
    if (mutant.is(3)) v = -v;
    EdgeSpeed<S> speed = edge_speed(mutant.is(4) ? degree_of(p) + 1 : degree_of(p), t, f);
    if (mutant.is(1)) speed.alpha *= edge_denominator(t, f);
    if (mutant.is(2)) speed.beta = n * (f.sigma + one) / edge_denominator(t, f);

    P rest = combine(one - v, derivative(p, t), v, derivative(q, t));
    add_scaled(rest, -speed.alpha, difference(value(q, t), value(p, t)));
    add_scaled(rest, -speed.beta, edge_row(v, value(p, t), value(q, t)));
    equations.equal(rest, scaled(n / edge_denominator(t, f), defect(p, q, t, f)));

    const S left = speed.alpha + (v - one) * speed.beta;
    const S right = speed.alpha + v * speed.beta;
    equations.equal(left * (f.lambda - t), n * (one - v));
    equations.equal(t - n * v / right, f.m);
    equations.equal(right / left, f.sigma);
  }

  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const S zero = from_int<S>(0);
    const S one = from_int<S>(1);
    const S two = from_int<S>(2);
    return {{0, line_pair<S, P>(zero, {one, one, one})}, {1, line_pair<S, P>(zero, {one, two, zero})}};
  }
};

/// FJ21.6.1: v(t), and for constant Lam, M, sigma the edge as a polynomial row R of degree n+1 with R' = (n+1)(sigma q
/// - p).
struct Eq6_1 : Takes<PairInput> {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 4;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "FJ21.6.1",
        .source = "equation (6.1)",
        .title = "the edge of regression and its degree",
        .statement =
            R"(r=(1-v)p+vq,\ v=\frac{\sigma(t-M)}{\Lambda-t+\sigma(t-M)};\quad\text{constant }\Lambda,M,\sigma:\
R:=(\Lambda-t+\sigma(t-M))\,r=(\Lambda-t)p+\sigma(t-M)q,\ \deg R\le n+1,\ R'=(n+1)(\sigma q-p))",
        .hypotheses = {{"Lam - t + sigma (t-M) is not 0", false}, {"Lam is not M", false}},
        .mutants = {"Lam and M exchanged in v", "sigma left out", "n in the place of n+1 in R'",
                    "1-v in the place of v"},
        .max_pieces = 1,
        .remark =
            "The degree is n+1 for every constant sigma, but only sigma = 1 makes v(t) a polynomial of degree one, as "
            "the paper "
            "says: otherwise v is a quotient of two and r has the denominator Lam - t + sigma (t-M), which cancels in "
            "space. "
            "The degree is lower iff sigma q - p has degree below n; R has a common factor where the curve has a "
            "lower degree in space. For Lam = M, R is (Lam-t)^{n+1} times a constant row: the vertex of a cone, at "
            "infinity "
            "for a cylinder."};
    return info;
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return {{edge_denominator(in.t, in.f)}, {in.f.lambda - in.f.m}};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [p, q, t, f] = in;
    const S one = from_int<S>(1);
    BlossomFunctions<S> used = f;
    if (mutant.is(1)) std::swap(used.lambda, used.m);
    if (mutant.is(2)) used.sigma = one + one;
    S v = edge_parameter(t, used);
    if (mutant.is(4)) v = one - v;

    const S width = f.lambda - f.m;
    const std::vector<P> edge = edge_curve(p, q, f);
    P r = combine(f.lambda - t, bernstein_sum(p, t), f.sigma * (t - f.m), bernstein_sum(q, t));
    equations.equal(scaled(width, value(edge, t)), r);
    divide(r, edge_denominator(t, f));
    equations.equal(edge_row(v, value(p, t), value(q, t)), r);

    const int n = degree_of(p);
    P speed = combine(f.sigma, value(q, t), from_int<S>(-1), value(p, t));
    scale(speed, from_int<S>(mutant.is(3) ? n : n + 1));
    add_scaled(speed, from_int<S>(n), defect(p, q, t, f));
    equations.equal(scaled(width, bernstein_sum(hodograph<S>(edge), t)), speed);
  }

  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const S zero = from_int<S>(0);
    const S one = from_int<S>(1);
    const S two = from_int<S>(2);
    return {{0, line_pair<S, P>(zero, {two, one, two})}, {1, line_pair<S, P>(zero, {one, one, two})}};
  }
};

/// FJ21.C6.1: r' = (alpha + v') (q-p) + beta r for functions Lam(t), M(t), sigma(t) with any derivatives at t.
struct C6_1 {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 4;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "FJ21.C6.1",
        .source = "Corollary 6.1",
        .title = "the edge of regression is tangent to the rulings",
        .statement =
            R"(r=(1-v)p+vq:\quad r'=(\alpha+v')(q-p)+\beta\,r\iff
p[t^{\langle n-1\rangle},\Lambda]=\sigma\,q[t^{\langle n-1\rangle},M])",
        .kind = Kind::equivalence,
        .hypotheses = {{"Lam - t + sigma (t-M) is not 0", false}},
        .mutants = {"v' left out", "the derivative of sigma left out of v'", "alpha - v' in the place of alpha + v'"},
        .max_pieces = 1,
        .remark =
            "r is an edge where alpha + v' is not 0; alpha + v' = 0 for all t means r' = beta r, one point in space: a "
            "cone or "
            "cylinder. The paper's 'has a rational edge of regression' includes these."};
    return info;
  }

  template <class S, class P>
  struct In {
    PairInput<S, P> pair;
    BlossomFunctions<S> rate;  ///< Lam', M', sigma' at t
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    PairInput<S, P> pair = PairInput<S, P>::draw(from, size);
    return {std::move(pair), draw_functions(from)};
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return {{edge_denominator(in.pair.t, in.pair.f)}};
  }

  /// The rows of degree n+2 of E r = (Lam(x) - x) p(x) + sigma(x) (x - M(x)) q(x) for the linear functions of x with
  /// the given values and derivatives at t.
  template <class S, class Q>
  static std::vector<Q> numerator(const std::vector<Q>& p, const std::vector<Q>& q, const S& t,
                                  const BlossomFunctions<S>& f, const BlossomFunctions<S>& rate) {
    const auto line = [&](const S& value_at_t, const S& slope) { return Linear<S>{value_at_t - slope * t, slope}; };
    const S one = from_int<S>(1);
    std::vector<Q> rows =
        times_linear(times_linear(p, line(f.lambda - t, rate.lambda - one)), Linear<S>{one, from_int<S>(0)});
    const std::vector<Q> right = times_linear(times_linear(q, line(f.sigma, rate.sigma)), line(t - f.m, one - rate.m));
    for (std::size_t i = 0; i < rows.size(); ++i) add(rows[i], right[i]);
    return rows;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [p, q, t, f] = in.pair;
    const S one = from_int<S>(1);
    const S e = edge_denominator(t, f);

    // r' by the quotient rule from polynomial rows; the denominator is the same construction on rows 1.
    const std::vector<P> rows = numerator(p, q, t, f, in.rate);
    const std::vector<Vec<S, 1>> ones(p.size(), Vec<S, 1>::Constant(one));
    const std::vector<Vec<S, 1>> denominators = numerator(ones, ones, t, f, in.rate);
    P r = value(rows, t);
    divide(r, value(denominators, t)[0]);
    P dr = derivative(rows, t);
    add_scaled(dr, -derivative(denominators, t)[0], r);
    divide(dr, value(denominators, t)[0]);

    const S v = edge_parameter(t, f);
    const S sigma_rate = mutant.is(2) ? from_int<S>(0) : in.rate.sigma;
    const S top_rate = sigma_rate * (t - f.m) + f.sigma * (one - in.rate.m);
    const S v_rate = (top_rate * e - f.sigma * (t - f.m) * (in.rate.lambda - one + top_rate)) / (e * e);
    const EdgeSpeed<S> speed = edge_speed(degree_of(p), t, f);
    const S along = mutant.is(1) ? speed.alpha : mutant.is(3) ? speed.alpha - v_rate : speed.alpha + v_rate;
    P rest = dr;
    add_scaled(rest, -along, difference(value(q, t), value(p, t)));
    add_scaled(rest, -speed.beta, edge_row(v, value(p, t), value(q, t)));
    equations.equal(r, edge_row(v, bernstein_sum(p, t), bernstein_sum(q, t)));
    equations.equal(rest, scaled(from_int<S>(degree_of(p)) / e, defect(p, q, t, f)));
  }

  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const S zero = from_int<S>(0);
    const S one = from_int<S>(1);
    return {{0, {line_pair<S, P>(zero, {one, one, one}), {one, zero, one}}}};
  }
};

}  // namespace torse::proofs::fj21
