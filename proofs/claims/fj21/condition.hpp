// FJ21, sections 2 and 3: the condition of developability as a determinant. The determinants are related exactly, with
// their factors, so that one vanishes iff the other does where the factors do not.
//   Eq2_1     the condition on points and derivatives        P3_1     ... on the last but one affine points
//   C3_1      ... on the last but one homogeneous rows
#pragma once

#include <utility>
#include <vector>

#include "torse/developable/condition.hpp"
#include "torse/proofs/claims/fj21/pair.hpp"

namespace torse::proofs::fj21 {

/// x / w and (x / w)' of a homogeneous row x = w (1, c).
template <class S>
struct AffinePoint {
  Vec<S, 3> point;
  Vec<S, 3> derivative;

  AffinePoint(const std::vector<Vec<S, 4>>& rows, const S& t) {
    const Vec<S, 4> x = bernstein_sum(rows, t);
    const Vec<S, 4> dx = bernstein_sum(hodograph<S>(rows), t);
    for (int j = 0; j < 3; ++j) {
      point[j] = x[j + 1] / x[0];
      derivative[j] = (dx[j + 1] - dx[0] * point[j]) / x[0];
    }
  }
};

template <class S>
S pointwise(const LocalInput<S, Vec<S, 4>>& in) {
  return pointwise_determinant<S>(bezier_knots<S>(degree_of(in.p)), in.p, in.q, 1, in.t);
}

/// Rows of degree one for stored failures: weights w_0, w_1 and omega_0, omega_1, points in general position, t = 1/2.
template <class S>
LocalInput<S, Vec<S, 4>> weighted_lines(int w0, int w1, int omega0, int omega1) {
  const auto row = [](int w, int x, int y, int z) {
    Vec<S, 4> v;
    v << from_int<S>(w), from_int<S>(x), from_int<S>(y), from_int<S>(z);
    return v;
  };
  return {{row(w0, 0, 0, 1), row(w1, 1, 0, 2)}, {row(omega0, 0, 1, 5), row(omega1, 1, 3, 1)}, ratio<S>(1, 2)};
}

/// FJ21.2.1: (d-c).(c' x d') against the numerator of the Gaussian curvature at any point of the ruling.
struct Eq2_1 {
  static constexpr PointKind points = PointKind::space;
  static constexpr int dimension = 4;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "FJ21.2.1",
        .source = "equation (2.1)",
        .title = "condition of developability",
        .statement = R"((d-c)\cdot(c'\times d')=-[\,b_{tv},b_t,b_v\,](t,v)\ \text{for every } v,\qquad
K=-\frac{[b_{tv},b_t,b_v]^2}{|b_t\times b_v|^4})",
        .kind = Kind::equivalence,
        .hypotheses = {{"w(t) is not 0", true}, {"omega(t) is not 0", true}},
        .mutants = {"d + c in the place of d - c", "d' + c' in the place of d' - c'", "v in the place of 1-v in b_t"},
        .max_pieces = 1,
        .remark =
            "The tangent plane is constant along a ruling iff K = 0 at its regular points. 'Necessarily the envelope "
            "of "
            "its tangent planes' needs a family of planes: a plane surface satisfies (2.1) and is no envelope."};
    return info;
  }

  template <class S, class P>
  struct In {
    LocalInput<S, P> pair;
    S v;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    LocalInput<S, P> pair = LocalInput<S, P>::draw(from, size);
    return {std::move(pair), from.scalar()};
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return {{value(in.pair.p, in.pair.t)[0]}, {value(in.pair.q, in.pair.t)[0]}};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [p, q, t] = in.pair;
    const AffinePoint<S> c(p, t);
    const AffinePoint<S> d(q, t);
    const S v = in.v;
    const S one = from_int<S>(1);
    const Vec<S, 3> b_v = mutant.is(1) ? sum(d.point, c.point) : difference(d.point, c.point);
    const Vec<S, 3> b_tv = mutant.is(2) ? sum(d.derivative, c.derivative) : difference(d.derivative, c.derivative);
    const Vec<S, 3> b_t = combine(mutant.is(3) ? v : one - v, c.derivative, v, d.derivative);
    const S w = bernstein_sum(p, t)[0] * bernstein_sum(q, t)[0];
    equations.equal(pointwise(in.pair), -(w * w * w * w * det3<S>(b_tv, b_t, b_v)));
  }

  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    return {{0, {weighted_lines<S>(1, -1, 1, 2), ratio<S>(1, 3)}},
            {1, {weighted_lines<S>(1, 2, 1, -1), ratio<S>(1, 3)}}};
  }
};

/// FJ21.P3.1: (2.1) against the volume of the last but one points of de Casteljau's algorithm.
struct P3_1 : Takes<LocalInput> {
  static constexpr PointKind points = PointKind::space;
  static constexpr int dimension = 4;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "FJ21.P3.1",
        .source = "Proposition 3.1",
        .title = "developable iff the last but one points are coplanar",
        .statement = R"((d-c)\cdot(c'\times d')=-n^2\,\frac{w_0w_1\omega_0\omega_1}{w^2\omega^2}
\,[\,c_1-c_0,\,d_0-c_0,\,d_1-c_0\,],\quad c_i=c_i^{n-1}(t),\ w_i=w_i^{n-1}(t),\dots)",
        .kind = Kind::equivalence,
        .hypotheses = {{"w(t) and omega(t) are not 0", false},
                       {"w_0^{n-1}(t), w_1^{n-1}(t), omega_0^{n-1}(t), omega_1^{n-1}(t) are not 0", false}},
        .mutants = {"n (n+1) in the place of n^2", "the weights of the four points left out", "d_0 and d_1 exchanged"},
        .max_pieces = 1,
        .remark =
            "Where one of the four weights vanishes its point is at infinity and the proposition says nothing; "
            "Corollary "
            "3.1 still holds there."};
    return info;
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    const S zero = from_int<S>(0);
    const S one = from_int<S>(1);
    return {{value(in.p, in.t)[0], value(in.q, in.t)[0]},
            {tangent(in.p, in.t, zero)[0], tangent(in.p, in.t, one)[0], tangent(in.q, in.t, zero)[0],
             tangent(in.q, in.t, one)[0]}};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto affine = [](const P& row) {
      Vec<S, 3> x;
      for (int j = 0; j < 3; ++j) x[j] = row[j + 1] / row[0];
      return x;
    };
    const int n = degree_of(in.p);
    const KnotList<S> u = bezier_knots<S>(n);
    const auto [p0, p1] = last_pair<S, P>(u, in.p, 1, in.t);
    const auto [q0, q1] = last_pair<S, P>(u, in.q, 1, in.t);
    const Vec<S, 3> c0 = affine(p0);
    const Vec<S, 3> d0 = affine(mutant.is(3) ? q1 : q0);
    const Vec<S, 3> d1 = affine(mutant.is(3) ? q0 : q1);
    const S volume = det3<S>(difference(affine(p1), c0), difference(d0, c0), difference(d1, c0));
    const S w = bernstein_sum(in.p, in.t)[0] * bernstein_sum(in.q, in.t)[0];
    const S weights = mutant.is(2) ? from_int<S>(1) : p0[0] * p1[0] * q0[0] * q1[0];
    const S square = from_int<S>(mutant.is(1) ? n * (n + 1) : n * n);
    equations.equal(pointwise(in) / (w * w * w * w), -(square * weights / (w * w) * volume));
  }

  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    return {{0, weighted_lines<S>(1, -1, 1, 2)}, {1, weighted_lines<S>(0, 1, 1, 2)}};
  }
};

/// FJ21.C3.1: the determinant of the last but one rows: a polynomial of degree 4(n-1), and (2.1) up to weights.
struct C3_1 : Takes<LocalInput> {
  static constexpr PointKind points = PointKind::space;
  static constexpr int dimension = 4;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "FJ21.C3.1",
        .source = "Corollary 3.1",
        .title = "developable iff the last but one rows are dependent",
        .statement = R"(w^2\omega^2\,(d-c)\cdot(c'\times d')=-n^2\det(p_0^{n-1},p_1^{n-1},q_0^{n-1},q_1^{n-1})(t),\quad
\text{a polynomial of degree at most }4(n-1))",
        .kind = Kind::equivalence,
        .hypotheses = {},
        .mutants = {"n (n+1) in the place of n^2", "q_0 and q_1 exchanged", "w omega in the place of w^2 omega^2"},
        .max_degree = 8,
        .max_pieces = 1,
        .remark =
            "The determinant vanishes at a zero of w or omega only if the homogeneous rows are dependent there: a "
            "polynomial identity, so such parameters need no exception in the statement for all t."};
    return info;
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>&) {
    return {};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const int n = degree_of(in.p);
    const KnotList<S> u = bezier_knots<S>(n);
    const auto [p0, p1] = last_pair<S, P>(u, in.p, 1, in.t);
    const auto [q0, q1] = last_pair<S, P>(u, in.q, 1, in.t);
    const S determinant = mutant.is(2) ? det4<S>(p0, p1, q1, q0) : det4<S>(p0, p1, q0, q1);
    const S square = from_int<S>(mutant.is(1) ? n * (n + 1) : n * n);

    const BinaryForm<S> form = span_determinant<S>(u, std::span<const P>(in.p), std::span<const P>(in.q), 1);
    equations.equal(from_int<S>(form.degree()), from_int<S>(4 * (n - 1)));
    equations.equal(form(from_int<S>(1) - in.t, in.t), square * square * determinant);

    const S w = bernstein_sum(in.p, in.t)[0] * bernstein_sum(in.q, in.t)[0];
    equations.equal(pointwise(in), -(square * (mutant.is(3) ? w : w * w) * determinant));
  }
};

}  // namespace torse::proofs::fj21
