// FJ21, section 5: what operations on rational curves do to Lam, M, sigma.
//   W         weights times constants           Eq5_1     Moebius transformations
//   Eq5_2     ... of the functions
#pragma once

#include <utility>
#include <vector>

#include "torse/developable/moebius.hpp"
#include "torse/proofs/claims/fj21/pair.hpp"

namespace torse::proofs::fj21 {

/// FJ21.W: weights of p times alpha, of q times beta.
struct W {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 4;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "FJ21.W",
        .source = "section 5, multiplication of weights by a constant",
        .title = "weights times constants",
        .statement = R"(\tilde p=\alpha p,\ \tilde q=\beta q:\quad\tilde\Lambda=\Lambda,\ \tilde M=M,\
\tilde\sigma=\frac{\alpha}{\beta}\sigma)",
        .kind = Kind::equivalence,
        .hypotheses = {{"beta is not 0", false}},
        .mutants = {"beta sigma / alpha", "alpha beta sigma", "Lam and M exchanged"},
        .max_pieces = 1,
        .remark =
            "alpha = 0 gives no curve, but the equation holds. Every constant sigma becomes 1 by scaling the weights "
            "of q."};
    return info;
  }

  template <class S, class P>
  struct In {
    PairInput<S, P> pair;
    S alpha;
    S beta;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    PairInput<S, P> pair = PairInput<S, P>::draw(from, size);
    S alpha = from.scalar();
    return {std::move(pair), std::move(alpha), from.scalar()};
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return {{in.beta}};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [p, q, t, f] = in.pair;
    std::vector<P> scaled_p = p;
    std::vector<P> scaled_q = q;
    for (P& row : scaled_p) scale(row, in.alpha);
    for (P& row : scaled_q) scale(row, in.beta);
    BlossomFunctions<S> changed = scaled_weights(f, in.alpha, in.beta);
    if (mutant.is(1)) changed.sigma = in.beta * f.sigma / in.alpha;
    if (mutant.is(2)) changed.sigma = in.alpha * f.sigma * in.beta;
    if (mutant.is(3)) std::swap(changed.lambda, changed.m);
    equations.equal(defect(scaled_p, scaled_q, t, changed), scaled(in.alpha, defect(p, q, t, f)));
  }

  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const S one = from_int<S>(1);
    return {{0, {line_pair<S, P>(one, {one, one, one}), one, from_int<S>(0)}}};
  }
};

/// FJ21.5.1: t(u) as a map of [0, 1] and the rows of the reparametrised curve.
struct Eq5_1 {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 4;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "FJ21.5.1",
        .source = "equation (5.1)",
        .title = "Moebius transformations of the parameter",
        .statement = R"(t(u)=\frac{u}{(1-b)u+b},\quad\sum_i b^{n-i}p_iB_i^n(u)=((1-b)u+b)^n\,p(t(u)),\quad
t(0)=0,\ t(1)=1,\ 0<t(u)<1\text{ for }0<u<1)",
        .hypotheses = {{"b is not 0", false}, {"(1-b) u + b is not 0", false}},
        .mutants = {"b^i in the place of b^{n-i}", "(1-b) u + 1 in the place of (1-b) u + b", "((1-b) u + b)^{n-1}"},
        .max_pieces = 1,
        .remark =
            "A map of [0, 1] onto itself for b > 0 only; for b < 0 it has a pole between 0 and 1. The inverse is the "
            "same map "
            "with 1/b."};
    return info;
  }

  template <class S, class P>
  struct In {
    std::vector<P> p;
    S b;
    S x;  ///< u = x / (x + y), so that 0 < u < 1 for positive x, y
    S y;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    std::vector<P> p = from.template points<P>(size.n + 1);
    S b = from.positive();
    S x = from.positive();
    return {std::move(p), std::move(b), std::move(x), from.positive()};
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return {{in.b}, {in.x + in.y, in.x + in.b * in.y}};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [p, b, x, y] = in;
    const S zero = from_int<S>(0);
    const S one = from_int<S>(1);
    const int n = degree_of(p);
    const S u = x / (x + y);
    const S t = mutant.is(2) ? u / ((one - b) * u + one) : moebius_parameter(b, u);
    equations.equal(t, x / (x + b * y));
    equations.equal(moebius_parameter(one / b, t), u);
    equations.equal(moebius_parameter(b, zero), zero);
    equations.equal(moebius_parameter(b, one), one);
    equations.positive(t);
    equations.positive(one - t);

    std::vector<P> rows = moebius_rows(p, b);
    if (mutant.is(1)) {
      rows = moebius_rows(std::vector<P>(p.rbegin(), p.rend()), b);
      rows = std::vector<P>(rows.rbegin(), rows.rend());
    }
    S power = one;
    for (int i = mutant.is(3) ? 1 : 0; i < n; ++i) power *= (one - b) * u + b;
    equations.equal(value(rows, u), scaled(power, bernstein_sum(p, x / (x + b * y))));
  }

  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const S one = from_int<S>(1);
    const std::vector<P> p = line_pair<S, P>(one, {one, one, one}).p;
    return {{0, {p, from_int<S>(0), one, one}}, {1, {p, -one, one, one}}};
  }
};

/// FJ21.5.2: Lam~, M~, sigma~ of the reparametrised rows, and the way back as printed.
struct Eq5_2 {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 4;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "FJ21.5.2",
        .source = "equation (5.2)",
        .title = "Lam, M, sigma under a Moebius transformation",
        .statement = R"(\tilde\Lambda=\frac{b\Lambda}{1+(b-1)\Lambda},\ \tilde M=\frac{bM}{1+(b-1)M},\
\tilde\sigma=\sigma\frac{1+(b-1)M}{1+(b-1)\Lambda}\ \text{at } t(u);\quad
\tilde p[u^{\langle n-1\rangle},\tilde\Lambda]-\tilde\sigma\tilde q[u^{\langle n-1\rangle},\tilde M]
=((1-b)u+b)^{n-1}\bigl((1-b)\tilde\Lambda+b\bigr)
\bigl(p[t^{\langle n-1\rangle},\Lambda]-\sigma q[t^{\langle n-1\rangle},M]\bigr))",
        .kind = Kind::equivalence,
        .hypotheses = {{"(1-b) u + b is not 0", false},
                       {"1 + (b-1) Lam is not 0", false},
                       {"1 + (b-1) M is not 0", false},
                       {"b is not 0", false}},
        .mutants = {"Lam and M exchanged in sigma~", "the inverse map for Lam~ and M~", "sigma unchanged"},
        .max_pieces = 1,
        .remark =
            "A Moebius transformation may send Lam or M to infinity: Lam = 1/(1-b). The surface then falls into the "
            "excluded "
            "case of Theorem 3.1. b = 0 only makes the inverse fail."};
    return info;
  }

  template <class S, class P>
  struct In {
    PairInput<S, P> pair;  ///< t is the new parameter u
    S b;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    PairInput<S, P> pair = PairInput<S, P>::draw(from, size);
    return {std::move(pair), from.scalar()};
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    const S one = from_int<S>(1);
    return {{(one - in.b) * in.pair.t + in.b},
            {one + (in.b - one) * in.pair.f.lambda},
            {one + (in.b - one) * in.pair.f.m},
            {in.b}};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [p, q, u, f] = in.pair;
    const S& b = in.b;
    const S one = from_int<S>(1);
    const S t = moebius_parameter(b, u);
    BlossomFunctions<S> changed = moebius_functions(f, b);
    if (mutant.is(1)) changed.sigma = f.sigma * f.sigma / changed.sigma;
    if (mutant.is(2)) changed = {f.lambda / ((one - b) * f.lambda + b), f.m / ((one - b) * f.m + b), changed.sigma};
    if (mutant.is(3)) changed.sigma = f.sigma;

    S factor = b / (one + (b - one) * f.lambda);
    for (int i = 1; i < degree_of(p); ++i) factor *= (one - b) * u + b;
    equations.equal(defect(moebius_rows(p, b), moebius_rows(q, b), u, changed), scaled(factor, defect(p, q, t, f)));

    const S at_lambda = (one - b) * changed.lambda + b;
    const S at_m = (one - b) * changed.m + b;
    equations.equal(changed.lambda / at_lambda, f.lambda);
    equations.equal(changed.m / at_m, f.m);
    equations.equal(changed.sigma * at_m / at_lambda, f.sigma);
  }

  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const S zero = from_int<S>(0);
    const S one = from_int<S>(1);
    const S two = from_int<S>(2);
    const S three = from_int<S>(3);
    return {{0, {line_pair<S, P>(two, {three, three, one}), two}},
            {1, {line_pair<S, P>(three, {-one, three, one}), two}},
            {2, {line_pair<S, P>(three, {three, -one, one}), two}},
            {3, {line_pair<S, P>(three, {three, two, one}), zero}}};
  }
};

}  // namespace torse::proofs::fj21
