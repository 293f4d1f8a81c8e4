// FJ07, section 3: the blossoms of a developable spline, equation (9) and Theorem 1.
//   Eq9, Theorem1
#pragma once

#include <utility>
#include <vector>

#include "torse/developable/linear_net.hpp"
#include "torse/developable/pieces.hpp"
#include "torse/proofs/claims/fj07/common.hpp"

namespace torse::proofs::fj07 {

/// FJ07.9: the tangents at c(t) and d(t) meet where c[t^<n-1>, L*] = d[t^<n-1>, M*].
struct Eq9 : NetClaimAt {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo value{
        .id = "FJ07.9",
        .source = "equation (9)",
        .title = "tangents along a ruling meet",
        .statement = R"(On every piece $c[t^{\langle n-1\rangle},\Lambda^*]=d[t^{\langle n-1\rangle},M^*]$, that is
$c+\frac{\Lambda^*-t}{n}c'=d+\frac{M^*-t}{n}d'$, that is $(1-\Lambda)c_0^{n-1}+\Lambda c_1^{n-1}=(1-M)d_0^{n-1}+Md_1^{n-1}$
and $d_1^{n-1}=(1-\lambda-\mu)c_0^{n-1}+\lambda c_1^{n-1}+\mu d_0^{n-1}$, $\lambda=\Lambda/M$, $\mu=1-1/M$.)",
        .kind = Kind::identity,
        .hypotheses = {off_before_last, off_from_last},
        .mutants = {"L* and M* exchanged", "derivatives without 1/n", "lambda and mu exchanged"},
        .remark = "Cones have no such L*, M*: their tangents along a ruling are parallel. The paper says so."};
    return value;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, c, d0, lambda, m] = in.net;
    const S& t = in.t;
    const S one = from_int<S>(1);
    const S n = from_int<S>(mutant.is(2) ? u.degree() + 1 : u.degree());
    const std::vector<P> d = linear_net<S, P>(u, c, lambda, m, d0);
    for (int k : u.proper_pieces()) {
      const P on_c = tangent_point<S, P>(u, c, k, t, at(mutant.is(1) ? m : lambda));
      const P on_d = tangent_point<S, P>(u, d, k, t, at(mutant.is(1) ? lambda : m));
      equations.equal(on_c, on_d);
      equations.equal(
          on_c, combine(one, curve_point<S, P>(u, c, k, t), (lambda - t) / n, curve_derivative<S, P>(u, c, k, t)));
      equations.equal(on_d,
                      combine(one, curve_point<S, P>(u, d, k, t), (m - t) / n, curve_derivative<S, P>(u, d, k, t)));
      const auto [c0, c1] = last_pair<S, P>(u, c, k, t);
      const auto [e0, e1] = last_pair<S, P>(u, d, k, t);
      const S lambda_k = local_parameter(u, lambda, k);
      const S m_k = local_parameter(u, m, k);
      equations.equal(combine(one - lambda_k, c0, lambda_k, c1), combine(one - m_k, e0, m_k, e1));
      AffineCell<S> cell = affine_from_local(lambda_k, m_k);
      if (mutant.is(3)) std::swap(cell.lam, cell.mu);
      P vertex = combine(one - cell.lam - cell.mu, c0, cell.lam, c1);
      add_scaled(vertex, cell.mu, e0);
      equations.equal(e1, vertex);
    }
  }
};

/// The two boundaries r[., M*] and r[., L*] on the tangents of a spline r of degree n+1: they obey the relation of
/// Theorem 1 whatever L* and M* are, knots included.
template <class S, class P>
struct EdgeInput {
  KnotList<S> u;
  std::vector<P> c;
  std::vector<P> d;
  S lambda;
  S m;
  std::vector<S> v;  ///< v_1..v_{n-1}
  S t;
};

/// FJ07.T1: curves whose blossoms are related span a developable surface.
struct Theorem1 {
  static constexpr PointKind points = PointKind::coplanar;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo value{
        .id = "FJ07.T1",
        .source = "Theorem 1",
        .title = "developable splines by blossoms",
        .statement = R"(If $c[v_1,\dots,v_{n-1},\Lambda^*]=d[v_1,\dots,v_{n-1},M^*]$ for all $v_i$ on every piece, the
surface is developable; the relation holds for $c=r[\cdot,M^*]$, $d=r[\cdot,\Lambda^*]$ with any spline $r$ of degree
$n+1$ over the same knots.)",
        .kind = Kind::identity,
        .hypotheses = {},
        .mutants = {"L* and M* exchanged", "t in the place of L*", "one control point of c taken at L*"},
        .remark =
            "No hypothesis is needed: L* and M* may lie at or between knots. For L* != M* all pairs come from such an "
            "r, the edge of regression: c_i, d_i are points of the line r_{i-1} r_i, and (13) says that neighbouring "
            "lines agree on r_i. The theorem is no converse: cones, general plane nets and degree-elevated nets are "
            "developable without such constants."};
    return value;
  }

  template <class S, class P>
  using In = EdgeInput<S, P>;

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    std::vector<S> inner = from.knots(size);
    KnotList<S> u(size.n, inner);
    std::vector<S> wide{inner.front() - from.positive()};  // r has one knot more at either end
    wide.insert(wide.end(), inner.begin(), inner.end());
    wide.push_back(inner.back() + from.positive());
    const std::vector<P> r = from.template points<P>(size.last() + 2);
    S lambda = from.scalar();
    S m = from.scalar();
    const auto boundary = [&](const S& x) {
      std::vector<P> row;
      for (std::size_t i = 0; i + 1 < r.size(); ++i) {
        row.push_back(blossom_step(wide[i], wide[i + static_cast<std::size_t>(size.n) + 1], at(x), r[i], r[i + 1]));
      }
      return row;
    };
    std::vector<P> c = boundary(m);
    std::vector<P> d = boundary(lambda);
    std::vector<S> v;
    for (int i = 1; i < size.n; ++i) v.push_back(from.scalar());
    return {std::move(u), std::move(c), std::move(d), std::move(lambda), std::move(m), std::move(v), from.scalar()};
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>&) {
    return {};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, c, d, lambda, m, v, t] = in;
    std::vector<P> changed = c;
    if (mutant.is(3)) changed.back() = d.back();
    std::vector<Parameter<S>> on_c;
    for (const S& x : v) on_c.push_back(at(x));
    std::vector<Parameter<S>> on_d = on_c;
    on_c.push_back(at(mutant.is(1) ? m : mutant.is(2) ? t : lambda));
    on_d.push_back(at(mutant.is(1) ? lambda : m));
    for (int k : u.proper_pieces()) {
      equations.equal(blossom<S, P>(u, changed, k, on_c), blossom<S, P>(u, d, k, on_d));
    }
    require_coplanar<S, P>(u, changed, d, t, equations);
  }
};

}  // namespace torse::proofs::fj07
