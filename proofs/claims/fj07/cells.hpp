// FJ07: the cells of the control net as barycentric combinations, equations (8) and (18).
//   CellInput, CellLine      a first cell and what follows from it
//   Eq8, Eq18
#pragma once

#include <vector>

#include "torse/developable/cells.hpp"
#include "torse/proofs/claims/fj07/common.hpp"
#include "torse/spline/insertion.hpp"

namespace torse::proofs::fj07 {

/// A net by its first cell; m_1 = 1 is a cone.
template <class S, class P>
struct CellInput {
  KnotList<S> u;
  std::vector<P> c;
  P d0;
  Cell<S> first;
  S t;

  static CellInput draw(Source<S>& from, Size size);
};

/// F(x) = l_1 (u_n-u_0) + (1-m_1)(u_0-x) and E(x) = (u_n-u_0) + (1-m_1)(u_0-x): for m_1 != 1 they are (1-m_1)(L*-x) and
/// (1-m_1)(M*-x), for a cone both are constant. In place of L*-x, M*-x they hold for cones too.
template <class S, class P>
struct CellLine {
  const CellInput<S, P>& in;

  S f(const S& x) const { return in.first.l * span() + slope(x); }
  S e(const S& x) const { return span() + slope(x); }
  S span() const { return in.u[in.u.degree()] - in.u[0]; }

 private:
  S slope(const S& x) const { return (from_int<S>(1) - in.first.m) * (in.u[0] - x); }
};

inline constexpr Hypothesis cell_denominators{
    "no denominator of the recursion vanishes, which is u_n - u_j + m_1 (u_j - u_0) != 0 for j = 1..L-1 (M* is none of "
    "u_1, ..., u_{L-1})",
    false};

template <class S, class P>
CellInput<S, P> CellInput<S, P>::draw(Source<S>& from, Size size) {
  KnotList<S> u(size.n, from.knots(size));
  std::vector<P> c = from.template points<P>(size.last() + 1);
  P d0 = from.template point<P>();
  S l = from.scalar();
  S m = from.scalar();
  return {std::move(u), std::move(c), std::move(d0), {std::move(l), std::move(m)}, from.scalar()};
}

/// Hypothesis and failure of the claims on cells: M* = u_1, which is m_1 = -1 over the knots 0, 1, 2, 3.
struct CellClaim : Takes<CellInput> {
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    const int n = in.u.degree();
    std::vector<S> factors;
    for (int j = 1; j < in.u.last(); ++j) factors.push_back(in.u[n] - in.u[j] + in.first.m * (in.u[j] - in.u[0]));
    return {std::move(factors)};
  }
  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const NetInput<S, P> net = example_net<S, P>(5);
    return {{0, {net.u, net.c, net.d0, {from_int<S>(3), from_int<S>(-1)}, from_int<S>(4)}}};
  }
};

/// FJ07.8: the cells of a quadratic developable spline.
struct Eq8 : CellClaim {
  static constexpr PointKind points = PointKind::coplanar;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo value{
        .id = "FJ07.8",
        .source = "equation (8)",
        .title = "quadratic developable splines cell by cell",
        .statement = R"(For $n=2$ and cells $d_i=(1-l_i-m_i)c_{i-1}+l_ic_i+m_id_{i-1}$ with $(l_i,m_i)$ by (8) from any
$(l_1,m_1)$, each piece's Bezier net has cells with one barycentric combination, and the surface is developable.)",
        .kind = Kind::identity,
        .hypotheses = {cell_denominators},
        .mutants = {"u_{i-1}-u_{i-2} in the place of u_i-u_{i-2}", "l and m exchanged", "the sign of u_i - u_{i+1}"},
        .min_degree = 2,
        .max_degree = 2};
    return value;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, c, d0, first, t] = in;
    const std::vector<P> d = cell_net<S, P>(u, c, mutant.is(2) ? Cell<S>{first.m, first.l} : first, d0);
    S l = first.l;
    S m = first.m;
    for (int i = 1; i <= u.last(); ++i) {
      const std::size_t at_i = static_cast<std::size_t>(i);
      if (i > 1) {
        const S den = u[i] - u[i - 1] + m * (u[i - 1] - u[i - 2]);
        const S wide = mutant.is(1) ? u[i - 1] - u[i - 2] : u[i] - u[i - 2];
        const S last = mutant.is(3) ? u[i + 1] - u[i] : u[i] - u[i + 1];
        l = (m * (u[i - 1] - u[i - 2]) + l * wide - u[i - 1] + u[i - 2]) / den;
        m = (last + m * (u[i + 1] - u[i - 2])) / den;
      }
      P vertex = combine(from_int<S>(1) - l - m, c[at_i - 1], l, c[at_i]);
      add_scaled(vertex, m, d[at_i - 1]);
      equations.equal(d[at_i], vertex);
    }
    const CellLine<S, P> line{in};
    for (int k : u.proper_pieces()) {
      const std::vector<P> c_k = bezier_points<S, P>(u, c, k);
      const std::vector<P> d_k = bezier_points<S, P>(u, d, k);
      const S& a = u.piece_begin(k);
      const S& b = u.piece_end(k);
      for (std::size_t i = 0; i < 2; ++i) {
        equations.equal(combine(line.e(a), d_k[i + 1], -line.e(b), d_k[i]),
                        combine(line.f(a), c_k[i + 1], -line.f(b), c_k[i]));
      }
    }
    require_coplanar<S, P>(u, c, d, t, equations);
  }
};

/// FJ07.18: the cells of a developable spline of any degree; cylinders and cones propagate.
struct Eq18 : CellClaim {
  static constexpr PointKind points = PointKind::coplanar;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo value{
        .id = "FJ07.18",
        .source = "equation (18)",
        .title = "developable splines cell by cell, cones included",
        .statement = R"(For any $(l_1,m_1)$ the recursion (18) gives $l_i=F(u_{i-1})/E(u_{i-1})$,
$m_i=E(u_{i+n-1})/E(u_{i-1})$ with $E(x)=(u_n-u_0)+(1-m_1)(u_0-x)$, $F(x)=l_1(u_n-u_0)+(1-m_1)(u_0-x)$; so
$l_i-1=(l_1-1)(u_n-u_0)/E(u_{i-1})$ and $m_i-1=(m_1-1)(u_{i+n-1}-u_{i-1})/E(u_{i-1})$ vanish in one cell iff in all. The
net is developable.)",
        .kind = Kind::identity,
        .hypotheses = {cell_denominators},
        .mutants = {"l_1 and m_1 exchanged", "u_{i+n-2} in the place of u_{i+n-1} in m_i", "the sign of m_i - 1",
                    "one cell repeated"},
        .remark = "F and E are (1-m_1)(L*-x) and (1-m_1)(M*-x) where L*, M* exist; for a cone they are constant."};
    return value;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, c, d0, first, t] = in;
    const int n = u.degree();
    const S one = from_int<S>(1);
    const CellLine<S, P> line{in};
    const std::vector<P> d = cell_net<S, P>(u, c, mutant.is(1) ? Cell<S>{first.m, first.l} : first, d0);
    Cell<S> cell = first;
    for (int i = 1; i <= u.last(); ++i) {
      if (i > 1 && !mutant.is(4)) cell = next_cell(u, cell, i);
      const S e = line.e(u[i - 1]);
      const S& end = u[mutant.is(2) ? i + n - 2 : i + n - 1];
      equations.equal(cell.l, line.f(u[i - 1]) / e);
      equations.equal(cell.m, line.e(end) / e);
      equations.equal(cell.l - one, (first.l - one) * line.span() / e);
      const S m_off = (first.m - one) * (u[i + n - 1] - u[i - 1]) / e;
      equations.equal(cell.m - one, mutant.is(3) ? -m_off : m_off);
    }
    for (int i = 0; i < u.last(); ++i) {  // (13) times (1-m_1)
      const std::size_t at_i = static_cast<std::size_t>(i);
      equations.equal(combine(line.e(u[i + n]), d[at_i], -line.e(u[i]), d[at_i + 1]),
                      combine(line.f(u[i + n]), c[at_i], -line.f(u[i]), c[at_i + 1]));
    }
    require_coplanar<S, P>(u, c, d, t, equations);
  }
};

}  // namespace torse::proofs::fj07
