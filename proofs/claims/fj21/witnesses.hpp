// FJ21, section 6: what Theorem 6.1 leaves out.
//   T6_1_witnesses     an exact rational example for each silent condition
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "torse/algebra/dependence.hpp"
#include "torse/proofs/claims/fj21/tangent_surface.hpp"

namespace torse::proofs::fj21 {

/// An exact rational example for each condition that Theorem 6.1 passes over in silence.
struct T6_1_witnesses {
  static constexpr PointKind points = PointKind::space;
  static constexpr int dimension = 4;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "FJ21.T6.1.witnesses",
        .source = "Theorem 6.1, its silent conditions",
        .title = "what Theorem 6.1 leaves out",
        .statement =
            R"(n=2,\ \Lambda=3,\
M=2:\ \text{(a) } r=(t+1)^3A;\ \text{(b) } r \text{ a line};\ \text{(c) } r \text{ planar};\
\text{(d) weight of } r=(t-2)^3;\ \text{(e) } \deg r=2;\ \text{(f) } r=t^3a+t^2b+\dots,\ b=-6a)",
        .kind = Kind::example,
        .hypotheses = {},
        .mutants = {"a point in the place of a curve is moved: (a)", "the line is bent: (b)", "the plane is left: (c)",
                    "the weight is moved: (d)", "the degree is raised: (e)", "b is moved: (f)"},
        .min_degree = 2,
        .max_degree = 2,
        .max_pieces = 1,
        .remark =
            "(a) p, q stay on one point; (b) all rulings are one line; (c) the surface is a plane; (d) p lies at "
            "infinity; (e) q - p "
            "has degree 1; (f) p has degree 1. In each the blossom relation holds with constant Lam != M and sigma = "
            "1."};
    return info;
  }

  template <class S, class P>
  struct In {
    std::vector<std::vector<P>> r;  ///< the cubics (a) to (f)
    S t;
  };

  /// The cubic with the given coordinates, each by its coefficients of 1, t, t^2, t^3.
  template <class S>
  static std::vector<Vec<S, 4>> cubic(const std::array<std::array<int, 4>, 4>& powers) {
    std::vector<Vec<S, 4>> rows(4);
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        S total = from_int<S>(0);
        for (int k = 0; k <= i; ++k) {
          const S weight = binomial<S>(i, k) / binomial<S>(3, k);
          total += weight * from_int<S>(powers[static_cast<std::size_t>(j)][static_cast<std::size_t>(k)]);
        }
        rows[static_cast<std::size_t>(i)][j] = total;
      }
    }
    return rows;
  }

  template <class S, class P>
  static In<S, P> draw(Source<S>&, Size) {
    return {{cubic<S>({{{1, 3, 3, 1}, {1, 3, 3, 1}, {2, 6, 6, 2}, {3, 9, 9, 3}}}),      // (t+1)^3 (1, 1, 2, 3)
             cubic<S>({{{1, 0, 1, 0}, {0, 1, 0, 1}, {0, 2, 0, 2}, {0, 0, 0, 0}}}),      // (1+t^2) (1, t, 2t, 0)
             cubic<S>({{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 1}, {0, 0, 0, 0}}}),      // (1, t, t^2+t^3, 0)
             cubic<S>({{{-8, 12, -6, 1}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}}),   // weight (t-2)^3
             cubic<S>({{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {1, 2, 3, 0}}}),      // degree 2
             cubic<S>({{{1, 0, 0, 0}, {0, 1, 0, 0}, {1, 1, -6, 1}, {0, 0, -12, 2}}})},  // b = -6 a
            ratio<S>(1, 3)};
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>&) {
    return {};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const S lambda = from_int<S>(3);
    const S m = from_int<S>(2);
    std::vector<std::vector<P>> p;
    std::vector<std::vector<P>> q;
    for (std::size_t i = 0; i < in.r.size(); ++i) {
      std::vector<P> r = in.r[i];
      if (mutant.is(static_cast<int>(i) + 1)) r.back()[i == 3 ? 0 : 3] += from_int<S>(1);
      p.push_back(edge_patch(r, m));
      q.push_back(edge_patch(r, lambda));
      equations.equal(tangent(p[i], in.t, lambda), tangent(q[i], in.t, m));
    }
    for (std::size_t i = 0; i < p[0].size(); ++i) {
      equations.zero(proportional_residual<S, 4>(p[0][i], q[0][i]));       // (a) one point
      equations.zero(proportional_residual<S, 4>(p[0][i], p[0].front()));  // (a)
      for (const P& row : {p[1][i], q[1][i]}) {
        equations.zero(std::vector<S>{row[2] - (row[1] + row[1]), row[3]});  // (b) one line
      }
      for (const P& row : {p[2][i], q[2][i]}) equations.zero(row[3]);  // (c) one plane
      equations.zero(p[3][i][0]);                                      // (d) at infinity
    }
    equations.equal(T6_1::leading(q[4]), T6_1::leading(p[4]));     // (e) q - p of degree 1
    equations.equal(T6_1::leading(p[5]), PointTraits<P>::zero());  // (f) p of degree 1
  }
};

}  // namespace torse::proofs::fj21
