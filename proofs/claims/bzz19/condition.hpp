// BZZ19, sections 3.3 and 5: developability along a ruling, equations (6) to (8), and the warp angle.
//   Eq6, Eq7, Eq8, Warp
#pragma once

#include <utility>
#include <vector>

#include "torse/algebra/determinant.hpp"
#include "torse/developable/condition.hpp"
#include "torse/developable/warp.hpp"
#include "torse/proofs/claims/bzz19/common.hpp"
#include "torse/quasi/condition.hpp"

namespace torse::proofs::bzz19 {

/// BZZ19.6: the surface is developable along the ruling at t iff sigma'(t) E1 = 0.
struct Eq6 {
  static constexpr PointKind points = PointKind::space;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "BZZ19.6",
        .source = "equation (6)",
        .title = "developable iff E1 = 0",
        .statement = R"(E_1=[C_1(t)-C_2(\sigma),C_1'(t),C_2'(\sigma)],\ c=C_1,\ d=C_2\circ\sigma:\quad
E_1=[d',c',d-c]/\sigma'(t))",
        .kind = Kind::equivalence,
        .hypotheses = {{"sigma'(t) is not 0: where it is, every ruling is developable, whatever E1 is", false}},
        .mutants = {"C1 + C2 in the place of C1 - C2", "without 1/sigma'", "C1' and C2' exchanged"},
        .max_degree = 3,
        .max_pieces = 2,
        .remark =
            "n stands for the degree p of the rails, N for the degree d of sigma. E1 = 0 suffices always; at "
            "sigma'(t) = 0 it is not necessary: the tangent plane of C1 stays along the ruling."};
    return info;
  }

  template <class S, class P>
  struct In {
    S t;
    std::vector<Vec<S, 1>> sigma;  ///< sigma(t), sigma'(t), ...: Taylor coefficients at t
    std::vector<P> c1;             ///< of C1 at t
    std::vector<P> c2;             ///< of C2 at sigma(t)
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    S t = from.scalar();
    std::vector<Vec<S, 1>> sigma = from.template points<Vec<S, 1>>(size.pieces + 1);
    std::vector<P> c1 = from.template points<P>(size.n + 1);
    return {std::move(t), std::move(sigma), std::move(c1), from.template points<P>(size.n + 1)};
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return {{in.sigma[1][0]}};
  }
  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const std::vector<P> x = fj07::example_points<S, P>(4);
    const std::vector<Vec<S, 1>> sigma(2, Vec<S, 1>::Constant(from_int<S>(0)));
    return {{0, {from_int<S>(2), sigma, {x[0], x[1]}, {x[2], x[3]}}}};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const int p = degree_of(in.c1);
    const int d = degree_of(in.sigma);
    std::vector<S> e;
    for (const Vec<S, 1>& x : fj07::taylor_net(bezier_knots<S>(d), 1, in.t, in.sigma)) e.push_back(x[0]);
    const std::vector<P> c1 = fj07::taylor_net(bezier_knots<S>(p), 1, in.t, in.c1);
    const std::vector<P> c2 = fj07::taylor_net(bezier_knots<S>(p), 1, in.sigma[0][0], in.c2);
    const std::vector<P> first = elevated_points<S, P>(c1, p * d);
    const std::vector<P> second = composed_points<S, P>(c2, e);
    const S det = pointwise_determinant<S>(bezier_knots<S>(p * d), first, second, 1, in.t);

    const P ruling = mutant.is(1) ? sum(in.c1[0], in.c2[0]) : difference(in.c1[0], in.c2[0]);
    const S e1 = mutant.is(3) ? ruling_determinant<S>(ruling, in.c2[1], in.c1[1])
                              : ruling_determinant<S>(ruling, in.c1[1], in.c2[1]);
    equations.equal(mutant.is(2) ? det : det / in.sigma[1][0], e1);
  }
};

/// The three vectors of a ruling and another one.
template <class S, class P>
struct RulingInput {
  P w;
  P a;
  P b;
  P normal;

  static RulingInput draw(Source<S>& from, Size size);
};

template <class S, class P>
RulingInput<S, P> RulingInput<S, P>::draw(Source<S>& from, Size) {
  P w = from.template point<P>();
  P a = from.template point<P>();
  P b = from.template point<P>();
  return {std::move(w), std::move(a), std::move(b), from.template point<P>()};
}

struct RulingClaim : Takes<RulingInput> {
  static constexpr PointKind points = PointKind::space;
  static constexpr int dimension = 3;
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>&) {
    return {};
  }
};

/// BZZ19.7: a common normal exists iff E1 = 0.
struct Eq7 : RulingClaim {
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "BZZ19.7",
        .source = "equation (7)",
        .title = "a common normal exists iff E1 = 0",
        .statement = R"(L=C_1-C_2:\quad E_1N=(N\cdot L)\,C_1'\times C_2'+(N\cdot C_1')\,C_2'\times L
+(N\cdot C_2')\,L\times C_1';\quad(C_1'\times C_2')\cdot L=(C_2'\times L)\cdot C_1'=(L\times C_1')\cdot C_2'=E_1)",
        .kind = Kind::equivalence,
        .hypotheses = {},
        .mutants = {"L x C2'", "C1' x L in the last term", "N . C1' and N . C2' exchanged"},
        .max_degree = 1,
        .max_pieces = 1,
        .remark =
            "If N is not 0 and the three products vanish, E1 does. If E1 = 0, the largest of the three cross "
            "products is such an N, or, where all of them vanish, any vector across the one line that the three "
            "vectors span: N exists then too but is not unique and no normal of a surface."};
    return info;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [w, a, b, normal] = in;
    const S e1 = ruling_determinant<S>(w, a, b);
    const P last = mutant.is(2) ? cross<S>(a, w) : cross<S>(w, a);
    const P across = mutant.is(1) ? cross<S>(w, b) : cross<S>(b, w);
    P total = scaled(dot<S>(normal, w), cross<S>(a, b));
    add_scaled(total, dot<S>(normal, mutant.is(3) ? b : a), across);
    add_scaled(total, dot<S>(normal, mutant.is(3) ? a : b), last);
    equations.equal(scaled(e1, normal), total);
    equations.equal(dot<S>(cross<S>(a, b), w), e1);
    equations.equal(dot<S>(across, a), e1);
    equations.equal(dot<S>(last, b), e1);
  }
};

/// BZZ19.8: the least value of E2 over unit vectors is 0 iff E1 = 0.
struct Eq8 : RulingClaim {
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "BZZ19.8",
        .source = "equation (8)",
        .title = "E2 as a quadratic form with determinant E1^2",
        .statement = R"(E_2(N)=(N\cdot C_1')^2+(N\cdot C_2')^2+(N\cdot L)^2=N^TMN,\quad
M=C_1'C_1'^T+C_2'C_2'^T+LL^T,\ \det M=E_1^2,\ E_2(C_1'\times C_2')=E_1^2)",
        .kind = Kind::equivalence,
        .hypotheses = {},
        .mutants = {"(N . L)^2 left out", "det M = E1", "(N . C1')(N . C2') in the place of a square"},
        .max_degree = 1,
        .max_pieces = 1,
        .remark =
            "M is not negative, so the least E2 of a unit N is its least eigenvalue: 0 iff det M = E1^2 is, with no "
            "exception. That N is of unit length is needed and in (9) only a penalty: E2 is 0 at N = 0 and small "
            "near it."};
    return info;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [w, a, b, normal] = in;
    std::vector<P> rows;  // of M
    for (int i = 0; i < 3; ++i) {
      P row = combine(a[i], a, b[i], b);
      if (!mutant.is(1)) add_scaled(row, w[i], w);
      if (mutant.is(3)) row = combine(a[i], b, w[i], w);
      rows.push_back(std::move(row));
    }
    S form = from_int<S>(0);
    for (int i = 0; i < 3; ++i) form += normal[i] * dot<S>(rows[static_cast<std::size_t>(i)], normal);
    equations.equal(normal_residual<S>(normal, w, a, b), form);
    const S e1 = ruling_determinant<S>(w, a, b);
    equations.equal(det3<S>(rows[0], rows[1], rows[2]), mutant.is(2) ? e1 : e1 * e1);
    equations.equal(normal_residual<S>(cross<S>(a, b), w, a, b), e1 * e1);
  }
};

/// The warp angle of section 5: the angle between the normals at the ends of a ruling.
struct Warp {
  static constexpr PointKind points = PointKind::space;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "BZZ19.W",
        .source = "section 5, warp angles",
        .title = "the sine of the warp angle",
        .statement = R"(a=c',\ b=d',\ w=d-c,\ m=a\times w,\ n=b\times w:\ m\times n=-[a,w,b]\,w,\quad
\sin^2=\frac{|m\times n|^2}{|m|^2|n|^2}=\frac{|w|^2[a,w,b]^2}{|m|^2|n|^2},\quad|m\times n|^2+(m\cdot n)^2=|m|^2|n|^2)",
        .kind = Kind::identity,
        .hypotheses = {{"a x w is not 0: the first rail is regular and not tangent to the ruling", false},
                       {"b x w is not 0: so is the second, and sigma' is not 0", false}},
        .mutants = {"[a,w,b] in the place of its square", "without |w|^2", "the cosine with + (a.w)(b.w)"},
        .max_pieces = 1,
        .remark =
            "The angle does not depend on the speed of the parameters of the rails, so sigma' cancels where it is "
            "not 0. It is defined for every ruling with two normals and 0 iff E1 is."};
    return info;
  }

  template <class S, class P>
  using In = fj07::RuledJets<S, P>;
  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    return fj07::draw_jets<S, P>(from, size);
  }

  /// |x|^2 by Lagrange's identity would share the products of cross; the squares of the coordinates do not.
  template <class S, class P>
  static S square(const P& x) {
    return x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    const P w = difference(in.d_taylor[0], in.c_taylor[0]);
    return {{square<S>(cross<S>(in.c_taylor[1], w))}, {square<S>(cross<S>(in.d_taylor[1], w))}};
  }
  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const std::vector<P> x = fj07::example_points<S, P>(3);
    const KnotList<S> u = bezier_knots<S>(1);
    const S t = from_int<S>(0);
    const auto with = [&](P a, P b) {  // c = x0 + a t, d = x1 + b t
      const std::vector<P> c{x[0], a};
      const std::vector<P> d{x[1], b};
      return In<S, P>{u, 1, t, c, d, fj07::taylor_net(u, 1, t, c), fj07::taylor_net(u, 1, t, d)};
    };
    const P w = difference(x[1], x[0]);
    return {{0, with(w, x[2])}, {1, with(x[2], w)}};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const P& a = in.c_taylor[1];
    const P& b = in.d_taylor[1];
    const P w = difference(in.d_taylor[0], in.c_taylor[0]);
    const P m = cross<S>(a, w);
    const P n = cross<S>(b, w);
    const S det = det3<S>(a, w, b);
    equations.equal(cross<S>(m, n), scaled(-det, w));

    const S length = square<S>(w);
    const S product = dot<S>(a, w) * dot<S>(b, w);
    const S cosine = dot<S>(a, b) * length + (mutant.is(3) ? product : -product);  // m . n
    equations.equal(dot<S>(m, n), cosine);
    const S sine = (mutant.is(2) ? from_int<S>(1) : length) * (mutant.is(1) ? det : det * det);
    const S whole = sine + cosine * cosine;
    equations.equal(square<S>(m) * square<S>(n), whole);
    equations.equal(pointwise_sine_squared<S>(in.u, in.c, in.d, in.piece, in.t), sine / whole);
  }
};

}  // namespace torse::proofs::bzz19
