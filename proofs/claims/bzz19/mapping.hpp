// BZZ19, section 3.2: the mapping as a B-spline function, equations (3) to (5).
//   Eq3, Eq4, Eq5
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "torse/proofs/claims/bzz19/common.hpp"
#include "torse/quasi/mapping.hpp"
#include "torse/spline/basis.hpp"

namespace torse::proofs::bzz19 {

/// Knots, coefficients and a parameter.
template <class S, class P>
struct MappingInput {
  KnotList<S> u;
  std::vector<P> beta;
  S t;

  static MappingInput draw(Source<S>& from, Size size);
};

template <class S, class P>
MappingInput<S, P> MappingInput<S, P>::draw(Source<S>& from, Size size) {
  KnotList<S> u(size.n, from.knots(size));
  std::vector<P> beta = from.template points<P>(size.last() + 1);
  return {std::move(u), std::move(beta), from.scalar()};
}

/// BZZ19.3: sigma by its basis functions, and T = t.
struct Eq3 : Takes<MappingInput> {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 1;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "BZZ19.3",
        .source = "equation (3)",
        .title = "the mapping as a B-spline function, T = t",
        .statement = R"(\sigma(t)=\sum_i\beta_iB_{i,d}(t);\quad
\beta_i=\tfrac1d(u_i+\dots+u_{i+d-1})\Rightarrow\sigma(t)=t)",
        .kind = Kind::identity,
        .hypotheses = {},
        .mutants = {"beta_{i+1} in the place of beta_i", "d + 1 in the place of d in the Greville abscissae",
                    "the Greville abscissae shifted by one"},
        .remark =
            "The paper starts with T = t and says that a number of its values are the coefficients: values at the "
            "Greville abscissae are, others give T = t for d = 1 only. Its clamped knots are printed with one end "
            "knot too many, t_0 = ... = t_{d+1}."};
    return info;
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>&) {
    return {};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, beta, t] = in;
    const int d = u.degree();
    std::vector<S> greville = coefficients(identity_mapping(u));
    if (mutant.is(2)) {
      for (S& x : greville) x = x * from_int<S>(d) / from_int<S>(d + 1);
    }
    if (mutant.is(3)) std::rotate(greville.begin(), greville.begin() + 1, greville.end());
    const Mapping<S> identity = mapping_of(u, greville);
    for (int k : u.proper_pieces()) {
      const S& a = u.piece_begin(k);
      const S& b = u.piece_end(k);
      const std::vector<BinaryForm<S>> basis = basis_forms(u, k);
      P total = PointTraits<P>::zero();
      for (int i = 0; i <= d; ++i) {
        const std::size_t j = static_cast<std::size_t>(mutant.is(1) ? std::min(k + i, u.last()) : k - 1 + i);
        add_scaled(total, basis[static_cast<std::size_t>(i)]((b - t) / (b - a), (t - a) / (b - a)), beta[j]);
      }
      equations.equal(curve_point<S, P>(u, beta, k, t), total);
      equations.equal(curve_point<S, Vec<S, 1>>(u, identity.points(), k, t)[0], t);
    }
  }
};

/// BZZ19.4: sigma' as a B-spline of degree d - 1.
struct Eq4 : Takes<MappingInput> {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 1;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "BZZ19.4",
        .source = "equation (4)",
        .title = "the derivative of the mapping",
        .statement = R"(\sigma'(t)=d\sum_{i=1}^n\frac{\beta_i-\beta_{i-1}}{t_{i+d}-t_i}B_{i,d-1}(t))",
        .kind = Kind::identity,
        .hypotheses = {},
        .mutants = {"without the factor d", "beta_{i+1} - beta_i", "t_{i+d+1} - t_i in the denominator"},
        .remark =
            "The paper's sum starts at i = 0, where t_d = t_0 and beta_{-1} is not defined: the term is to be left "
            "out. No knot is more than d-fold inside, so the other denominators are positive."};
    return info;
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>&) {
    return {};
  }

  /// The terms of piece k with t_{i+d+1} in the place of t_{i+d}, which is the next knot or one beyond the list.
  template <class S, class P>
  static P wide_sum(const MappingInput<S, P>& in, int k) {
    const auto& [u, beta, t] = in;
    const std::vector<S> basis = lower_basis(u, k, t);
    P total = PointTraits<P>::zero();
    for (int i = k; i < k + u.degree(); ++i) {
      const std::size_t at_i = static_cast<std::size_t>(i);
      const int next = i + u.degree();
      const S end = next < u.size() ? u[next] : u[u.size() - 1] + from_int<S>(1);
      const S factor = from_int<S>(u.degree()) * basis[static_cast<std::size_t>(i - k)] / (end - u[i - 1]);
      add_scaled(total, factor, difference(beta[at_i], beta[at_i - 1]));
    }
    return total;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, beta, t] = in;
    std::vector<P> shifted = beta;
    if (mutant.is(2)) std::rotate(shifted.begin(), shifted.begin() + 1, shifted.end());
    for (int k : u.proper_pieces()) {
      P slope = mutant.is(3) ? wide_sum(in, k) : derivative_sum<S, P>(u, shifted, k, t);
      if (mutant.is(1)) divide(slope, from_int<S>(u.degree()));
      equations.equal(curve_derivative<S, P>(u, beta, k, t), slope);
    }
  }
};

/// BZZ19.5: coefficients that are sums of squares make an increasing mapping.
struct Eq5 {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 1;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "BZZ19.5",
        .source = "equation (5)",
        .title = "sums of squares make an increasing mapping",
        .statement = R"(\beta_i=\sum_{j\le i}\varepsilon_j^2\Rightarrow
\sigma'(t)=d\sum_{i\ge1}\frac{\varepsilon_i^2}{t_{i+d}-t_i}B_{i,d-1}(t)>0,\ \sigma(t)>0
\text{ inside every piece})",
        .kind = Kind::inequality,
        .hypotheses = {{"eps_1, ..., eps_L are not 0: where d of them in a row are, sigma is constant on a piece",
                        false}},
        .mutants = {"eps_j in the place of eps_j^2", "beta_i = eps_i^2", "the sum over j < i"},
        .remark =
            "With zeros among the eps sigma still does not decrease. For d <= 2 every mapping that does not "
            "decrease and is not negative has such coefficients; for d >= 3 some have not: beta = 0, 5, 4, 9 "
            "increases over one cubic piece."};
    return info;
  }

  template <class S, class P>
  struct In {
    KnotList<S> u;
    std::vector<S> eps;
    S x;  ///< (y a + x b) / (x + y) lies inside the piece [a, b] for positive x, y
    S y;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    KnotList<S> u(size.n, from.knots(size));
    std::vector<S> eps;
    for (int i = 0; i <= size.last(); ++i) eps.push_back(from.scalar());
    S x = from.positive();
    return {std::move(u), std::move(eps), std::move(x), from.positive()};
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return {std::vector<S>(in.eps.begin() + 1, in.eps.end())};
  }
  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const S one = from_int<S>(1);
    const S zero = from_int<S>(0);
    return {{0, {fj07::example_knots<S>(2, {0, 1, 2, 3}), {one, zero, zero}, one, one}}};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, eps, x, y] = in;
    std::vector<S> beta = coefficients_from_steps<S>(eps);
    if (mutant.is(1)) {
      beta = eps;
      for (std::size_t i = 1; i < beta.size(); ++i) beta[i] += beta[i - 1];
    }
    if (mutant.is(2)) {
      for (std::size_t i = 0; i < beta.size(); ++i) beta[i] = eps[i] * eps[i];
    }
    if (mutant.is(3)) {
      std::rotate(beta.rbegin(), beta.rbegin() + 1, beta.rend());
      beta.front() = from_int<S>(0);
    }
    const Mapping<S> sigma = mapping_of(u, beta);
    for (int k : u.proper_pieces()) {
      const std::vector<S> basis = lower_basis(u, k, x);
      S slope = from_int<S>(0);
      for (int i = k; i < k + u.degree(); ++i) {
        const S& step = eps[static_cast<std::size_t>(i)];
        slope += step * step * basis[static_cast<std::size_t>(i - k)] / (u[i + u.degree() - 1] - u[i - 1]);
      }
      slope *= from_int<S>(u.degree());
      equations.equal(curve_derivative<S, Vec<S, 1>>(u, sigma.points(), k, x)[0], slope);  // at any parameter
      const S inside = (y * u.piece_begin(k) + x * u.piece_end(k)) / (x + y);
      equations.positive(curve_derivative<S, Vec<S, 1>>(u, sigma.points(), k, inside)[0]);
      equations.positive(curve_point<S, Vec<S, 1>>(u, sigma.points(), k, inside)[0]);
    }
  }
};

}  // namespace torse::proofs::bzz19
