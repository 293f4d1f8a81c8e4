// BZZ19, sections 3.4 and 4: the ruled surface and its Bezier pieces, equations (10) to (13).
//   Eq10, Eq11, Eq12, Eq13
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "torse/developable/special.hpp"
#include "torse/proofs/claims/bzz19/mapping.hpp"
#include "torse/spline/insertion.hpp"

namespace torse::proofs::bzz19 {

/// BZZ19.10: the surface over one piece.
struct Eq10 : Takes<PieceInput> {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "BZZ19.10",
        .source = "equation (10)",
        .title = "the ruled surface between C1 and C2 o sigma",
        .statement = R"(S(s,t)=(1-s)C_1(t)+sC_2(\sigma(t)),\quad S(0,t)=C_1(t),\ S(1,t)=C_2(\sigma(t)),\quad
S_t=(1-s)C_1'(t)+s\sigma'(t)C_2'(\sigma(t)))",
        .kind = Kind::identity,
        .hypotheses = {},
        .mutants = {"s and 1 - s exchanged", "sigma' left out", "C2(t) in the place of C2(sigma(t))"},
        .max_degree = 4,
        .max_pieces = 3,
        .remark = degrees_remark};
    return info;
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>&) {
    return {};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [c1, c2, e, t, s] = in;
    const S one = from_int<S>(1);
    const std::vector<P> first = elevated_points<S, P>(c1, in.degree());
    const std::vector<P> second = composed_points<S, P>(c2, e);
    const std::vector<P> row = restrict_rulings<S, P>(first, second, mutant.is(1) ? one - s : s);
    const S at_t = mutant.is(3) ? t : mapped(e, t);
    const S slope = mutant.is(2) ? one : mapped_slope(e, t);
    equations.equal(value(first, t), bernstein_sum(c1, t));
    equations.equal(value(second, t), bernstein_sum(c2, at_t));
    equations.equal(value(row, t), combine(one - s, bernstein_sum(c1, t), s, bernstein_sum(c2, at_t)));
    equations.equal(derivative(row, t), combine(one - s, bernstein_sum(fj21::hodograph<S, P>(c1), t), s * slope,
                                                bernstein_sum(fj21::hodograph<S, P>(c2), at_t)));
  }
};

/// BZZ19.11: a piece of the mapping in Bezier form.
struct Eq11 : Takes<MappingInput> {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 1;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "BZZ19.11",
        .source = "equation (11)",
        .title = "the Bezier form of a piece by knot insertion",
        .statement = R"(\text{Inserting the ends of }[a,b]\text{ until they are $d$-fold leaves the coefficients }
P_i^{(j)}=\sigma[a^{\langle d-i\rangle},b^{\langle i\rangle}]\text{ of }\hat\sigma^j(\hat t)=\sum_iP_i^{(j)}B_i^d(\hat t))",
        .kind = Kind::identity,
        .hypotheses = {},
        .mutants = {"the coefficients in reverse order", "those of [a, 2b - a]", "one insertion too few at b"}};
    return info;
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>&) {
    return {};
  }

  /// How often the knot u_i occurs next to u_i in the direction `step`, itself included.
  template <class S>
  static int run(const KnotList<S>& u, int i, int step) {
    int count = 1;
    while (i + count * step >= 0 && i + count * step < u.size() && definitely(equal(u[i], u[i + count * step])))
      ++count;
    return count;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, beta, t] = in;
    const int d = u.degree();
    for (int k : u.proper_pieces()) {
      const S a = u.piece_begin(k);
      const S b = u.piece_end(k);
      int begin = d + k - 2;  // u_begin = a, u_{begin+1} = b
      const int more_a = d - run(u, begin, -1);
      const int more_b = d - run(u, begin + 1, 1) - (mutant.is(3) ? 1 : 0);
      Spline<S, P> curve(u, beta);
      for (int i = 0; i < more_a; ++i) curve = insert_knot(curve, a, begin++);
      for (int i = 0; i < more_b; ++i) curve = insert_knot(curve, b, begin);
      const auto from = curve.control.begin() + (begin - d + 1);
      std::vector<P> inserted(from, from + (d + 1));
      if (mutant.is(1)) std::reverse(inserted.begin(), inserted.end());
      equations.equal(inserted, restricted_points<S, P>(u, beta, k, a, mutant.is(2) ? b + b - a : b));
    }
  }
};

/// BZZ19.12: its parameter.
struct Eq12 : Takes<MappingInput> {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 1;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "BZZ19.12",
        .source = "equation (12)",
        .title = "the parameter of a Bezier piece",
        .statement = R"(\hat\sigma^j(\hat t)=\sigma(\hat t(b-a)+a),\quad\hat t=\tfrac{t-a}{b-a})",
        .kind = Kind::identity,
        .hypotheses = {},
        .mutants = {"b t^ + a", "1 - t^ in the place of t^", "the coefficients of the next piece's length"}};
    return info;
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>&) {
    return {};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, beta, t] = in;
    for (int k : u.proper_pieces()) {
      const S& a = u.piece_begin(k);
      const S& b = u.piece_end(k);
      const std::vector<P> piece =
          mutant.is(3) ? restricted_points<S, P>(u, beta, k, b, b + b - a) : bezier_points<S, P>(u, beta, k);
      const S global = mutant.is(1) ? b * t + a : t * (b - a) + a;
      equations.equal(bernstein_sum(piece, mutant.is(2) ? from_int<S>(1) - t : t),
                      curve_point<S, P>(u, beta, k, global));
    }
  }
};

/// BZZ19.13: the mapping between the local parameters.
struct Eq13 : Takes<PieceInput> {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "BZZ19.13",
        .source = "equation (13)",
        .title = "the piece of C2 with the mapping of its own parameter",
        .statement = R"(\hat T=\frac{\hat\sigma(\hat t)-\sigma(a)}{\sigma(b)-\sigma(a)}:\quad
\hat C_2(\hat T(\hat t))=C_2(\sigma(t))\text{ for the Bezier form }\hat C_2\text{ of }C_2\text{ on }[\sigma(a),\sigma(b)])",
        .kind = Kind::identity,
        .hypotheses = {{"sigma(a) is not sigma(b)", false}},
        .mutants = {"sigma(a) not subtracted", "divided by sigma(b)", "C2 on [sigma(b), sigma(a)]"},
        .max_degree = 4,
        .max_pieces = 3,
        .remark =
            "n stands for the degree p of the rails, N for the degree d of sigma. Where sigma(a) = sigma(b) the "
            "surface exists all the same: sigma in the coordinate of a whole piece of C2 needs no division by "
            "their difference."};
    return info;
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return {{in.e.back() - in.e.front()}};
  }
  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const std::vector<P> x = fj07::example_points<S, P>(6);
    const S one = from_int<S>(1);
    return {{0, {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, {one, one + one, one}, one / (one + one), one}}};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [c1, c2, e, t, s] = in;
    const KnotList<S> unit = bezier_knots<S>(degree_of(c2));
    const S& low = mutant.is(3) ? e.back() : e.front();
    const S& high = mutant.is(3) ? e.front() : e.back();
    const std::vector<P> piece = restricted_points<S, P>(unit, c2, 1, low, high);
    std::vector<S> local;
    for (const S& x : e) {
      const S over = mutant.is(2) ? e.back() : e.back() - e.front();
      local.push_back((mutant.is(1) ? x : x - e.front()) / over);
    }
    const std::vector<P> whole = composed_points<S, P>(c2, e);
    equations.equal(composed_points<S, P>(piece, local), whole);
    equations.equal(value(whole, t), bernstein_sum(c2, mapped(e, t)));
  }
};

}  // namespace torse::proofs::bzz19
