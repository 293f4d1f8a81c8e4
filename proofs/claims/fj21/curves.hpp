// FJ21, sections 3 and 4: rational curves by their points and weights.
//   Eq3_1     the rational de Casteljau algorithm       Eq3_2     derivatives of a rational curve
//   Eq4_1     two parameters of a ruling
#pragma once

#include <string>
#include <vector>

#include "torse/developable/ruled.hpp"
#include "torse/proofs/claims/fj21/pair.hpp"

namespace torse::proofs::fj21 {

/// FJ21.3.1: every step of the algorithm on affine points and weights, against the homogeneous one of the library.
struct Eq3_1 {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "FJ21.3.1",
        .source = "equation (3.1)",
        .title = "rational de Casteljau algorithm",
        .statement = R"(w_i^r=(1-t)w_i^{r-1}+t\,w_{i+1}^{r-1},\quad
c_i^r=(1-t)\frac{w_i^{r-1}}{w_i^r}c_i^{r-1}+t\frac{w_{i+1}^{r-1}}{w_i^r}c_{i+1}^{r-1},\quad c(t)=c_0^n(t))",
        .hypotheses = {{"no weight w_i^r(t), r = 1..n, vanishes", false}},
        .mutants = {"the weights w_i^{r-1} and w_{i+1}^{r-1} exchanged", "t and 1-t exchanged",
                    "the points combined without their weights"},
        .max_pieces = 1,
        .remark =
            "Positive weights and t in [0, 1] suffice. Without them an intermediate point may lie at infinity although "
            "the curve point exists; the homogeneous form has no such exception."};
    return info;
  }

  template <class S, class P>
  struct In {
    WeightedInput<S, P> curve;
    S t;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    WeightedInput<S, P> curve = draw_weighted<S, P>(from, size);
    return {std::move(curve), from.scalar()};
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    std::vector<S> factors;
    std::vector<S> w = in.curve.w;
    while (w.size() > 1) {
      for (std::size_t i = 0; i + 1 < w.size(); ++i) {
        w[i] = (from_int<S>(1) - in.t) * w[i] + in.t * w[i + 1];
        factors.push_back(w[i]);
      }
      w.pop_back();
    }
    return {factors};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const int n = degree_of(in.curve.c);
    const KnotList<S> u = bezier_knots<S>(n);
    std::vector<S> w = in.curve.w;
    std::vector<P> c = in.curve.c;
    const S s = mutant.is(2) ? in.t : from_int<S>(1) - in.t;
    const S t = mutant.is(2) ? from_int<S>(1) - in.t : in.t;
    for (int r = 1; r <= n; ++r) {
      const std::vector<Parameter<S>> arguments = repeated(at(in.t), r);
      const std::vector<P> rows = blossom_row<S, P>(u, in.curve.rows(), 1, arguments);
      const std::vector<Vec<S, 1>> weights = blossom_row<S, Vec<S, 1>>(u, in.curve.weights(), 1, arguments);
      for (int i = 0; i <= n - r; ++i) {
        const std::size_t here = static_cast<std::size_t>(i);
        const S next = s * w[here] + t * w[here + 1];
        const S left = mutant.is(3) ? s : s * (mutant.is(1) ? w[here + 1] : w[here]) / next;
        const S right = mutant.is(3) ? t : t * (mutant.is(1) ? w[here] : w[here + 1]) / next;
        c[here] = combine(left, c[here], right, c[here + 1]);
        w[here] = next;
        equations.equal(weights[here][0], w[here]);
        equations.equal(rows[here], scaled(weights[here][0], c[here]));
      }
    }
  }

  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const S half = ratio<S>(1, 2);
    return {{0, {{{from_int<S>(1), from_int<S>(-1)}, line_pair<S, P>(half, {half, half, half}).p}, half}}};
  }
};

/// FJ21.3.2: p' and w' as differences of the last but one points, and c' from them.
struct Eq3_2 {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "FJ21.3.2",
        .source = "equation (3.2)",
        .title = "derivative of a rational curve",
        .statement = R"(p'=n(w_1^{n-1}c_1^{n-1}-w_0^{n-1}c_0^{n-1}),\quad w'=n(w_1^{n-1}-w_0^{n-1}),\quad
c'(t)=\frac{p'-w'c}{w}=\frac{n\,w_0^{n-1}w_1^{n-1}}{w^2}\,(c_1^{n-1}-c_0^{n-1}))",
        .hypotheses = {{"w(t) is not 0", false}, {"w_0^{n-1}(t) and w_1^{n-1}(t) are not 0", false}},
        .mutants = {"w in the place of w^2", "n-1 in the place of n", "c_0^{n-1} and c_1^{n-1} exchanged",
                    "the weights of the two points left out"},
        .max_pieces = 1,
        .remark =
            "c' exists wherever w(t) is not 0; the last form needs the two points c_0^{n-1}, c_1^{n-1} as well, which "
            "lie "
            "at infinity where their weights vanish."};
    return info;
  }

  template <class S, class P>
  using In = Eq3_1::In<S, P>;

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    return Eq3_1::draw<S, P>(from, size);
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    const std::vector<Vec<S, 1>> w = in.curve.weights();
    return {{value(w, in.t)[0]}, {tangent(w, in.t, from_int<S>(0))[0], tangent(w, in.t, from_int<S>(1))[0]}};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const std::vector<P> rows = in.curve.rows();
    const std::vector<Vec<S, 1>> weights = in.curve.weights();
    const int degree = degree_of(rows);
    const S n = from_int<S>(mutant.is(2) ? degree - 1 : degree);
    const KnotList<S> u = bezier_knots<S>(degree);
    auto [p0, p1] = last_pair<S, P>(u, rows, 1, in.t);
    const auto [w0, w1] = last_pair<S, Vec<S, 1>>(u, weights, 1, in.t);

    const std::vector<P> direct = in.curve.rows();
    const P dp = bernstein_sum(hodograph<S>(direct), in.t);
    const S dw = bernstein_sum(hodograph<S>(weights), in.t)[0];
    const S w = bernstein_sum(weights, in.t)[0];
    equations.equal(dp, scaled(n, difference(p1, p0)));
    equations.equal(dw, n * (w1[0] - w0[0]));

    P quotient_rule = dp;
    add_scaled(quotient_rule, -(dw / w), bernstein_sum(direct, in.t));
    divide(quotient_rule, w);
    divide(p0, w0[0]);
    divide(p1, w1[0]);
    const S factor = mutant.is(4) ? n : n * w0[0] * w1[0] / (mutant.is(1) ? w : w * w);
    equations.equal(quotient_rule, scaled(mutant.is(3) ? -factor : factor, difference(p1, p0)));
  }

  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const S half = ratio<S>(1, 2);
    const std::vector<P> c = line_pair<S, P>(half, {half, half, half}).p;
    return {{0, {{{from_int<S>(1), from_int<S>(-1)}, c}, half}}, {1, {{{from_int<S>(0), from_int<S>(1)}, c}, half}}};
  }
};

/// FJ21.4.1: the homogeneous parameter of a ruling against the affine one.
struct Eq4_1 {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "FJ21.4.1",
        .source = "equation (4.1)",
        .title = "two parameters of a rational ruled surface",
        .statement =
            R"(\frac{(1-\tilde v)p(t)+\tilde v q(t)}{(1-\tilde v)w(t)+\tilde v\omega(t)}=(1-v)c(t)+v\,d(t),\qquad
v=\frac{\tilde v\,\omega(t)}{(1-\tilde v)w(t)+\tilde v\,\omega(t)})",
        .hypotheses = {{"w(t) is not 0", false},
                       {"omega(t) is not 0", false},
                       {"(1-v) w(t) + v omega(t) is not 0", false}},
        .mutants = {"w and omega exchanged", "the weights left out",
                    "the weight w in the place of the common denominator"},
        .max_pieces = 1,
        .remark =
            "On a ruling whose end weights have different signs one value of v in [0, 1] is the point at infinity."};
    return info;
  }

  template <class S, class P>
  struct In {
    WeightedInput<S, P> c;
    WeightedInput<S, P> d;
    S t;
    S v;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    WeightedInput<S, P> c = draw_weighted<S, P>(from, size);
    WeightedInput<S, P> d = draw_weighted<S, P>(from, size);
    S t = from.scalar();
    return {std::move(c), std::move(d), std::move(t), from.scalar()};
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    const S w = value(in.c.weights(), in.t)[0];
    const S omega = value(in.d.weights(), in.t)[0];
    return {{w}, {omega}, {(from_int<S>(1) - in.v) * w + in.v * omega}};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const S one = from_int<S>(1);
    const S w = value(in.c.weights(), in.t)[0];
    const S omega = value(in.d.weights(), in.t)[0];
    const S v = mutant.is(1)   ? standard_parameter(in.v, omega, w)
                : mutant.is(2) ? in.v
                : mutant.is(3) ? in.v * omega / w
                               : standard_parameter(in.v, w, omega);
    P c = bernstein_sum(in.c.rows(), in.t);
    P d = bernstein_sum(in.d.rows(), in.t);
    P homogeneous = combine(one - in.v, c, in.v, d);
    divide(homogeneous,
           (one - in.v) * bernstein_sum(in.c.weights(), in.t)[0] + in.v * bernstein_sum(in.d.weights(), in.t)[0]);
    equations.equal(homogeneous, combine((one - v) / w, value(in.c.rows(), in.t), v / omega, value(in.d.rows(), in.t)));
    equations.equal(standard_parameter(v, omega, w), in.v);
  }

  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const S half = ratio<S>(1, 2);
    const S one = from_int<S>(1);
    const PairInput<S, P> pair = line_pair<S, P>(half, {half, half, half});
    const WeightedInput<S, P> zero{{one, -one}, pair.p};
    const WeightedInput<S, P> c{{one, one}, pair.p};
    const WeightedInput<S, P> d{{-one, -one}, pair.q};
    return {{0, {zero, c, half, half}}, {1, {c, zero, half, half}}, {2, {c, d, half, half}}};
  }
};

}  // namespace torse::proofs::fj21
