// FJ07, section 2: cylinders and the tangent net, equations (4) and (7).
//   Eq4, Eq7
#pragma once

#include <vector>

#include "torse/developable/pieces.hpp"
#include "torse/developable/special.hpp"
#include "torse/proofs/claims/fj07/common.hpp"
#include "torse/spline/basis.hpp"

namespace torse::proofs::fj07 {

/// FJ07.4: vectors d_i - c_i parallel to v give a cylinder.
struct Eq4 {
  static constexpr PointKind points = PointKind::coplanar;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo value{
        .id = "FJ07.4",
        .source = "equation (4)",
        .title = "cylinders",
        .statement =
            R"($d_i-c_i=h_i v$ for all $i$ implies $d(t)-c(t)=\lambda(t)v$ with $\lambda=\sum_i h_iN_i$, and the
surface is developable.)",
        .kind = Kind::identity,
        .hypotheses = {},
        .mutants = {"the last ruling along another direction", "lengths shifted by one", "d_i = c_i - h_i v"},
        .remark =
            "The paper infers a constant direction from w' parallel to w. For splines that needs a ruling that does "
            "not vanish: w = max(t,0)^n v + max(-t,0)^n v' is C^{n-1} and turns from v' to v at t = 0."};
    return value;
  }

  template <class S, class P>
  struct In {
    KnotList<S> u;
    std::vector<P> c;
    P v;
    std::vector<S> lengths;
    S t;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    KnotList<S> u(size.n, from.knots(size));
    std::vector<P> c = from.template points<P>(size.last() + 1);
    P v = from.template point<P>();
    std::vector<S> lengths;
    for (int i = 0; i <= size.last(); ++i) lengths.push_back(from.scalar());
    return {std::move(u), std::move(c), std::move(v), std::move(lengths), from.scalar()};
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>&) {
    return {};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, c, v, lengths, t] = in;
    std::vector<P> d = cylinder_net<S, P>(c, v, lengths);
    if (mutant.is(1)) add(d.back(), c.front());
    const std::size_t shift = mutant.is(2) ? 1 : 0;
    for (int k : u.proper_pieces()) {
      const S s = local_parameter(u, t, k);
      const S rest = from_int<S>(1) - s;
      S length = from_int<S>(0);
      std::size_t i = static_cast<std::size_t>(k) - 1 + shift;
      for (const BinaryForm<S>& basis : basis_forms(u, k)) add_product(length, basis(rest, s), lengths[i++ % c.size()]);
      equations.equal(difference(curve_point<S, P>(u, d, k, t), curve_point<S, P>(u, c, k, t)),
                      scaled(mutant.is(3) ? -length : length, v));
    }
    require_coplanar<S, P>(u, c, d, t, equations);
  }
};

/// FJ07.7: the control net of c + c', one Bezier piece on [0, 1].
struct Eq7 {
  static constexpr PointKind points = PointKind::coplanar;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo value{
        .id = "FJ07.7",
        .source = "equation (7) and the net after it",
        .title = "the tangent net",
        .statement = R"(On $[0,1]$, $d_i=c_i+\{(n-i)c_{i+1}+(2i-n)c_i-ic_{i-1}\}$ gives $d(t)=c(t)+c'(t)$, a developable
surface whose edge of regression is $c$.)",
        .kind = Kind::identity,
        .hypotheses = {},
        .mutants = {"c - c'", "n(c_{i+1}-c_i) without raising the degree", "+i c_{i-1}"},
        .max_pieces = 1,
        .remark = "The case lambda = 1. On [a, b] the net gives c + (b-a) c'."};
    return value;
  }

  template <class S, class P>
  struct In {
    std::vector<P> c;
    S t;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    std::vector<P> c = from.template points<P>(size.n + 1);
    return {std::move(c), from.scalar()};
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>&) {
    return {};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [c, t] = in;
    const int n = static_cast<int>(c.size()) - 1;
    const KnotList<S> u = bezier_knots<S>(n);
    std::vector<P> d = tangent_net<S, P>(c);
    for (std::size_t i = 0; i < c.size(); ++i) {
      if (mutant.is(1)) d[i] = combine(from_int<S>(2), c[i], from_int<S>(-1), d[i]);
      if (mutant.is(2)) d[i] = combine(from_int<S>(1 - n), c[i], from_int<S>(n), c[i + 1 < c.size() ? i + 1 : i]);
      if (mutant.is(3) && i > 0) add_scaled(d[i], from_int<S>(2 * static_cast<int>(i)), c[i - 1]);
    }
    equations.equal(curve_point<S, P>(u, d, 1, t),
                    sum(curve_point<S, P>(u, c, 1, t), curve_derivative<S, P>(u, c, 1, t)));
    require_coplanar<S, P>(u, c, d, t, equations);
  }
};

}  // namespace torse::proofs::fj07
