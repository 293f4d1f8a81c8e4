// FJ21, section 5: degree elevation by factors and the change of the rulings' length.
//   Eq5_3     p~ = f p, q~ = g q                     Eq5_4     p~ = f p, q~ = f p + g (q-p)
#pragma once

#include <utility>
#include <vector>

#include "torse/developable/factors.hpp"
#include "torse/proofs/claims/fj21/pair.hpp"

namespace torse::proofs::fj21 {

/// Two rows, Lam, M, sigma of them and, independently, of the new rows, and the two factors.
template <class S, class P>
struct FactorInput {
  PairInput<S, P> pair;
  BlossomFunctions<S> raised;  ///< Lam~, M~, sigma~
  Linear<S> f;
  Linear<S> g;

  static FactorInput draw(Source<S>& from, Size size);
};

template <class S, class P>
FactorInput<S, P> FactorInput<S, P>::draw(Source<S>& from, Size size) {
  PairInput<S, P> pair = PairInput<S, P>::draw(from, size);
  BlossomFunctions<S> raised = draw_functions(from);
  S f0 = from.scalar();
  S f1 = from.scalar();
  S g0 = from.scalar();
  return {std::move(pair), std::move(raised), {std::move(f0), std::move(f1)}, {std::move(g0), from.scalar()}};
}

template <class S>
void equal_functions(Equations<S>& equations, const BlossomFunctions<S>& a, const BlossomFunctions<S>& b) {
  equations.equal(a.lambda, b.lambda);
  equations.equal(a.m, b.m);
  equations.equal(a.sigma, b.sigma);
}

/// n f(t) + f(x) and, for the inverse, n f(t) + f_1 (t - x).
template <class S>
S raised_sum(int n, const Linear<S>& f, const S& t, const S& x) {
  return from_int<S>(n) * f(t) + f(x);
}
template <class S>
S lowered_sum(int n, const Linear<S>& f, const S& t, const S& x) {
  return from_int<S>(n) * f(t) + f.slope * (t - x);
}

/// FJ21.5.3 as printed, its inverse, and the case f = g = 1.
struct Eq5_3 : Takes<FactorInput> {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 4;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "FJ21.5.3",
        .source = "equation (5.3)",
        .title = "degree elevation by factors",
        .statement =
            R"(\tilde p=fp,\ \tilde q=gq:\ \Lambda=\frac{nf(t)\tilde\Lambda+f(\tilde\Lambda)t}{nf(t)+f(\tilde\Lambda)},\
M=\frac{ng(t)\tilde M+g(\tilde M)t}{ng(t)+g(\tilde M)},\
\sigma=\frac{ng(t)+g(\tilde M)}{nf(t)+f(\tilde\Lambda)}\tilde\sigma;\quad
\tilde p[t^{\langle n\rangle},\tilde\Lambda]-\tilde\sigma\tilde q[t^{\langle n\rangle},\tilde M]
=\tfrac{nf(t)+f(\tilde\Lambda)}{n+1}\bigl(p[t^{\langle n-1\rangle},\Lambda]-\sigma q[t^{\langle n-1\rangle},M]\bigr))",
        .kind = Kind::equivalence,
        .hypotheses = {{"n f(t) + f(Lam~) is not 0", false},
                       {"n g(t) + g(M~) is not 0", false},
                       {"n f(t) + f_1 (t - Lam) is not 0 (inverse: Lam~ is finite)", false},
                       {"n g(t) + g_1 (t - M) is not 0 (inverse: M~ is finite)", false},
                       {"f(t) is not 0 (inverse)", false},
                       {"g(t) is not 0 (inverse)", false}},
        .mutants = {"f and g exchanged", "sigma unchanged", "n+1 in the place of n", "f(t) in the place of f(Lam~)"},
        .max_pieces = 1,
        .remark =
            "The printed formula gives the old functions from the new ones. Its inverse is Lam~ = (Lam (n f(t) + f_0) "
            "- f_0 t) / "
            "(n f(t) + f_1 (t - Lam)), M~ likewise with g. For f = g = 1: Lam~ = ((n+1) Lam - t)/n and sigma~ = sigma, "
            "so constant functions do not stay constant."};
    return info;
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    const int n = degree_of(in.pair.p);
    const S& t = in.pair.t;
    return {{raised_sum(n, in.f, t, in.raised.lambda)},
            {raised_sum(n, in.g, t, in.raised.m)},
            {lowered_sum(n, in.f, t, in.pair.f.lambda)},
            {lowered_sum(n, in.g, t, in.pair.f.m)},
            {in.f(t)},
            {in.g(t)}};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [p, q, t, plain] = in.pair;
    const S one = from_int<S>(1);
    const S over = from_int<S>(degree_of(p) + 1);
    const int n = mutant.is(3) ? degree_of(p) + 1 : degree_of(p);
    const Linear<S>& f = mutant.is(1) ? in.g : in.f;
    const Linear<S>& g = mutant.is(1) ? in.f : in.g;
    const std::vector<P> fp = times_linear(p, in.f);
    const std::vector<P> gq = times_linear(q, in.g);

    BlossomFunctions<S> lowered = unelevated(n, t, in.raised, f, g);
    if (mutant.is(2)) lowered.sigma = in.raised.sigma;
    if (mutant.is(4)) lowered = unelevated(n, t, in.raised, Linear<S>{f(t), from_int<S>(0)}, g);
    const S factor = (from_int<S>(degree_of(p)) * in.f(t) + in.f(in.raised.lambda)) / over;
    equations.equal(defect(fp, gq, t, in.raised), scaled(factor, defect(p, q, t, lowered)));

    const BlossomFunctions<S> raised = elevated_functions(n, t, plain, f, g);
    const S back = over / (from_int<S>(degree_of(p)) * in.f(t) + in.f(raised.lambda));
    equations.equal(scaled(back, defect(fp, gq, t, raised)), defect(p, q, t, plain));
    equal_functions(equations, unelevated(n, t, raised, f, g), plain);

    const Linear<S> unit{one, from_int<S>(0)};
    const S degree = from_int<S>(degree_of(p));
    equal_functions(equations, elevated_functions(n, t, plain, unit, unit),
                    {(over * plain.lambda - t) / degree, (over * plain.m - t) / degree, plain.sigma});
  }

  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const auto make = [](int lambda, int m, int raised_lambda, int raised_m, Linear<S> f, Linear<S> g) {
      const S one = from_int<S>(1);
      return In<S, P>{line_pair<S, P>(from_int<S>(1), {from_int<S>(lambda), from_int<S>(m), one}),
                      {from_int<S>(raised_lambda), from_int<S>(raised_m), one},
                      std::move(f),
                      std::move(g)};
    };
    const S zero = from_int<S>(0);
    const S one = from_int<S>(1);
    const Linear<S> unit{one, zero};
    const Linear<S> slope{zero, one};  // f(1) = 1, f(x) = x
    const Linear<S> root{-one, one};   // f(1) = 0
    return {{0, make(3, 3, -1, 3, slope, unit)}, {1, make(3, 3, 3, -1, unit, slope)},
            {2, make(2, 3, 3, 3, slope, unit)},  {3, make(3, 2, 3, 3, unit, slope)},
            {4, make(3, 3, 3, 3, root, unit)},   {5, make(3, 3, 3, 3, unit, root)}};
  }
};

/// FJ21.5.4 as printed, its inverse, and the cases f = g and f = sigma = 1.
struct Eq5_4 : Takes<FactorInput> {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 4;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "FJ21.5.4",
        .source = "equation (5.4)",
        .title = "change of the rulings' length",
        .statement = R"(\tilde p=fp,\ \tilde q=fp+g(q-p):\ \Lambda=\frac{f(\tilde\Lambda)t+nf(t)\tilde\Lambda
+\tilde\sigma(n\tilde M(g(t)-f(t))+t(g(\tilde M)-f(\tilde M)))}{H},\ M=\frac{g(\tilde M)t+ng(t)\tilde M}{G},\
\sigma=\tilde\sigma\frac GH,\
G=ng(t)+g(\tilde M),\ H=f(\tilde\Lambda)+nf(t)+\tilde\sigma(g(\tilde M)-f(\tilde M)+n(g(t)-f(t))))",
        .kind = Kind::equivalence,
        .hypotheses = {{"G is not 0", false},
                       {"H is not 0", false},
                       {"n g(t) + g_1 (t - M) is not 0 (inverse: M~ is finite)", false},
                       {"Q = G^2 (n F - f_1 L) + sigma (F^2 (n G - g_1 K) - G^2 (n F - f_1 K)) is not 0 with F = f(t), "
                        "G = g(t), L = "
                        "Lam-t, K = M-t (inverse: Lam~ is finite)",
                        false},
                       {"f(t) is not 0 (inverse)", false},
                       {"g(t) is not 0 (inverse)", false},
                       {"n g(t) + g(Lam~) is not 0 (the case f = g)", false}},
        .mutants = {"f and g exchanged", "sigma unchanged", "the formulas of 5.3", "n+1 in the place of n"},
        .max_pieces = 1,
        .remark =
            "The paper prints the first display of the derivation with Lam in the place of M, and ends the formula "
            "with sigma = "
            "sigma~ = sigma~ G/H. Where g(t) = 0 the ruling has length 0: a singular point of the new patch. For f = 1 "
            "and "
            "sigma~ = 1 also sigma = 1."};
    return info;
  }

  template <class S>
  static S h(int n, const S& t, const BlossomFunctions<S>& e, const Linear<S>& f, const Linear<S>& g) {
    return raised_sum(n, f, t, e.lambda) + e.sigma * (raised_sum(n, g, t, e.m) - raised_sum(n, f, t, e.m));
  }
  template <class S>
  static S inverse_denominator(int n, const S& t, const BlossomFunctions<S>& b, const Linear<S>& f,
                               const Linear<S>& g) {
    const S ft = f(t);
    const S gt = g(t);
    return gt * gt * lowered_sum(n, f, t, b.lambda) +
           b.sigma * (ft * ft * lowered_sum(n, g, t, b.m) - gt * gt * lowered_sum(n, f, t, b.m));
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    const auto& [p, q, t, plain] = in.pair;
    const int n = degree_of(p);
    return {{raised_sum(n, in.g, t, in.raised.m)},
            {h(n, t, in.raised, in.f, in.g)},
            {lowered_sum(n, in.g, t, plain.m)},
            {inverse_denominator(n, t, plain, in.f, in.g)},
            {in.f(t)},
            {in.g(t)},
            {raised_sum(n, in.g, t, in.raised.lambda)}};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [p, q, t, plain] = in.pair;
    const int degree = degree_of(p);
    const S over = from_int<S>(degree + 1);
    const int n = mutant.is(4) ? degree + 1 : degree;
    const Linear<S>& f = mutant.is(1) ? in.g : in.f;
    const Linear<S>& g = mutant.is(1) ? in.f : in.g;
    const std::vector<P> fp = times_linear(p, in.f);
    std::vector<P> q_new = fp;
    const std::vector<P> gp = times_linear(p, in.g);
    const std::vector<P> gq = times_linear(q, in.g);
    for (std::size_t i = 0; i < q_new.size(); ++i) add(q_new[i], difference(gq[i], gp[i]));

    BlossomFunctions<S> lowered = mutant.is(3) ? unelevated(n, t, in.raised, f, g) : unshortened(n, t, in.raised, f, g);
    if (mutant.is(2)) lowered.sigma = in.raised.sigma;
    equations.equal(scaled(over, defect(fp, q_new, t, in.raised)),
                    scaled(h(degree, t, in.raised, in.f, in.g), defect(p, q, t, lowered)));

    const BlossomFunctions<S> raised = shortened_functions(n, t, plain, f, g);
    const S square = in.f(t) * in.g(t);
    const S factor = from_int<S>(degree) * square * square / inverse_denominator(degree, t, plain, in.f, in.g);
    equations.equal(defect(fp, q_new, t, raised), scaled(factor, defect(p, q, t, plain)));
    equal_functions(equations, unshortened(n, t, raised, f, g), plain);
    special_cases(in, equations);
  }

  /// f = g is 5.3; f = sigma~ = 1 is the last formula of the section.
  template <class S, class P>
  static void special_cases(const In<S, P>& in, Equations<S>& equations) {
    const S& t = in.pair.t;
    const Linear<S>& g = in.g;
    const BlossomFunctions<S>& e = in.raised;
    const int degree = degree_of(in.pair.p);
    const S n = from_int<S>(degree);
    const S one = from_int<S>(1);
    equal_functions(equations, unshortened(degree, t, e, g, g), unelevated(degree, t, e, g, g));
    const S at_m = n * g(t) + g(e.m);
    const BlossomFunctions<S> unit = unshortened(degree, t, {e.lambda, e.m, one}, Linear<S>{one, from_int<S>(0)}, g);
    equal_functions(
        equations, unit,
        {(n * e.lambda + n * e.m * (g(t) - one) + t * g(e.m)) / at_m, (g(e.m) * t + n * g(t) * e.m) / at_m, one});
  }

  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const auto make = [](int lambda, int m, BlossomFunctions<S> raised, Linear<S> f, Linear<S> g) {
      const S one = from_int<S>(1);
      return In<S, P>{line_pair<S, P>(one, {from_int<S>(lambda), from_int<S>(m), one}), std::move(raised), std::move(f),
                      std::move(g)};
    };
    const S zero = from_int<S>(0);
    const S one = from_int<S>(1);
    const S two = from_int<S>(2);
    const S three = from_int<S>(3);
    const Linear<S> unit{one, zero};
    const Linear<S> slope{zero, one};  // f(1) = 1, f(x) = x
    const Linear<S> root{-one, one};   // f(1) = 0
    return {{0, make(3, 3, {three, -one, two}, unit, slope)},   {1, make(3, 3, {one, three, one}, slope, unit)},
            {2, make(5, 2, {three, three, one}, slope, slope)}, {3, make(2, 3, {three, three, one}, slope, slope)},
            {4, make(3, 2, {three, two, one}, root, unit)},     {5, make(3, 3, {three, three, one}, unit, root)},
            {6, make(3, 3, {-one, three, one}, unit, slope)}};
  }
};

}  // namespace torse::proofs::fj21
