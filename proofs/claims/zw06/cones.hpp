// ZW06, case 2.1: cones, equations (11) to (13).
//   Eq11, Eq12, Eq13
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "torse/developable/directrix_nets.hpp"
#include "torse/developable/special.hpp"
#include "torse/proofs/claims/zw06/common.hpp"

namespace torse::proofs::zw06 {

/// ZW06.11: a = b' is a cone with vertex a1.
struct Eq11 {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "ZW06.11",
        .source = "case 2.1, equation (11)",
        .title = "a = b': cones",
        .statement = R"(a=b'\Leftrightarrow a'=(b\tau)'\Leftrightarrow a=V+b\tau\text{ with a point }V;\quad
a_1=V,\ r(u,v)=V+(v+b(u))\tau(u))",
        .kind = Kind::identity,
        .hypotheses = {},
        .mutants = {"vertex c_0 + b_0 tau_0", "a = -b'", "the vertex 2 V"},
        .max_pieces = 4,
        .remark =
            "N stands for the degree of b, at most n. For b of degree m >= 2 a directrix fits only if it takes one "
            "value V at "
            "all roots of b; for m = 1 V is its value at the root, for constant b any point."};
    return info;
  }

  template <class S, class P>
  struct In {
    P vertex;
    Bernstein<S> b;
    std::vector<P> low_tau;
    S u;
    S v;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    P vertex = from.template point<P>();
    const int m = std::min(size.pieces, size.n);
    Bernstein<S> b = draw_polynomial(from, m);
    std::vector<P> tau = from.template points<P>(size.n - m + 1);
    S u = from.scalar();
    return {std::move(vertex), std::move(b), std::move(tau), std::move(u), from.scalar()};
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>&) {
    return {};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const S one = from_int<S>(1);
    std::vector<P> c = times_polynomial<S, P>(in.b, in.low_tau);
    for (P& x : c) add(x, in.vertex);
    const std::vector<P> tau = at_degree<S, P>(in.low_tau, degree_of(c));
    const DirectrixEquation<S> equation{in.b.derivative(), in.b};
    const P tau_u = fj21::bernstein_sum(in.low_tau, in.u);
    equations.equal(value(c, in.u), combine(one, in.vertex, in.b(in.u), tau_u));

    const S a = equation.a(in.u);
    equations.equal(derivative(c, in.u), along(mutant.is(2) ? -a : a, in.b(in.u), tau, in.u));
    const P vertex = mutant.is(3) ? scaled(one + one, in.vertex) : in.vertex;
    for (const P& x : directrix_edge<S, P>(c, tau, in.b)) equations.equal(x, vertex);
    equations.equal(
        mutant.is(1) ? combine(one, c.front(), in.b[0], tau.front()) : directrix_vertex<S, P>(c, tau, equation),
        in.vertex);
    equations.equal(value(restrict_rulings<S, P>(c, second_row(c, tau), in.v), in.u),
                    combine(one, in.vertex, in.v + in.b(in.u), tau_u));
  }
};

/// ZW06.12: a = 0, b = 1/(rho-1).
struct Eq12 {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "ZW06.12",
        .source = "case 2.1 (1), equation (12)",
        .title = "cones: a = 0, b constant",
        .statement = R"(q_i=q_0+\rho(p_i-p_0)\Rightarrow a'=\tfrac1{\rho-1}\tau',\text{ a cone with vertex }
\tfrac{\rho p_0-q_0}{\rho-1})",
        .kind = Kind::identity,
        .hypotheses = {{"rho is not 1", true}},
        .mutants = {"b = 1/(rho+1)", "b = rho - 1", "rho - 1 in the place of rho in the net"},
        .max_pieces = 1,
        .remark = "q_0 is free: kappa = 1 solves b kappa' = 0."};
    return info;
  }

  template <class S, class P>
  struct In {
    RowInput<S, P> row;
    P d0;
    S rho;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    RowInput<S, P> row = RowInput<S, P>::draw(from, size);
    P d0 = from.template point<P>();
    return {std::move(row), std::move(d0), from.scalar()};
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return {{in.rho - from_int<S>(1)}};
  }
  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const std::vector<P> x = fj07::example_points<S, P>(4);
    return {{0, {{{x[0], x[1], x[2]}, from_int<S>(2)}, x[3], from_int<S>(1)}}};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const S one = from_int<S>(1);
    const std::vector<P>& c = in.row.c;
    const std::vector<P> d = cone_net<S, P>(c, in.rho, in.d0);
    const S over = mutant.is(1) ? in.rho + one : in.rho - one;
    const S b = mutant.is(2) ? over : one / over;
    const std::vector<P> tau = rulings_of(c, d);
    require_equation(in.row, tau, {Bernstein<S>({from_int<S>(0)}), Bernstein<S>({b})}, equations);
    const S ratio = mutant.is(3) ? in.rho - one : in.rho;
    for (std::size_t i = 0; i < c.size(); ++i) {
      equations.equal(d[i], combine(one, in.d0, ratio, difference(c[i], c[0])));
    }
    const P vertex = combine(in.rho / over, c[0], -(one / over), in.d0);
    for (const P& x : directrix_edge<S, P>(c, tau, Bernstein<S>({b}))) equations.equal(x, vertex);
  }
};

/// ZW06.13: a = s, b = s u.
struct Eq13 {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "ZW06.13",
        .source = "case 2.1 (2), equation (13)",
        .title = "cones: a = s, b = s u",
        .statement = R"(q_i=p_i+\frac{(n-i)p_{i+1}+(i+1)p_i-(n+1)p_0}{(i+1)s},\ q_n=p_n+\frac{p_n-p_0}s
\Rightarrow a'=s\tau+su\tau',\ (i+1)s\tau_i-is\tau_{i-1}=(n-i)\Delta p_i+i\Delta p_{i-1},\text{ vertex }p_0)",
        .kind = Kind::identity,
        .hypotheses = {{"s is not 0", false}},
        .mutants = {"n p_0 in the place of (n+1) p_0", "b = s (1-u)", "vertex p_n"},
        .max_pieces = 1,
        .remark =
            "s u tau = a(u) - p_0: every ruling joins p_0 to the directrix; at u = 0 it is the tangent there. The "
            "paper does not "
            "say that the vertex is p_0."};
    return info;
  }

  template <class S, class P>
  struct In {
    RowInput<S, P> row;
    S s;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    RowInput<S, P> row = RowInput<S, P>::draw(from, size);
    return {std::move(row), from.scalar()};
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return {{in.s}};
  }
  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    return {{0, {{fj07::example_points<S, P>(3), from_int<S>(2)}, from_int<S>(0)}}};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const S zero = from_int<S>(0);
    const std::vector<P>& c = in.row.c;
    const int n = degree_of(c);
    std::vector<P> tau = rulings_of(c, start_cone_net<S, P>(c, in.s));
    if (mutant.is(1)) {
      for (int i = 0; i <= n; ++i) {
        add_scaled(tau[static_cast<std::size_t>(i)], from_int<S>(1) / (from_int<S>(i + 1) * in.s), c[0]);
      }
    }
    const Bernstein<S> b(mutant.is(2) ? std::vector<S>{in.s, zero} : std::vector<S>{zero, in.s});
    require_equation(in.row, tau, {Bernstein<S>({in.s}), b}, equations);
    for (const P& x : directrix_edge<S, P>(c, tau, b)) equations.equal(x, mutant.is(3) ? c.back() : c.front());
    equations.equal(scaled(in.s, tau.back()), difference(c.back(), c.front()));
    for (int i = 0; i <= n; ++i) {
      const std::size_t at_i = static_cast<std::size_t>(i);
      P left = scaled(from_int<S>(i + 1) * in.s, tau[at_i]);
      if (i > 0) add_scaled(left, from_int<S>(-i) * in.s, tau[at_i - 1]);
      P right = PointTraits<P>::zero();
      if (i < n) add_scaled(right, from_int<S>(n - i), difference(c[at_i + 1], c[at_i]));
      if (i > 0) add_scaled(right, from_int<S>(i), difference(c[at_i], c[at_i - 1]));
      equations.equal(left, right);
    }
  }
};

}  // namespace torse::proofs::zw06
