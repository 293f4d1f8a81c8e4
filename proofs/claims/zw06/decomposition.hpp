// ZW06, case 2: the surface split into a1 and multiples of tau, equations (7) to (10).
//   Eq7, Eq8, Eq9, Eq10
#pragma once

#include <vector>

#include "torse/developable/special.hpp"
#include "torse/proofs/claims/zw06/common.hpp"

namespace torse::proofs::zw06 {

/// Inputs of (7) to (10): rows that obey the equation at u.
struct Decomposition : Takes<JetInput> {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 3;

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>&) {
    return {};
  }
};

/// ZW06.7: r = a1 + (v + b) tau.
struct Eq7 : Decomposition {
  static const ClaimInfo& info() {
    static const ClaimInfo info{.id = "ZW06.7",
                                .source = "case 2, equation (7)",
                                .title = "the surface from a1",
                                .statement = R"(r(u,v)=(1-v)a(u)+vq(u)=a_1(u)+(v+b(u))\tau(u))",
                                .kind = Kind::identity,
                                .hypotheses = {},
                                .mutants = {"v - b", "a1 = a + b tau", "a in the place of b"},
                                .max_pieces = 6,
                                .remark = degrees_remark};
    return info;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const Bernstein<S>& b = mutant.is(3) ? in.equation.a : in.equation.b;
    std::vector<P> tau = in.tau;
    if (mutant.is(2)) {
      for (P& x : tau) scale(x, from_int<S>(-1));
    }
    const P a1 = value(directrix_edge<S, P>(in.c, tau, b), in.u);
    const S at_b = in.equation.b(in.u);
    const S along = mutant.is(1) ? in.v - at_b : in.v + at_b;
    equations.equal(value(restrict_rulings<S, P>(in.c, in.d(), in.v), in.u),
                    combine(from_int<S>(1), a1, along, in.tau_taylor[0]));
  }
};

/// ZW06.8: a1 = a - b tau as a Bezier curve of degree n + deg b.
struct Eq8 : Decomposition {
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "ZW06.8",
        .source = "case 2, equation (8)",
        .title = "the curve a1",
        .statement = R"(a_1(u)=a(u)-b(u)\tau(u)=\sum_kB_k^{n+m}(u)e_k,\
e_k=\sum_{i+j=k}\binom mi\binom nj\binom{n+m}k^{-1}(p_j-b_i\tau_j))",
        .kind = Kind::identity,
        .hypotheses = {},
        .mutants = {"a + b tau", "a in the place of b", "the coefficients of b in reverse order"},
        .max_pieces = 6,
        .remark = degrees_remark};
    return info;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    std::vector<S> b = (mutant.is(2) ? in.equation.a : in.equation.b).coefficients();
    if (mutant.is(3)) b.assign(in.equation.b.coefficients().rbegin(), in.equation.b.coefficients().rend());
    const std::vector<P> edge = directrix_edge<S, P>(in.c, in.tau, Bernstein<S>(b));
    const S at_b = in.equation.b(in.u);
    const S one = from_int<S>(1);
    equations.equal(value(edge, in.u), combine(one, in.at_c, mutant.is(1) ? at_b : -at_b, in.tau_taylor[0]));
    equations.equal(edge.front(), combine(one, in.c.front(), -in.equation.b[0], in.tau.front()));
    equations.equal(edge.back(), combine(one, in.c.back(), -in.equation.b[in.equation.b.degree()], in.tau.back()));
  }
};

/// ZW06.9: a1' = (a - b') tau.
struct Eq9 : Decomposition {
  static const ClaimInfo& info() {
    static const ClaimInfo info{.id = "ZW06.9",
                                .source = "case 2, equation (9)",
                                .title = "the derivative of a1",
                                .statement = R"(a'=a\tau+b\tau'\Rightarrow a_1'=a'-b'\tau-b\tau'=(a-b')\tau)",
                                .kind = Kind::identity,
                                .hypotheses = {},
                                .mutants = {"a + b'", "tau' in the place of tau", "a without b'"},
                                .max_pieces = 6,
                                .remark = degrees_remark};
    return info;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const S a = in.equation.a(in.u);
    const S slope = in.equation.b.derivative()(in.u);
    const S speed = mutant.is(1) ? a + slope : mutant.is(3) ? a : in.speed();
    equations.equal(derivative(directrix_edge<S, P>(in.c, in.tau, in.equation.b), in.u),
                    scaled(speed, in.tau_taylor[mutant.is(2) ? 1 : 0]));
    equations.equal(derivative(in.c, in.u), along(a, in.equation.b(in.u), in.tau, in.u));
  }
};

/// ZW06.10: the parameter v + b.
struct Eq10 : Decomposition {
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "ZW06.10",
        .source = "case 2.1, equation (10)",
        .title = "the parameter from a1 on",
        .statement = R"(\bar v=v+b(u):\ r(u,\bar v-b(u))=a_1(u)+\bar v\tau(u),\ \text{the directrix is }\bar v=b,\
\text{the second row }\bar v=b+1,\ a_1\text{ is }\bar v=0)",
        .kind = Kind::identity,
        .hypotheses = {},
        .mutants = {"v = v~ + b", "a1 at v~ = 1", "b at 1 - u"},
        .max_pieces = 6,
        .remark = "N stands for the degree of b, N - 1 is that of a. The change of parameter needs no a = b'."};
    return info;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const S one = from_int<S>(1);
    const S b = in.equation.b(mutant.is(3) ? one - in.u : in.u);
    const P a1 = value(directrix_edge<S, P>(in.c, in.tau, in.equation.b), in.u);
    const std::vector<P> d = in.d();
    const auto surface = [&](const S& v) { return value(restrict_rulings<S, P>(in.c, d, v), in.u); };
    equations.equal(surface(mutant.is(1) ? in.v + b : in.v - b), combine(one, a1, in.v, in.tau_taylor[0]));
    equations.equal(surface(mutant.is(2) ? one - b : -b), a1);
    equations.equal(combine(one, a1, b, in.tau_taylor[0]), in.at_c);
    equations.equal(combine(one, a1, b + one, in.tau_taylor[0]), value(d, in.u));
  }
};

}  // namespace torse::proofs::zw06
