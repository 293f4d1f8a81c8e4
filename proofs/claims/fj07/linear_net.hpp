// FJ07, section 3: the linear construction (13) and its closed forms (14), (15), (16).
//   Eq13, Eq14, Eq15, Eq16
//   Eq13Rulings             (13) in rulings, which is what the library computes
#pragma once

#include <algorithm>
#include <vector>

#include "torse/developable/closed_forms.hpp"
#include "torse/proofs/claims/fj07/common.hpp"

namespace torse::proofs::fj07 {

/// FJ07.13: the net of the linear recursion obeys (13) and its surface is developable.
struct Eq13 : NetClaimAt {
  static constexpr PointKind points = PointKind::coplanar;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo value{
        .id = "FJ07.13",
        .source = "equation (13)",
        .title = "the linear construction",
        .statement = R"(For every $c$, $d_0$, $\Lambda^*$, $M^*$ there is one net with
$(u_{i+n}-\Lambda^*)c_i+(\Lambda^*-u_i)c_{i+1}=(u_{i+n}-M^*)d_i+(M^*-u_i)d_{i+1}$, $i=0..L-1$, and its surface is
developable.)",
        .kind = Kind::identity,
        .hypotheses = {off_before_last, off_from_last},
        .mutants = {"the last vertex reflected", "L* and M* exchanged", "u_{i+n} shifted in the last cell"},
        .remark =
            "L* = M* is a cylinder, d_0 = c_0 and L* at a knot are allowed. M* matters at all knots up to u_{L-1}, "
            "those outside the domain included."};
    return value;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, c, d0, lambda, m] = in.net;
    std::vector<P> d = linear_net<S, P>(u, c, lambda, m, d0);
    if (mutant.is(1)) d.back() = combine(from_int<S>(2), d.back(), from_int<S>(-1), d.front());
    if (mutant.is(2)) d = linear_net<S, P>(u, c, m, lambda, d0);
    if (mutant.is(3)) {
      std::vector<S> shifted = u.list();
      shifted.back() += from_int<S>(1);
      d = linear_net<S, P>(KnotList<S>(u.degree(), shifted), c, lambda, m, d0);
    }
    for (int i = 0; i < u.last(); ++i) {
      equations.equal(cell_point<S, P>(u, c, i, lambda), cell_point<S, P>(u, d, i, m));
    }
    require_coplanar<S, P>(u, c, d, in.t, equations);
  }
};

/// The closed forms are linear in the points.
struct ClosedForm : NetClaim {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 3;
};

/// FJ07.13.rulings: (13) in the rulings d_i - c_i, from any vertex.
struct Eq13Rulings : ClosedForm {
  static const ClaimInfo& info() {
    static const ClaimInfo value{
        .id = "FJ07.13.rulings",
        .source = "equation (13), rewritten",
        .title = "the linear construction ruling by ruling",
        .statement = R"(The net of (13) is that of
$(M^*-u_i)(d_{i+1}-c_{i+1})=(M^*-u_{i+n})(d_i-c_i)+(\Lambda^*-M^*)(c_{i+1}-c_i)$, $i=0..L-1$, from whichever of its
vertices it is computed.)",
        .kind = Kind::identity,
        .hypotheses = {off_before_last, off_from_last},
        .mutants = {"L* and M* exchanged", "the sign of L*-M*", "the neighbouring knot of the ratio"},
        .remark = "Its rounding errors do not depend on the place of the origin: docs/findings.md."};
    return value;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, c, d0, lambda, m] = in;
    const std::vector<P> d = printed_net<S, P>(u, c, lambda, m, 0, d0);
    std::vector<S> list = u.list();
    if (mutant.is(3)) list.back() += from_int<S>(1);
    const KnotList<S> v(u.degree(), list);
    const S gap_end = mutant.is(2) ? m + m - lambda : lambda;
    for (const int k : {0, u.last() / 2, u.last()}) {
      const std::vector<P> row = net_from<S, P>(v, c, mutant.is(1) ? m : gap_end, mutant.is(1) ? lambda : m, k,
                                                d[static_cast<std::size_t>(k)]);
      equations.equal(d, row);
    }
  }
};

/// FJ07.14: the closed form of d_N, against the recursion (13), for every vertex.
struct Eq14 : ClosedForm {
  static const ClaimInfo& info() {
    static const ClaimInfo value{
        .id = "FJ07.14",
        .source = "equation (14)",
        .title = "every vertex in closed form",
        .statement = R"($d_N=P(0,N)d_0+\frac{u_n-\Lambda^*}{M^*-u_0}P(1,N)c_0+\frac{\Lambda^*-u_{N-1}}{M^*-u_{N-1}}c_N
+\frac{M^*-\Lambda^*}{M^*-u_{N-1}}\sum_{i=1}^{N-1}\frac{u_{i+n}-u_{i-1}}{M^*-u_{i-1}}Q(i,N)c_i$ for $N=1..L$.)",
        .kind = Kind::identity,
        .hypotheses = {off_before_last, off_from_last},
        .mutants = {"L* and M* exchanged", "the sign of d_0", "the vertex before"}};
    return value;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, c, d0, lambda, m] = in;
    const std::vector<P> d = linear_net<S, P>(u, c, lambda, m, d0);
    for (int vertex = 1; vertex <= u.last(); ++vertex) {
      const P start = mutant.is(2) ? scaled(from_int<S>(-1), d0) : d0;
      const P closed = eq14<S, P>(u, c, mutant.is(1) ? m : lambda, mutant.is(1) ? lambda : m, start,
                                  mutant.is(3) && vertex > 1 ? vertex - 1 : vertex);
      equations.equal(d[static_cast<std::size_t>(vertex)], closed);
    }
  }
};

/// FJ07.15: d_N - c_N sorted by L*-M*, against the recursion (13), for every vertex.
struct Eq15 : ClosedForm {
  static const ClaimInfo& info() {
    static const ClaimInfo value{
        .id = "FJ07.15",
        .source = "equation (15)",
        .title = "every ruling, sorted by L*-M*",
        .statement = R"($d_N-c_N=P(0,N)(d_0-c_0)+\frac{\Lambda^*-M^*}{M^*-u_{N-1}}\{c_N
-\frac{M^*-u_{N-1}}{M^*-u_0}P(1,N)c_0-\sum_{i=1}^{N-1}\frac{u_{i+n}-u_{i-1}}{M^*-u_{i-1}}Q(i,N)c_i\}$, $N=1..L$.)",
        .kind = Kind::identity,
        .hypotheses = {off_before_last, off_from_last},
        .mutants = {"M*-L* in the place of L*-M*", "d_0 in the place of d_0-c_0", "c_N in the place of d_N-c_N"}};
    return value;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, c, d0, lambda, m] = in;
    const std::vector<P> d = linear_net<S, P>(u, c, lambda, m, d0);
    for (int vertex = 1; vertex <= u.last(); ++vertex) {
      const std::size_t at = static_cast<std::size_t>(vertex);
      const P closed =
          eq15<S, P>(u, c, mutant.is(1) ? m + m - lambda : lambda, m, mutant.is(2) ? sum(d0, c.front()) : d0, vertex);
      equations.equal(mutant.is(3) ? c[at] : difference(d[at], c[at]), closed);
    }
  }
};

/// FJ07.16: the closed form by differences of c, against the recursion (13), for every vertex.
struct Eq16 : ClosedForm {
  static const ClaimInfo& info() {
    static const ClaimInfo value{
        .id = "FJ07.16",
        .source = "equation (16)",
        .title = "every ruling by differences of the polygon",
        .statement = R"($d_N-c_N=P(0,N)(d_0-c_0)+(\Lambda^*-M^*)\sum_{i=0}^{N-1}P(i+1,N)\frac{c_{i+1}-c_i}{M^*-u_i}$ for
$N=1..L$.)",
        .kind = Kind::identity,
        .hypotheses = {off_before_last, off_from_last},
        .mutants = {"L* and M* exchanged", "the sign of the ruling", "the neighbouring vertex"}};
    return value;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, c, d0, lambda, m] = in;
    const std::vector<P> d = linear_net<S, P>(u, c, lambda, m, d0);
    std::vector<P> rulings = eq16_rulings<S, P>(u, c, mutant.is(1) ? m : lambda, mutant.is(1) ? lambda : m, d0);
    if (mutant.is(3)) std::rotate(rulings.begin(), rulings.end() - 1, rulings.end());
    for (std::size_t vertex = 1; vertex < d.size(); ++vertex) {
      P& ruling = rulings[vertex - 1];
      if (mutant.is(2)) scale(ruling, from_int<S>(-1));
      equations.equal(difference(d[vertex], c[vertex]), ruling);
    }
  }
};

}  // namespace torse::proofs::fj07
