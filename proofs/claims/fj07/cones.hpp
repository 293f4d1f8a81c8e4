// FJ07, section 2: cones, equations (5) and (6).
//   Eq5, Eq6
#pragma once

#include <utility>
#include <vector>

#include "torse/developable/special.hpp"
#include "torse/proofs/claims/fj07/common.hpp"

namespace torse::proofs::fj07 {

/// FJ07.5: curves a + k w and a + (k+1) w span a cone with vertex a.
struct Eq5 {
  static constexpr PointKind points = PointKind::coplanar;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo value{
        .id = "FJ07.5",
        .source = "equation (5)",
        .title = "cones",
        .statement =
            R"(For $c=a+kw$, $d=a+(k+1)w$: $b(t,v)=a+(v+k)w(t)$, every ruling passes through $a=b(t,-k)$, and the
surface is developable.)",
        .kind = Kind::identity,
        .hypotheses = {},
        .mutants = {"v - k", "vertex at v = k", "the first and the last w_i exchanged"}};
    return value;
  }

  template <class S, class P>
  struct In {
    KnotList<S> u;
    P vertex;
    S k;
    std::vector<P> w;
    std::vector<P> c;
    std::vector<P> d;
    S t;
    S v;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    KnotList<S> u(size.n, from.knots(size));
    P vertex = from.template point<P>();
    S k = from.scalar();
    std::vector<P> w = from.template points<P>(size.last() + 1);
    std::vector<P> c;
    std::vector<P> d;
    for (const P& x : w) {
      c.push_back(combine(from_int<S>(1), vertex, k, x));
      d.push_back(sum(c.back(), x));
    }
    S t = from.scalar();
    return {std::move(u), std::move(vertex), std::move(k), std::move(w),
            std::move(c), std::move(d),      std::move(t), from.scalar()};
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>&) {
    return {};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, vertex, k, w, c, d, t, v] = in;
    std::vector<P> rulings = w;
    if (mutant.is(3)) std::swap(rulings.front(), rulings.back());
    const std::vector<P> row = restrict_rulings<S, P>(c, d, v);
    const std::vector<P> at_vertex = restrict_rulings<S, P>(c, d, mutant.is(2) ? k : -k);
    for (int piece : u.proper_pieces()) {
      const P ruling = curve_point<S, P>(u, rulings, piece, t);
      equations.equal(curve_point<S, P>(u, row, piece, t),
                      combine(from_int<S>(1), vertex, mutant.is(1) ? v - k : v + k, ruling));
      equations.equal(curve_point<S, P>(u, at_vertex, piece, t), vertex);
    }
    require_coplanar<S, P>(u, c, d, t, equations);
  }
};

/// FJ07.6: proportional sides of the polygons give a cone.
struct Eq6 {
  static constexpr PointKind points = PointKind::coplanar;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo value{
        .id = "FJ07.6",
        .source = "equation (6)",
        .title = "cones by proportional sides",
        .statement = R"($d_i-d_{i-1}=\alpha(c_i-c_{i-1})$, $i=1..L$, with $\alpha=1+1/k$ gives
$d_i=a+\alpha(c_i-a)$, $c(t)=a+k\,w(t)$ and $d(t)=a+(k+1)w(t)$ for $w=d-c$ and the vertex
$a=(\alpha c_0-d_0)/(\alpha-1)$.)",
        .kind = Kind::identity,
        .hypotheses = {{"alpha is not 1: a translated row is a cylinder", true}},
        .mutants = {"2 alpha in the recursion", "vertex (alpha c_0 + d_0)/(alpha - 1)", "k = alpha - 1"}};
    return value;
  }

  template <class S, class P>
  struct In {
    KnotList<S> u;
    std::vector<P> c;
    P d0;
    S alpha;
    S t;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    KnotList<S> u(size.n, from.knots(size));
    std::vector<P> c = from.template points<P>(size.last() + 1);
    P d0 = from.template point<P>();
    S alpha = from.scalar();
    return {std::move(u), std::move(c), std::move(d0), std::move(alpha), from.scalar()};
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return {{in.alpha - from_int<S>(1)}};
  }
  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    NetInput<S, P> net = example_net<S, P>(5);
    return {{0, {net.u, net.c, net.d0, from_int<S>(1), from_int<S>(3)}}};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, c, d0, alpha, t] = in;
    const S one = from_int<S>(1);
    const std::vector<P> d = cone_net<S, P>(c, mutant.is(1) ? (one + one) * alpha : alpha, d0);
    const P vertex = cone_vertex<S, P>(c[0], mutant.is(2) ? scaled(-one, d0) : d0, alpha);
    for (std::size_t i = 0; i < c.size(); ++i) equations.equal(d[i], combine(one - alpha, vertex, alpha, c[i]));
    const S k = mutant.is(3) ? alpha - one : one / (alpha - one);
    for (int piece : u.proper_pieces()) {
      const P at_c = curve_point<S, P>(u, c, piece, t);
      const P at_d = curve_point<S, P>(u, d, piece, t);
      const P ruling = difference(at_d, at_c);
      equations.equal(at_c, combine(one, vertex, k, ruling));
      equations.equal(at_d, combine(one, vertex, k + one, ruling));
    }
    require_coplanar<S, P>(u, c, d, t, equations);
  }
};

}  // namespace torse::proofs::fj07
