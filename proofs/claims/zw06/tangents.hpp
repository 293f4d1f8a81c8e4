// ZW06, case 2.2: tangent surfaces, equations (14) to (17).
//   Eq14, Eq15, Eq16, Eq17
#pragma once

#include <utility>
#include <vector>

#include "torse/developable/directrix_nets.hpp"
#include "torse/developable/special.hpp"
#include "torse/proofs/claims/zw06/common.hpp"

namespace torse::proofs::zw06 {

/// Inputs of (14) and (15): rows that obey the equation at u.
struct TangentSurface : Takes<JetInput> {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 3;

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return {{in.speed()}};
  }
  /// a = 1 + 2u, b = u^2 + u, where a = b' for every u.
  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const DirectrixEquation<S> equation{Bernstein<S>({from_int<S>(1), from_int<S>(3)}),
                                        Bernstein<S>({from_int<S>(0), ratio<S>(1, 2), from_int<S>(2)})};
    return {{0, make_jet<S, P>(equation, from_int<S>(3), from_int<S>(5), fj07::example_points<S, P>(3),
                               fj07::example_points<S, P>(3, 3))}};
  }
};

inline constexpr Hypothesis moving_edge{"a - b' is not 0 at u: elsewhere a1 stands still", false};

/// ZW06.14: the parameter along the tangents of a1.
struct Eq14 : TangentSurface {
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "ZW06.14",
        .source = "case 2.2, equation (14)",
        .title = "the parameter along the tangents",
        .statement = R"(\tau=\frac{a_1'}{a-b'},\ \bar v=\frac{v+b}{a-b'};\ \bar v=0\text{ at }v=-b,\text{ where }
r=a_1\text{ and }r_u=a\,\tau\text{ is parallel to }r_v=\tau)",
        .kind = Kind::identity,
        .hypotheses = {moving_edge},
        .mutants = {"a + b' in the place of a - b'", "v~ = 0 at v = b", "r_u = (a - b') tau"},
        .max_pieces = 6,
        .remark =
            "N stands for the degree of b, N - 1 is that of a. The paper asks for a != b' as functions; where a - b' "
            "has a "
            "root the edge has a stationary point and (14) no value."};
    return info;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const S one = from_int<S>(1);
    const std::vector<P> edge = directrix_edge<S, P>(in.c, in.tau, in.equation.b);
    const S a = in.equation.a(in.u);
    const S b = in.equation.b(in.u);
    const S speed = mutant.is(1) ? a + in.equation.b.derivative()(in.u) : in.speed();
    equations.equal(scaled(one / speed, derivative(edge, in.u)), in.tau_taylor[0]);
    const std::vector<P> singular = restrict_rulings<S, P>(in.c, in.d(), mutant.is(2) ? b : -b);
    equations.equal(value(singular, in.u), value(edge, in.u));
    equations.equal(derivative(singular, in.u), scaled(mutant.is(3) ? in.speed() : a, in.tau_taylor[0]));
  }
};

/// ZW06.15: the tangent surface of a1.
struct Eq15 : TangentSurface {
  static const ClaimInfo& info() {
    static const ClaimInfo info{.id = "ZW06.15",
                                .source = "case 2.2, equation (15)",
                                .title = "a != b': the tangent surface of a1",
                                .statement = R"(r(u,v)=a_1(u)+\bar va_1'(u),\ \bar v=\frac{v+b(u)}{a(u)-b'(u)})",
                                .kind = Kind::identity,
                                .hypotheses = {moving_edge},
                                .mutants = {"v - b", "a in the place of a - b'", "a' in the place of a1'"},
                                .max_pieces = 6,
                                .remark = degrees_remark};
    return info;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const S one = from_int<S>(1);
    const std::vector<P> edge = directrix_edge<S, P>(in.c, in.tau, in.equation.b);
    const S b = in.equation.b(in.u);
    const S speed = mutant.is(2) ? in.equation.a(in.u) : in.speed();
    const S along = (mutant.is(1) ? in.v - b : in.v + b) / speed;
    const P tangent = derivative(mutant.is(3) ? in.c : edge, in.u);
    equations.equal(value(restrict_rulings<S, P>(in.c, in.d(), in.v), in.u),
                    combine(one, value(edge, in.u), along, tangent));
  }
};

/// What (16), (17) and (18) share: a directrix and a parameter.
struct FreeDirectrix : Takes<RowInput> {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 3;

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>&) {
    return {};
  }
};

/// ZW06.16: a = 2, b = u.
struct Eq16 : FreeDirectrix {
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "ZW06.16",
        .source = "case 2.2 (1), equation (16)",
        .title = "a = 2, b = u: the tangents of the running mean",
        .statement = R"(q_i=p_i+(n-i)A_i+iA_{i-1},\ A_i=\frac1{(i+1)(i+2)}\sum_{j\le i}(j+1)\Delta p_j\Rightarrow
a'=2\tau+u\tau',\ (i+2)\tau_i=(n-i)\Delta p_i+i\Delta p_{i-1}+i\tau_{i-1};\
A_i=m_{i+1}-m_i,\ a_1=\sum_iB_i^nm_i,\ \tau=a_1',\ m_i=\frac{p_0+\dots+p_i}{i+1})",
        .kind = Kind::identity,
        .hypotheses = {},
        .mutants = {"a = 1", "b = 1 - u", "m_i without p_0", "i + 1 in the place of i + 2 in the recursion"},
        .max_pieces = 1,
        .remark =
            "The edge of regression is the running mean (1/u) int_0^u a of the directrix, which the paper does not "
            "note. It has degree n, not n + 1."};
    return info;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const S zero = from_int<S>(0);
    const S one = from_int<S>(1);
    const std::vector<P>& c = in.c;
    const int n = degree_of(c);
    const std::vector<P> tau = rulings_of(c, mean_tangent_net<S, P>(c));
    const Bernstein<S> a({from_int<S>(mutant.is(1) ? 1 : 2)});
    const Bernstein<S> b(mutant.is(2) ? std::vector<S>{one, zero} : std::vector<S>{zero, one});
    require_equation(in, tau, {a, b}, equations);

    std::vector<P> means;
    P total = PointTraits<P>::zero();
    for (int i = 0; i <= n; ++i) {
      if (i > 0 || !mutant.is(3)) add(total, c[static_cast<std::size_t>(i)]);
      means.push_back(scaled(ratio<S>(1, i + 1), total));
    }
    equations.equal(directrix_edge<S, P>(c, tau, b), at_degree<S, P>(means, n + 1));
    equations.equal(derivative(means, in.u), value(tau, in.u));
    for (int i = 0; i <= n; ++i) {
      const std::size_t at_i = static_cast<std::size_t>(i);
      P right = PointTraits<P>::zero();
      if (i < n) add_scaled(right, from_int<S>(n - i), difference(c[at_i + 1], c[at_i]));
      if (i > 0) {
        add_scaled(right, from_int<S>(i), difference(c[at_i], c[at_i - 1]));
        add_scaled(right, from_int<S>(i), tau[at_i - 1]);
      }
      equations.equal(scaled(from_int<S>(mutant.is(4) ? i + 1 : i + 2), tau[at_i]), right);
    }
  }
};

/// ZW06.17: a = 1, b = 0.
struct Eq17 : FreeDirectrix {
  static const ClaimInfo& info() {
    static const ClaimInfo info{.id = "ZW06.17",
                                .source = "case 2.2 (2), equation (17)",
                                .title = "a = 1, b = 0: the tangents of the directrix",
                                .statement = R"(q_i=p_i+(n-i)\Delta p_i+i\Delta p_{i-1}\Rightarrow a'=\tau,\ a_1=a)",
                                .kind = Kind::identity,
                                .hypotheses = {},
                                .mutants = {"a = n", "i and n - i exchanged", "the edge is the second row"},
                                .max_pieces = 1,
                                .remark = "The net of FJ07.7: the directrix is its own edge of regression."};
    return info;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const std::vector<P>& c = in.c;
    const int n = degree_of(c);
    const std::vector<P> d = tangent_net<S, P>(c);
    const std::vector<P> tau = rulings_of(c, d);
    const Bernstein<S> b({from_int<S>(0)});
    require_equation(in, tau, {Bernstein<S>({from_int<S>(mutant.is(1) ? n + 1 : 1)}), b}, equations);
    equations.equal(directrix_edge<S, P>(c, tau, b), mutant.is(3) ? d : c);
    for (int i = 0; i <= n; ++i) {
      const std::size_t at_i = static_cast<std::size_t>(i);
      const int ahead = mutant.is(2) ? i : n - i;
      P ruling = PointTraits<P>::zero();
      if (i < n) add_scaled(ruling, from_int<S>(ahead), difference(c[at_i + 1], c[at_i]));
      if (i > 0) add_scaled(ruling, from_int<S>(n - ahead), difference(c[at_i], c[at_i - 1]));
      equations.equal(tau[at_i], ruling);
    }
  }
};

}  // namespace torse::proofs::zw06
