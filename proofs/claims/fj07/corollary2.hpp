// FJ07, section 3: the blossoms' relation and the equations of the net, Corollary 2.
//   Corollary2
#pragma once

#include <algorithm>
#include <vector>

#include "torse/developable/closed_forms.hpp"
#include "torse/proofs/claims/fj07/common.hpp"

namespace torse::proofs::fj07 {

/// FJ07.C2: the relation of Theorem 1 on all pieces and the equations (13) of the net are equivalent.
struct Corollary2 {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo value{
        .id = "FJ07.C2",
        .source = "Corollary 2",
        .title = "the net's equations and the blossoms' relation are equivalent",
        .statement = R"(For any $c,d,\Lambda^*,M^*$ put $g_i$ = left minus right side of (13). On every piece
$c[v_1,\dots,v_{n-1},\Lambda^*]-d[v_1,\dots,v_{n-1},M^*]$ is the blossom of degree $n-1$ with control points $g_i$ over
the same knots, so it vanishes on piece $k$ iff $g_{k-1}=\dots=g_{k+n-2}=0$. For $\Lambda^*=M^*$ the net of (13) is a
cylinder, $d_i-c_i=P(0,i)(d_0-c_0)$.)",
        .kind = Kind::equivalence,
        .hypotheses = {{"the first piece is not empty, else c_0 and d_0 do not touch the surface", false},
                       {"the last piece is not empty, else c_L and d_L do not touch the surface", false},
                       off_before_last,
                       off_from_last},
        .mutants = {"L* and M* exchanged", "g_{i+1} in the place of g_i", "L*+1 in the place of L* in (13)"},
        .remark =
            "The hypotheses on pieces serve the direction from blossoms to (13) only, those on M* the cylinder only. "
            "For cones the paper prints L* as the ratio of the sides; the ratio is alpha of (6)."};
    return value;
  }

  template <class S, class P>
  struct In {
    KnotList<S> u;
    std::vector<P> c;
    std::vector<P> d;
    S lambda;
    S m;
    std::vector<S> v;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    KnotList<S> u(size.n, from.knots(size));
    std::vector<P> c = from.template points<P>(size.last() + 1);
    std::vector<P> d = from.template points<P>(size.last() + 1);
    S lambda = from.scalar();
    S m = from.scalar();
    std::vector<S> v;
    for (int i = 1; i < size.n; ++i) v.push_back(from.scalar());
    return {std::move(u), std::move(c), std::move(d), std::move(lambda), std::move(m), std::move(v)};
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    const std::vector<S> lengths = proper(in.u);
    return {{lengths.front()}, {lengths.back()}, before_last(in.u, in.m), from_last(in.u, in.m)};
  }
  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const auto with = [](KnotList<S> u, std::int64_t m) {
      const int count = u.last() + 1;
      return In<S, P>{std::move(u),
                      example_points<S, P>(count),
                      example_points<S, P>(count, count),
                      from_int<S>(7),
                      from_int<S>(m),
                      {from_int<S>(4)}};
    };
    return {{0, with(example_knots<S>(2, {0, 1, 1, 2, 3}), 5)},
            {1, with(example_knots<S>(2, {0, 1, 2, 2, 3}), 5)},
            {2, with(example_knots<S>(2, {0, 1, 2, 3}), 1)},
            {3, with(example_knots<S>(2, {0, 1, 2, 3}), 2)}};
  }

  /// The blossom of degree n-1 with control points g on piece k, whose knots are u_k..u_{k+2n-3}.
  template <class S, class P>
  static P lower_blossom(const KnotList<S>& u, const std::vector<P>& g, int k, const std::vector<Parameter<S>>& v) {
    const int n = u.degree();
    const std::vector<P> local(g.begin() + (k - 1), g.begin() + (k - 1 + n));
    if (n == 1) return local.front();
    const std::vector<S> knots(u.list().begin() + k, u.list().begin() + (k + 2 * n - 2));
    return blossom<S, P>(KnotList<S>(n - 1, knots), local, 1, v);
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, c, d, lambda, m, v] = in;
    const int n = u.degree();
    std::vector<P> g;
    for (int i = 0; i < u.last(); ++i) {
      const std::size_t at_i = static_cast<std::size_t>(i);
      const S& end = u[i + n];
      const S x = mutant.is(3) ? lambda + from_int<S>(1) : lambda;
      P defect = combine(end - x, c[at_i], x - u[i], c[at_i + 1]);
      add_scaled(defect, m - end, d[at_i]);
      add_scaled(defect, u[i] - m, d[at_i + 1]);
      divide(defect, u[i + n] - u[i]);
      g.push_back(std::move(defect));
    }
    if (mutant.is(2)) std::rotate(g.begin(), g.begin() + 1, g.end());
    const auto relation = [&in, mutant](int k, std::vector<Parameter<S>> arguments) {
      arguments.push_back(at(mutant.is(1) ? in.m : in.lambda));
      const P on_c = blossom<S, P>(in.u, in.c, k, arguments);
      arguments.back() = at(mutant.is(1) ? in.lambda : in.m);
      return difference(on_c, blossom<S, P>(in.u, in.d, k, arguments));
    };
    std::vector<bool> seen(g.size(), false);
    for (int k : u.proper_pieces()) {
      std::vector<Parameter<S>> arguments;
      for (const S& x : v) arguments.push_back(at(x));
      equations.equal(relation(k, arguments), lower_blossom(u, g, k, arguments));
      for (int i = k - 1; i <= k + n - 2; ++i) {  // the relation at u_{i+1}..u_{i+n-1} is g_i
        std::vector<Parameter<S>> knots;
        for (int j = i + 1; j <= i + n - 1; ++j) knots.push_back(at(u[j]));
        equations.equal(relation(k, knots), g[static_cast<std::size_t>(i)]);
        seen[static_cast<std::size_t>(i)] = true;
      }
    }
    for (std::size_t i = 0; i < g.size(); ++i) {  // a g_i that no piece determines is free
      if (!seen[i]) equations.equal(g[i], PointTraits<P>::zero());
    }
    const std::vector<P> cylinder = linear_net<S, P>(u, c, m, m, d.front());
    for (int i = 0; i <= u.last(); ++i) {
      const std::size_t at_i = static_cast<std::size_t>(i);
      equations.equal(difference(cylinder[at_i], c[at_i]),
                      scaled(product_p(u, m, 0, i), difference(d.front(), c.front())));
    }
  }
};

}  // namespace torse::proofs::fj07
