// ZW06, the method in general: the linear system for the rulings.
//   G            its coefficients for any polynomials a, b
//   Unique       constant a, linear b: the determinant and the solution
#pragma once

#include <utility>
#include <vector>

#include "torse/proofs/claims/zw06/common.hpp"

namespace torse::proofs::zw06 {

/// ZW06.G: the equations that are solved are those of the Bernstein coefficients.
struct G {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "ZW06.G",
        .source = "section 3, the method",
        .title = "the linear system for the rulings",
        .statement = R"(\sum_jB_j^D(u)\bigl(\ell_j(\tau_0,\dots,\tau_n)-r_j\bigr)=a\tau+b\tau'-a',\
D=n+\max(\deg a,\deg b-1),\text{ for all }p_i,\tau_i,a,b,u)",
        .kind = Kind::identity,
        .hypotheses = {},
        .mutants = {"a and b exchanged", "the right sides one degree below", "b with the opposite sign"},
        .max_pieces = 6,
        .remark =
            "N stands for the degree of b, N - 1 is that of a. Bernstein polynomials of degree D are independent, so "
            "the equation holds for all u iff every l_j = r_j. The paper treats seven choices of a and b; in general "
            "there are D + 1 equations for n + 1 unknowns, and a directrix that solves them is the exception."};
    return info;
  }

  template <class S, class P>
  struct In {
    DirectrixEquation<S> equation;
    RowInput<S, P> row;
    std::vector<P> tau;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    Bernstein<S> a = draw_polynomial(from, size.pieces - 1);
    Bernstein<S> b = draw_polynomial(from, size.pieces);
    RowInput<S, P> row = RowInput<S, P>::draw(from, size);
    return {{std::move(a), std::move(b)}, std::move(row), from.template points<P>(size.n + 1)};
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>&) {
    return {};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const S& u = in.row.u;
    const int n = degree_of(in.tau);
    const int degree = comparison_degree(n, in.equation);
    DirectrixEquation<S> used = in.equation;
    if (mutant.is(1)) used = {in.equation.b, in.equation.a};
    if (mutant.is(3)) used.b = Bernstein<S>({from_int<S>(0)}) - used.b;
    const std::vector<Form<S>> rows = directrix_rows(n, used);
    const std::vector<P> right = directrix_right_sides<S, P>(in.row.c, mutant.is(2) ? degree - 1 : degree);
    std::vector<P> defects;
    for (std::size_t j = 0; j < rows.size(); ++j) {
      defects.push_back(applied(rows[j], in.tau));
      if (j < right.size()) subtract(defects.back(), right[j]);
    }
    equations.equal(fj21::bernstein_sum(defects, u),
                    difference(along(in.equation.a(u), in.equation.b(u), in.tau, u), derivative(in.row.c, u)));
  }
};

/// ZW06.G.unique: the square case.
struct Unique {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "ZW06.G.unique",
        .source = "section 3, the method for constant a and b of degree one",
        .title = "when the rulings are unique",
        .statement = R"(a\text{ constant},\ b=b_0+\beta u:\ \det(\ell_0,\dots,\ell_n)=\prod_{k=0}^n(a+k\beta);\
\tau=\sum_{k=0}^{n-1}t_ku^k,\ (a+k\beta)t_k=g_k-(k+1)b_0t_{k+1},\ a'=\sum g_ku^k)",
        .kind = Kind::identity,
        .hypotheses = {{"a + k b' is not 0 for k < n: else most directrices have no rulings", false},
                       {"a + n b' is not 0: else the rulings are a family", false}},
        .mutants = {"k from 1 to n + 1 in the product", "b_0 with the opposite sign", "a + (k+1) b'"},
        .max_pieces = 1,
        .remark =
            "(13), (16) and (17) are such equations, (12) and (20) the exceptions with a + n b' = 0. The unique tau "
            "has degree n - 1: the second row moves with the directrix and nothing is free. Where zero tests are "
            "decided the solver itself is asked too."};
    return info;
  }

  template <class S, class P>
  struct In {
    S a;
    S b0;
    S beta;
    RowInput<S, P> row;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    S a = from.scalar();
    S b0 = from.scalar();
    S beta = from.scalar();
    return {std::move(a), std::move(b0), std::move(beta), RowInput<S, P>::draw(from, size)};
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    std::vector<S> before;
    S factor = in.a;
    for (int k = 0; k < degree_of(in.row.c); ++k) {
      before.push_back(factor);
      factor += in.beta;
    }
    return {std::move(before), {std::move(factor)}};
  }
  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const auto input = [](int a, int u) {
      return In<S, P>{from_int<S>(a), from_int<S>(3), from_int<S>(1), {fj07::example_points<S, P>(3), from_int<S>(u)}};
    };
    // At u = -3 b vanishes, and the rulings of the family are one: what fails is that they are unique.
    return {{0, input(-1, 2)}, {1, input(-2, -3)}};
  }

  /// The determinant of a matrix that is tridiagonal, by the continuants of its leading minors.
  template <class S>
  static S tridiagonal_determinant(const std::vector<Form<S>>& rows) {
    S before = from_int<S>(1);
    S minor = rows[0].coefficient(0);
    for (std::size_t i = 1; i < rows.size(); ++i) {
      const int at_i = static_cast<int>(i);
      S next =
          rows[i].coefficient(at_i) * minor - rows[i].coefficient(at_i - 1) * rows[i - 1].coefficient(at_i) * before;
      before = std::move(minor);
      minor = std::move(next);
    }
    return minor;
  }

  /// t_0, ..., t_n: coefficients of powers of u by back substitution.
  template <class S, class P>
  static std::vector<P> powers(const In<S, P>& in, Mutant mutant) {
    const int n = degree_of(in.row.c);
    std::vector<P> t(static_cast<std::size_t>(n) + 1, PointTraits<P>::zero());
    std::vector<P> differences = in.row.c;  // differences[k]: the k-th forward difference at 0
    for (int k = 1; k <= n; ++k) {
      for (int i = n; i >= k; --i)
        subtract(differences[static_cast<std::size_t>(i)], differences[static_cast<std::size_t>(i - 1)]);
    }
    for (int k = n - 1; k >= 0; --k) {
      const std::size_t at_k = static_cast<std::size_t>(k);
      const S weight = from_int<S>(k + 1);
      P right = scaled(weight * binomial<S>(n, k + 1), differences[at_k + 1]);
      add_scaled(right, mutant.is(2) ? weight * in.b0 : -(weight * in.b0), t[at_k + 1]);
      divide(right, in.a + from_int<S>(mutant.is(3) ? k + 1 : k) * in.beta);
      t[at_k] = std::move(right);
    }
    return t;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const S& u = in.row.u;
    const int n = degree_of(in.row.c);
    const DirectrixEquation<S> equation{Bernstein<S>({in.a}), Bernstein<S>({in.b0, in.b0 + in.beta})};
    S product = from_int<S>(1);
    for (int k = 0; k <= n; ++k) product *= in.a + from_int<S>(mutant.is(1) ? k + 1 : k) * in.beta;
    equations.equal(tridiagonal_determinant(directrix_rows(n, equation)), product);

    const std::vector<P> t = powers(in, mutant);
    P tau = PointTraits<P>::zero();
    P turn = PointTraits<P>::zero();
    for (int k = n; k >= 0; --k) {
      const P& coefficient = t[static_cast<std::size_t>(k)];
      turn = combine(u, turn, from_int<S>(1), tau);
      tau = combine(u, tau, from_int<S>(1), coefficient);
    }
    equations.equal(combine(in.a, tau, in.b0 + in.beta * u, turn), derivative(in.row.c, u));

    if constexpr (ExactField<S>) {
      const DirectrixSolution<S, P> solution = solve_directrix<S, P>(in.row.c, equation);
      equations.zero(from_int<S>(solution.contradiction || solution.family ? 1 : 0));
      equations.equal(solution.contradiction ? PointTraits<P>::zero() : value(solution.tau, u), tau);
    }
  }
};

}  // namespace torse::proofs::zw06
