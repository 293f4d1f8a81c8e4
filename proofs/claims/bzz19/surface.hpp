// BZZ19, section 4: powers in Bernstein form, elevation and the joined surface, equations (14) to (16).
//   Eq14, Eq15, Eq16
#pragma once

#include <utility>
#include <vector>

#include "torse/proofs/claims/bzz19/common.hpp"

namespace torse::proofs::bzz19 {

/// BZZ19.14: t^k in the Bernstein basis of degree D.
struct Eq14 {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 1;
  static const ClaimInfo& info() {
    static const ClaimInfo info{.id = "BZZ19.14",
                                .source = "equation (14)",
                                .title = "powers in the Bernstein basis",
                                .statement = R"(t^k=\sum_{i=k}^D\binom ik\binom Dk^{-1}B_{i,D}(t),\quad0\le k\le D)",
                                .kind = Kind::identity,
                                .hypotheses = {},
                                .mutants = {"C(i,k) / C(D,i)", "i + 1 in the place of i", "k + 1 in the place of k"},
                                .max_pieces = 1,
                                .remark = "n stands for D."};
    return info;
  }

  template <class S, class P>
  struct In {
    int degree;
    S t;
  };
  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    return {size.n, from.scalar()};
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>&) {
    return {};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    S power = from_int<S>(1);
    for (int k = 0; k <= in.degree; ++k) {
      std::vector<Vec<S, 1>> row;
      for (int i = 0; i <= in.degree; ++i) {
        const S upper = binomial<S>(mutant.is(2) ? i + 1 : i, mutant.is(3) ? k + 1 : k);
        row.push_back(Vec<S, 1>::Constant(upper / binomial<S>(in.degree, mutant.is(1) ? i : k)));
      }
      equations.equal(value(row, in.t)[0], power);
      power *= in.t;
    }
  }
};

/// BZZ19.15: elevation of C1 through powers.
struct Eq15 : Takes<PieceInput> {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "BZZ19.15",
        .source = "equation (15)",
        .title = "elevation from p to p d",
        .statement = R"(\hat C_1(\hat t)=\sum_{i\le p}f_i\hat t^i+\sum_{j=p+1}^{pd}0\,\hat t^j
=\sum_iB_i^{pd}(\hat t)P_i,\ P_i=\sum_{k\le p}\binom ik\binom{pd}k^{-1}f_k)",
        .kind = Kind::identity,
        .hypotheses = {},
        .mutants = {"f_p moved to the power p d", "p in the place of p d in the binomials", "f without binomials"},
        .max_pieces = 4,
        .remark = degrees_remark};
    return info;
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>&) {
    return {};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const int p = degree_of(in.c1);
    std::vector<P> f = powers_of<S, P>(in.c1);
    for (int k = 0; mutant.is(3) && k <= p; ++k) divide(f[static_cast<std::size_t>(k)], binomial<S>(p, k));
    if (mutant.is(1)) f.insert(f.end() - 1, static_cast<std::size_t>(in.degree() - p), PointTraits<P>::zero());
    std::vector<P> row = from_powers<S, P>(f, in.degree());
    if (mutant.is(2)) {
      row = from_powers<S, P>(f, p);
      row.insert(row.end(), static_cast<std::size_t>(in.degree() - p), row.back());
    }
    equations.equal(elevated_points<S, P>(in.c1, in.degree()), row);
    equations.equal(value(row, in.t), bernstein_sum(in.c1, in.t));
  }
};

/// BZZ19.16: the joined surface.
struct Eq16 {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "BZZ19.16",
        .source = "equation (16)",
        .title = "the B-spline surface of Algorithm 1",
        .statement = R"(\text{With the polygons of all pieces joined and each knot }pd\text{-fold: }
S(0,t)=C_1(t),\ S(1,t)=C_2(\sigma(t)),\ H+1=(h+1)pd+1\text{ points a row})",
        .kind = Kind::identity,
        .hypotheses = {},
        .mutants = {"the pieces of C2 shifted by one", "sigma of the neighbouring coefficients", "C1 and C2 exchanged"},
        .max_degree = 4,
        .max_pieces = 4,
        .remark =
            "n stands for the degree p of the rails, N for the number h + 1 of pieces; sigma is quadratic with "
            "double knots, so that what it passes at its knots is free: the knots of C2. Fewer knots are special "
            "cases. Over uniform knots, which the paper takes, the rows are C1 and C2 o sigma after a change of "
            "t that is affine on each piece only."};
    return info;
  }

  template <class S, class P>
  struct In {
    Spline<S, P> c1;
    Spline<S, P> c2;
    std::vector<S> knots;  ///< of sigma
    std::vector<S> beta;   ///< of sigma
    S t;
  };

  /// n-fold ends, simple knots between them.
  template <class S>
  static KnotList<S> clamped(int degree, const std::vector<S>& list) {
    std::vector<S> u(static_cast<std::size_t>(degree - 1), list.front());
    u.insert(u.end(), list.begin(), list.end());
    u.insert(u.end(), static_cast<std::size_t>(degree - 1), list.back());
    return KnotList<S>(degree, std::move(u));
  }

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    const std::vector<S> knots = from.knots({1, size.pieces});
    const std::vector<S> values = from.knots({1, size.pieces});
    const int count = size.pieces + size.n;
    Spline<S, P> c1(clamped(size.n, knots), from.template points<P>(count));
    Spline<S, P> c2(clamped(size.n, values), from.template points<P>(count));
    std::vector<S> beta{values.front()};
    for (std::size_t j = 1; j < values.size(); ++j) {
      beta.push_back(from.scalar());
      beta.push_back(values[j]);
    }
    return {std::move(c1), std::move(c2), knots, std::move(beta), from.scalar()};
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>&) {
    return {};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const int degree = 2 * in.c1.knots.degree();
    const int count = static_cast<int>(in.knots.size()) - 1;
    std::vector<S> doubled;
    for (const S& t : in.knots) doubled.insert(doubled.end(), 2, t);
    std::vector<S> beta = in.beta;
    if (mutant.is(2)) beta.assign(in.beta.rbegin(), in.beta.rend());
    const Mapping<S> sigma = mapping_of(KnotList<S>(2, doubled), beta);
    std::vector<SurfacePiece<P>> pieces;
    for (int j = 1; j <= count; ++j) {
      const S& a = in.knots[static_cast<std::size_t>(j - 1)];
      const S& b = in.knots[static_cast<std::size_t>(j)];
      const int other = mutant.is(1) ? count + 1 - j : j;
      pieces.push_back(surface_piece(in.c1, j, in.c2, other, sigma, 2 * j - 1, a, b, degree));
      if (mutant.is(3)) std::swap(pieces.back().first, pieces.back().second);
    }
    const RuledSpline<S, P> surface = join_pieces(in.knots, pieces, degree);
    equations.equal(from_int<S>(static_cast<std::int64_t>(surface.c.size())), from_int<S>(count * degree + 1));
    for (int j = 1; j <= count; ++j) {
      const int k = (j - 1) * degree + 1;
      const std::size_t at_j = static_cast<std::size_t>(j);
      const S local = (in.t - in.knots[at_j - 1]) / (in.knots[at_j] - in.knots[at_j - 1]);
      const S value = mapped<S>({in.beta[2 * at_j - 2], in.beta[2 * at_j - 1], in.beta[2 * at_j]}, local);
      equations.equal(curve_point<S, P>(surface.knots, surface.c_row(), k, in.t),
                      curve_point<S, P>(in.c1.knots, in.c1.points(), j, in.t));
      equations.equal(curve_point<S, P>(surface.knots, surface.d_row(), k, in.t),
                      curve_point<S, P>(in.c2.knots, in.c2.points(), j, value));
    }
  }
};

}  // namespace torse::proofs::bzz19
