// FJ07, section 2: the Gaussian curvature of a ruled surface, equations (1) to (3).
//   Eq1, Eq2, Eq3
#pragma once

#include <array>
#include <initializer_list>
#include <vector>

#include "torse/algebra/dependence.hpp"
#include "torse/algebra/determinant.hpp"
#include "torse/developable/condition.hpp"
#include "torse/developable/special.hpp"
#include "torse/proofs/claims/fj07/common.hpp"

namespace torse::proofs::fj07 {

/// [d', c', d-c] from Taylor coefficients.
template <class S, class P>
S jet_determinant(const RuledJets<S, P>& in) {
  return det3<S>(in.d_taylor[1], in.c_taylor[1], difference(in.d_taylor[0], in.c_taylor[0]));
}

/// FJ07.1: the numerator of the Gaussian curvature is -[d', c', d-c]^2.
struct Eq1 {
  static constexpr PointKind points = PointKind::space;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo value{
        .id = "FJ07.1",
        .source = "equation (1)",
        .title = "Gaussian curvature of a ruled surface",
        .statement = R"(For $b=(1-v)c+vd$ and $n=b_u\times b_v$: $b_{vv}=0$ and
$(b_{uu}\cdot n)(b_{vv}\cdot n)-(b_{uv}\cdot n)^2=-[d',c',d-c]^2$; hence (1) holds iff (3) does.)",
        .kind = Kind::identity,
        .hypotheses = {},
        .mutants = {"+[d',c',d-c]^2", "d+c in the place of d-c", "n = b_u x d"},
        .remark =
            "Any multiple of the unit normal will do, so the identity holds at singular points too, where (1) as "
            "printed has no unit normal to speak of."};
    return value;
  }

  template <class S, class P>
  struct In {
    RuledJets<S, P> jets;
    S v;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    RuledJets<S, P> jets = draw_jets<S, P>(from, size);
    return {std::move(jets), from.scalar()};
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>&) {
    return {};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, k, t, c_taylor, d_taylor, c, d] = in.jets;
    const P at_c = curve_point<S, P>(u, c, k, t);
    const P at_d = curve_point<S, P>(u, d, k, t);
    const std::vector<P> row = restrict_rulings<S, P>(c, d, in.v);
    // b_vv = 0: b is affine in v.
    equations.equal(curve_point<S, P>(u, row, k, t), combine(from_int<S>(1) - in.v, c_taylor[0], in.v, d_taylor[0]));
    const P b_v = mutant.is(3) ? at_d : difference(at_d, at_c);
    const P b_uv = difference(curve_derivative<S, P>(u, d, k, t), curve_derivative<S, P>(u, c, k, t));
    const S mixed = dot<S>(b_uv, cross<S>(curve_derivative<S, P>(u, row, k, t), b_v));
    const S numerator = -(mixed * mixed);
    const S det =
        mutant.is(2) ? det3<S>(d_taylor[1], c_taylor[1], sum(d_taylor[0], c_taylor[0])) : jet_determinant(in.jets);
    equations.equal(numerator, mutant.is(1) ? det * det : -(det * det));
  }
};

/// FJ07.2: the triple product of (2) does not depend on v.
struct Eq2 {
  static constexpr PointKind points = PointKind::space;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo value{
        .id = "FJ07.2",
        .source = "equation (2)",
        .title = "the condition is the same at every point of a ruling",
        .statement =
            R"($[b_{uv},b_u,b_v](u,v)=[d'(u),c'(u),d(u)-c(u)]$ for every $v$, so (2) at one $v$ is (2) at all $v$.)",
        .kind = Kind::identity,
        .hypotheses = {},
        .mutants = {"[c',d',d-c]", "b in the place of b_v", "b_uv = d'+c'"}};
    return value;
  }

  template <class S, class P>
  using In = Eq1::In<S, P>;
  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    return Eq1::draw<S, P>(from, size);
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>&) {
    return {};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, k, t, c_taylor, d_taylor, c, d] = in.jets;
    const S oracle = pointwise_determinant<S>(u, c, d, k, t);
    const P b_v = difference(d_taylor[0], c_taylor[0]);
    const P b_uv = mutant.is(3) ? sum(d_taylor[1], c_taylor[1]) : difference(d_taylor[1], c_taylor[1]);
    for (const S& v : {in.v, from_int<S>(0), from_int<S>(1)}) {
      const P b_u = combine(from_int<S>(1) - v, c_taylor[1], v, d_taylor[1]);
      const P along = mutant.is(2) ? combine(from_int<S>(1) - v, c_taylor[0], v, d_taylor[0]) : b_v;
      const S triple = det3<S>(b_uv, b_u, along);
      equations.equal(oracle, mutant.is(1) ? -triple : triple);
    }
  }
};

/// FJ07.3: the vectors c', d', d-c and the last but one points of de Boor's algorithm; one tangent plane along a
/// ruling.
struct Eq3 {
  static constexpr PointKind points = PointKind::space;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo value{
        .id = "FJ07.3",
        .source = "equation (3)",
        .title = "developable iff c', d', d-c are coplanar",
        .statement = R"(On $[a,b]$: $[d',c',d-c]=\left(\frac{n}{b-a}\right)^2[c_1^{n-1}-c_0^{n-1},d_0^{n-1}-c_0^{n-1},
d_1^{n-1}-c_0^{n-1}]$, and the normals $n(v)=b_u\times b_v$ along a ruling obey
$n(v)\times n(w)=(v-w)\,[d',c',d-c]\,(d-c)$.)",
        .kind = Kind::equivalence,
        .hypotheses = {},
        .mutants = {"n/(b-a) once", "d_0 and d_1 exchanged", "v - w without the sign"},
        .remark =
            "Where d = c the second identity says nothing: a ruling of length zero has no direction. The determinant "
            "is zero there."};
    return value;
  }

  template <class S, class P>
  struct In {
    RuledJets<S, P> jets;
    S v;
    S w;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    RuledJets<S, P> jets = draw_jets<S, P>(from, size);
    S v = from.scalar();
    return {std::move(jets), std::move(v), from.scalar()};
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>&) {
    return {};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, k, t, c_taylor, d_taylor, c, d] = in.jets;
    const S det = jet_determinant(in.jets);
    equations.equal(pointwise_determinant<S>(u, c, d, k, t), det);

    const auto [c0, c1] = last_pair<S, P>(u, c, k, t);
    const auto [d0, d1] = last_pair<S, P>(u, d, k, t);
    const S scale = from_int<S>(u.degree()) / (u.piece_end(k) - u.piece_begin(k));
    const S factor = mutant.is(1) ? scale : scale * scale;
    const std::array<P, 4> four{c0, c1, mutant.is(2) ? d1 : d0, mutant.is(2) ? d0 : d1};
    equations.equal(det, factor * dependence_residual(four).front());

    const P ruling = difference(d_taylor[0], c_taylor[0]);
    const auto normal = [&in, &ruling](const S& v) {
      return cross<S>(combine(from_int<S>(1) - v, in.jets.c_taylor[1], v, in.jets.d_taylor[1]), ruling);
    };
    const S turn = mutant.is(3) ? in.w - in.v : in.v - in.w;
    equations.equal(cross<S>(normal(in.v), normal(in.w)), scaled(turn * det, ruling));
  }
};

}  // namespace torse::proofs::fj07
