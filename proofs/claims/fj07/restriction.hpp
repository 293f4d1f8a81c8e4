// FJ07, section 3: restriction along the rulings, the swap of roles, and singular points.
//   Eq17, Corollary3
#pragma once

#include <array>
#include <concepts>
#include <vector>

#include "torse/algebra/determinant.hpp"
#include "torse/developable/linear_net.hpp"
#include "torse/developable/special.hpp"
#include "torse/proofs/claims/fj07/common.hpp"

namespace torse::proofs::fj07 {

/// FJ07.17: M* stays and L*-M* scales under restriction; exchanging c and d exchanges L* and M*.
struct Eq17 {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo value{
        .id = "FJ07.17",
        .source = "equation (17)",
        .title = "restriction along the rulings and the swap of roles",
        .statement = R"($\tilde d_i=c_i+\beta(d_i-c_i)$ is the net of (13) with $\tilde M^*=M^*$,
$\tilde\Lambda^*=M^*+\beta(\Lambda^*-M^*)$; and $c$ is the net of (13) through $d$ with $M^*$, $\Lambda^*$ exchanged.)",
        .kind = Kind::identity,
        .hypotheses = {off_before_last, off_from_last, {"L* is none of the knots, for the swap", false}},
        .mutants = {"beta L*", "M* + beta (M* - L*)", "the swap without exchanging L*, M*"},
        .remark = "beta is free: 0 gives d~ = c with L~* = M*, values outside [0, 1] extend the rulings."};
    return value;
  }

  template <class S, class P>
  struct In {
    NetInput<S, P> net;
    S beta;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    NetInput<S, P> net = NetInput<S, P>::draw(from, size);
    return {std::move(net), from.scalar()};
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    const auto& net = in.net;
    return {before_last(net.u, net.m), from_last(net.u, net.m), off_knots(net.u, net.lambda)};
  }
  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    NetInput<S, P> swapped = example_net<S, P>(5);
    swapped.lambda = from_int<S>(1);
    return {{0, {example_net<S, P>(1), from_int<S>(4)}},
            {1, {example_net<S, P>(2), from_int<S>(4)}},
            {2, {std::move(swapped), from_int<S>(4)}}};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, c, d0, lambda, m] = in.net;
    const std::vector<P> d = linear_net<S, P>(u, c, lambda, m, d0);
    const std::vector<P> part = restrict_rulings<S, P>(c, d, in.beta);
    S part_lambda = restricted_lambda(lambda, m, in.beta);
    if (mutant.is(1)) part_lambda = in.beta * lambda;
    if (mutant.is(2)) part_lambda = m + m - part_lambda;
    const P start = combine(from_int<S>(1) - in.beta, c.front(), in.beta, d0);
    equations.equal(part, linear_net<S, P>(u, c, part_lambda, m, start));
    equations.equal(c, linear_net<S, P>(u, d, mutant.is(3) ? lambda : m, mutant.is(3) ? m : lambda, c.front()));
  }
};

/// FJ07.C3: where a developable net with L* and M* on one side of its domain is regular.
struct Corollary3 {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo value{
        .id = "FJ07.C3",
        .source = "Corollary 3",
        .title = "no singular points, corrected",
        .statement =
            R"(With $W=d-c$: $(M^*-t)\,b_t(t,v)=\{(1-v)(M^*-t)+v(\Lambda^*-t)\}\,c'(t)-nv\,W(t)$. If on every piece
$\Lambda_k,M_k<0$ or $\Lambda_k,M_k>1$, the brace over $M^*-t$ is positive for $0\le v\le1$; then
$b_t\times b_v=\frac{(1-v)(M^*-t)+v(\Lambda^*-t)}{M^*-t}\,c'\times W$, and a ruling has no singular point iff
$c'\times W\neq0$ on it.)",
        .kind = Kind::inequality,
        .hypotheses =
            {{"c'(t) x (d(t)-c(t)) is not 0: the curve is not stationary, the ruling has a length and does not "
              "touch the curve",
              false}},
        .mutants = {"v and 1-v exchanged", "n+1 in the place of n", "+n v W"},
        .remark =
            "As printed the corollary is false: c_0 = c_1 (c stationary), d_0 on the line c_0 c_1 (a ruling along "
            "the tangent) or d_0 = c_0 (a ruling of length zero) give singular points whatever the signs; each is "
            "stored as a failure. With c' x W != 0 the signs are sufficient, not necessary: only "
            "v = (t-M*)/(L*-M*), the edge of regression, must stay out of [0, 1]. Pieces adjoin, so L* and M* are "
            "on one side of the whole domain; outer knots do not touch the surface and are drawn on the inner side "
            "of M*."};
    return value;
  }

  /// L* and M* on one side of the domain.
  template <class S>
  struct Side {
    S lambda;
    S m;
  };

  template <class S, class P>
  struct In {
    KnotList<S> u;
    std::vector<P> c;
    P d0;
    std::array<Side<S>, 2> sides;
    std::vector<S> t;  ///< one in each proper piece
    S v;               ///< between 0 and 1
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    KnotList<S> u(size.n, from.knots(size));
    std::vector<P> c = from.template points<P>(size.last() + 1);
    P d0 = from.template point<P>();
    const auto fraction = [&] {
      const S x = from.positive();
      return x / (from_int<S>(1) + x);
    };
    Side<S> left{u.domain_begin() - from.positive(), u[0] - from.positive()};
    Side<S> right{u.domain_end() + from.positive(), u[u.size() - 1] + from.positive()};
    std::vector<S> t;
    for (int k : u.proper_pieces()) t.push_back(u.piece_begin(k) + fraction() * (u.piece_end(k) - u.piece_begin(k)));
    S v = fraction();
    return {std::move(u), std::move(c), std::move(d0), {std::move(left), std::move(right)}, std::move(t), std::move(v)};
  }

  /// Whether points have the coordinates and the order that `regular` speaks of.
  template <class S, class P>
  static constexpr bool in_space = OrderedField<S>&& std::same_as<P, Vec<S, 3>>;

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    std::vector<S> squares;
    if constexpr (in_space<S, P>) {
      for (const Side<S>& side : in.sides) {
        const std::vector<P> d = linear_net<S, P>(in.u, in.c, side.lambda, side.m, in.d0);
        std::size_t next = 0;
        for (int k : in.u.proper_pieces()) {
          const S& t = in.t[next++];
          const P ruling = difference(curve_point<S, P>(in.u, d, k, t), curve_point<S, P>(in.u, in.c, k, t));
          const P normal = cross<S>(curve_derivative<S, P>(in.u, in.c, k, t), ruling);
          squares.push_back(dot<S>(normal, normal));
        }
      }
    }
    return {std::move(squares)};
  }

  /// Singular points in spite of the signs: one quadratic piece on [0, 1], t = 0.
  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    std::vector<Failure<In<S, P>>> list;
    if constexpr (in_space<S, P>) {
      const auto point = [](int x, int y, int z) {
        P p;
        p[0] = from_int<S>(x);
        p[1] = from_int<S>(y);
        p[2] = from_int<S>(z);
        return p;
      };
      const auto with = [&](const P& c1, const P& d0) {
        const Side<S> left{from_int<S>(-2), from_int<S>(-1)};
        const Side<S> right{from_int<S>(3), from_int<S>(2)};
        list.push_back({0,
                        {bezier_knots<S>(2),
                         {point(0, 0, 0), c1, point(2, 1, 0)},
                         d0,
                         {left, right},
                         {from_int<S>(0)},
                         ratio<S>(1, 2)}});
      };
      with(point(0, 0, 0), point(0, 0, 1));
      with(point(1, 0, 0), point(1, 0, 0));
      with(point(1, 0, 0), point(0, 0, 0));
    }
    return list;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, c, d0, sides, at, v] = in;
    const S one = from_int<S>(1);
    const S n = from_int<S>(mutant.is(2) ? u.degree() + 1 : u.degree());
    for (const auto& [lambda, m] : sides) {
      const std::vector<P> d = linear_net<S, P>(u, c, lambda, m, d0);
      const std::vector<P> row = restrict_rulings<S, P>(c, d, v);
      std::size_t next = 0;
      for (int k : u.proper_pieces()) {
        const S& t = at[next++];
        const P along = curve_derivative<S, P>(u, row, k, t);
        const P ruling = difference(curve_point<S, P>(u, d, k, t), curve_point<S, P>(u, c, k, t));
        const S near = one - v;
        const S brace = mutant.is(1) ? v * (m - t) + near * (lambda - t) : near * (m - t) + v * (lambda - t);
        equations.equal(scaled(m - t, along),
                        combine(brace, curve_derivative<S, P>(u, c, k, t), mutant.is(3) ? n * v : -(n * v), ruling));
        equations.positive(brace / (m - t));
        if constexpr (in_space<S, P>) {
          const P normal = cross<S>(along, ruling);
          equations.positive(dot<S>(normal, normal));
        }
      }
    }
  }
};

}  // namespace torse::proofs::fj07
