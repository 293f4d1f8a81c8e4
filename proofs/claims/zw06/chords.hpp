// ZW06, case 2.2 (3): the functions a = 1/u, b = 1, equation (18).
//   Eq18
#pragma once

#include <vector>

#include "torse/proofs/claims/zw06/tangents.hpp"

namespace torse::proofs::zw06 {

/// ZW06.18: a = 1/u, b = 1.
struct Eq18 : FreeDirectrix {
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "ZW06.18",
        .source = "case 2.2 (3), equation (18)",
        .title = "a = 1/u, b = 1: chords to the running mean",
        .statement = R"(q_0=p_0,\ q_i=p_i+\tfrac i{i+1}(p_i+q_{i-1}-2p_{i-1})\Rightarrow a'=\tfrac1u\tau+\tau',\
\tau_i=p_i-m_i,\ a_1=a-\tau=\sum_iB_i^nm_i;\ \tau(u)=u\,\tau_{(16)}(u))",
        .kind = Kind::identity,
        .hypotheses = {{"u is not 0: there a = 1/u has no value and the ruling has length zero", false}},
        .mutants = {"a = 1", "i/(i+2) in the place of i/(i+1)", "a1 = a + tau", "the rulings of (16) times 1 - u"},
        .max_pieces = 1,
        .remark =
            "The tangent surface of the running mean again, that of (16) with its rulings multiplied by u: (16) and "
            "(18) are one surface between different second rows. As u a' = tau + u tau' the equation holds for u = 0 "
            "too."};
    return info;
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return {{in.u}};
  }
  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    return {{0, {fj07::example_points<S, P>(3), from_int<S>(0)}}};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const S one = from_int<S>(1);
    const std::vector<P>& c = in.c;
    const int n = degree_of(c);
    std::vector<P> tau = rulings_of(c, mean_chord_net<S, P>(c));
    if (mutant.is(2)) {
      for (int i = 1; i <= n; ++i) scale(tau[static_cast<std::size_t>(i)], ratio<S>(i + 1, i + 2));
    }
    const S a = one / in.u;
    equations.equal(derivative(c, in.u), along(mutant.is(1) ? one : a, one, tau, in.u));

    std::vector<P> means;
    P total = PointTraits<P>::zero();
    for (int i = 0; i <= n; ++i) {
      add(total, c[static_cast<std::size_t>(i)]);
      means.push_back(scaled(ratio<S>(1, i + 1), total));
    }
    equations.equal(directrix_edge<S, P>(c, tau, Bernstein<S>({mutant.is(3) ? -one : one})), means);
    equations.equal(derivative(means, in.u), scaled(a, value(tau, in.u)));
    const Linear<S> factor = mutant.is(4) ? Linear<S>{one, -one} : Linear<S>{from_int<S>(0), one};
    equations.equal(times_linear(rulings_of(c, mean_tangent_net<S, P>(c)), factor), at_degree<S, P>(tau, n + 1));
  }
};

}  // namespace torse::proofs::zw06
