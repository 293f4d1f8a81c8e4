// FJ07, section 3: the linear construction (13) and its closed forms (14), (15), (16).
#pragma once

#include <vector>

#include "torse/algebra/dependence.hpp"
#include "torse/developable/closed_forms.hpp"
#include "torse/proofs/inputs.hpp"

namespace torse::proofs::fj07 {

/// FJ07.13 with Corollary 2: the net of the linear recursion obeys (13) and its surface is developable.
struct Eq13 {
  static constexpr PointKind points = PointKind::coplanar;
  static constexpr int dimension = 3;
  static const ClaimInfo& info();

  template <class S, class P>
  struct In {
    NetInput<S, P> net;
    S t;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    NetInput<S, P> net = draw_net<S, P>(from, size);
    return {std::move(net), from.scalar()};
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return {off_knots(in.net.u, in.net.m)};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, c, d0, lambda, m] = in.net;
    std::vector<P> d = linear_net<S, P>(u, c, lambda, m, d0);
    if (mutant.is(1)) d.back() = combine(from_int<S>(2), d.back(), from_int<S>(-1), d.front());
    if (mutant.is(2)) d = linear_net<S, P>(u, c, m, lambda, d0);
    if (mutant.is(3)) {  // (13) with u_{i+n-1} in the place of u_{i+n}
      std::vector<S> shifted = u.list();
      shifted.back() += from_int<S>(1);
      d = linear_net<S, P>(KnotList<S>(u.degree(), shifted), c, lambda, m, d0);
    }
    for (int i = 0; i < u.last(); ++i) {
      equations.equal(cell_point<S, P>(u, c, i, lambda), cell_point<S, P>(u, d, i, m));
    }
    for (int k : u.proper_pieces()) {
      const auto [c0, c1] = last_pair<S, P>(u, c, k, in.t);
      const auto [e0, e1] = last_pair<S, P>(u, d, k, in.t);
      equations.zero(dependence_residual(std::array<P, 4>{c0, c1, e0, e1}));
    }
  }
};

/// FJ07.16: the closed form by differences of c, against the recursion (13), for every vertex.
struct Eq16 {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 3;
  static const ClaimInfo& info();

  template <class S, class P>
  using In = NetInput<S, P>;

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    return draw_net<S, P>(from, size);
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return {off_knots(in.u, in.m)};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, c, d0, lambda, m] = in;
    const std::vector<P> d = linear_net<S, P>(u, c, lambda, m, d0);
    for (int vertex = 1; vertex <= u.last(); ++vertex) {
      P ruling = eq16<S, P>(u, c, mutant.is(1) ? m : lambda, mutant.is(1) ? lambda : m, d0, vertex);
      if (mutant.is(2)) scale(ruling, from_int<S>(-1));
      if (mutant.is(3)) ruling = eq16<S, P>(u, c, lambda, m, d0, vertex - 1 > 0 ? vertex - 1 : vertex + 1);
      equations.equal(difference(d[static_cast<std::size_t>(vertex)], c[static_cast<std::size_t>(vertex)]), ruling);
    }
  }
};

}  // namespace torse::proofs::fj07
