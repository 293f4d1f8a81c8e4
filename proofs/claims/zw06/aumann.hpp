// ZW06, case 2.2 (4): Aumann's surfaces, equations (19) and (20).
//   Eq19, Eq20
#pragma once

#include <utility>
#include <vector>

#include "torse/developable/directrix_nets.hpp"
#include "torse/proofs/claims/zw06/common.hpp"

namespace torse::proofs::zw06 {

inline constexpr Hypothesis proper_rho{"rho is not 1", true};

/// ZW06.19: the coefficients of the equation, and what they imply.
struct Eq19 {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "ZW06.19",
        .source = "case 2.2 (4), equation (19)",
        .title = "the equations of Aumann's surfaces",
        .statement = R"(X_i=(\rho-1)\Delta p_i-(\tau_{i+1}-\sigma\tau_i),\
E_i=(\rho-1)\cdot\text{coefficient }i\text{ of }a'-a\tau-b\tau':\ E_i=(n-i)X_i+iX_{i-1},\ i=0..n;\quad
n\tbinom{n-1}iX_i=\sum_{j\le i}(-1)^{i-j}\tbinom njE_j)",
        .kind = Kind::equivalence,
        .hypotheses = {proper_rho},
        .mutants = {"(n-i) X_i - i X_{i-1}", "tau_i - sigma tau_{i+1} in X_i", "all signs plus in the sum"},
        .max_pieces = 1,
        .remark =
            "As scanned, (19) reads (n-i) X_i = i X_{i-1}; the right sign is (n-i) X_i = -i X_{i-1}. With either, "
            "(20), "
            "X_i = 0 for all i, follows: it is not one choice among others ('in particular') but equivalent to (19)."};
    return info;
  }

  template <class S, class P>
  struct In {
    std::vector<P> c;
    std::vector<P> tau;
    S rho;
    S sigma;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    std::vector<P> c = from.template points<P>(size.n + 1);
    std::vector<P> tau = from.template points<P>(size.n + 1);
    S rho = from.scalar();
    return {std::move(c), std::move(tau), std::move(rho), from.scalar()};
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return {{in.rho - from_int<S>(1)}};
  }
  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    return {{0, {fj07::example_points<S, P>(3), fj07::example_points<S, P>(3, 3), from_int<S>(1), from_int<S>(2)}}};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const int n = degree_of(in.c);
    const S over = in.rho - from_int<S>(1);
    const DirectrixEquation<S> equation = aumann_equation<S>(n, in.rho, in.sigma);
    const std::vector<Form<S>> rows = directrix_rows(n, equation);
    std::vector<P> e = directrix_right_sides<S, P>(in.c, comparison_degree(n, equation));
    for (std::size_t i = 0; i < e.size(); ++i) {
      subtract(e[i], applied(rows[i], in.tau));
      scale(e[i], over);
    }

    std::vector<P> x;
    for (std::size_t i = 0; i + 1 < in.c.size(); ++i) {
      const std::size_t next = mutant.is(2) ? i : i + 1;
      P right = combine(from_int<S>(1), in.tau[next], -in.sigma, in.tau[2 * i + 1 - next]);
      x.push_back(combine(over, difference(in.c[i + 1], in.c[i]), from_int<S>(-1), right));
    }
    for (int i = 0; i <= n; ++i) {
      const std::size_t at_i = static_cast<std::size_t>(i);
      P sides = PointTraits<P>::zero();
      if (i < n) add_scaled(sides, from_int<S>(n - i), x[at_i]);
      if (i > 0) add_scaled(sides, from_int<S>(mutant.is(1) ? -i : i), x[at_i - 1]);
      equations.equal(e[at_i], sides);
    }
    for (int i = 0; i < n; ++i) {
      P alternating = PointTraits<P>::zero();
      for (int j = 0; j <= i; ++j) {
        const S weight = binomial<S>(n, j);
        add_scaled(alternating, (i - j) % 2 == 0 || mutant.is(3) ? weight : -weight, e[static_cast<std::size_t>(j)]);
      }
      equations.equal(scaled(from_int<S>(n) * binomial<S>(n - 1, i), x[static_cast<std::size_t>(i)]), alternating);
    }
  }
};

/// ZW06.20: Aumann's surfaces.
struct Eq20 {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "ZW06.20",
        .source = "case 2.2 (4), equation (20)",
        .title = "Aumann's surfaces",
        .statement = R"(q_{i+1}=p_i+\rho(p_{i+1}-p_i)+\sigma(q_i-p_i)\Rightarrow a'=a\tau+b\tau',\
a=\frac{n(1-\sigma)}{\rho-1},\ b=\frac{1-u+\sigma u}{\rho-1},\ a_1'=\frac{(n+1)(1-\sigma)}{\rho-1}\tau;\quad
a\kappa+b\kappa'=0\text{ for }\kappa=(1-u+\sigma u)^n)",
        .kind = Kind::identity,
        .hypotheses = {proper_rho},
        .mutants = {"rho and sigma exchanged", "n + 1 in the place of n in a", "b = (u + sigma (1-u))/(rho-1)",
                    "n in the place of n + 1 in a1'"},
        .max_pieces = 1,
        .remark =
            "q_0 is free because a + n b' = 0: among constant a and linear b with b(0) not 0 these are all the "
            "equations that every directrix solves with a free vector. sigma = 1 is the cone (12). For rho = 1 the "
            "net is a cylinder."};
    return info;
  }

  template <class S, class P>
  struct In {
    RowInput<S, P> row;
    P d0;
    S rho;
    S sigma;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    RowInput<S, P> row = RowInput<S, P>::draw(from, size);
    P d0 = from.template point<P>();
    S rho = from.scalar();
    return {std::move(row), std::move(d0), std::move(rho), from.scalar()};
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return {{in.rho - from_int<S>(1)}};
  }
  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const std::vector<P> x = fj07::example_points<S, P>(4);
    return {{0, {{{x[0], x[1], x[2]}, from_int<S>(2)}, x[3], from_int<S>(1), from_int<S>(3)}}};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const S one = from_int<S>(1);
    const std::vector<P>& c = in.row.c;
    const S& u = in.row.u;
    const int n = degree_of(c);
    const std::vector<P> d =
        mutant.is(1) ? affine_net<S, P>(c, in.sigma, in.rho, in.d0) : affine_net<S, P>(c, in.rho, in.sigma, in.d0);
    const std::vector<P> tau = rulings_of(c, d);
    DirectrixEquation<S> equation = aumann_equation<S>(mutant.is(2) ? n + 1 : n, in.rho, in.sigma);
    if (mutant.is(3)) equation.b = Bernstein<S>({equation.b[1], equation.b[0]});
    require_equation(in.row, tau, equation, equations);
    const S speed = from_int<S>(mutant.is(4) ? n : n + 1) * (one - in.sigma) / (in.rho - one);
    equations.equal(derivative(directrix_edge<S, P>(c, tau, equation.b), u), scaled(speed, value(tau, u)));

    std::vector<S> powers{one};
    for (int i = 1; i <= n; ++i) powers.push_back(powers.back() * in.sigma);
    const Bernstein<S> kappa(powers);
    equations.zero(equation.a(u) * kappa(u) + equation.b(u) * kappa.derivative()(u));
  }
};

}  // namespace torse::proofs::zw06
