// BZZ19, abstract and section 3.1: what an increasing mapping does not give.
//   Witnesses
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "torse/algebra/determinant.hpp"
#include "torse/developable/condition.hpp"
#include "torse/developable/special.hpp"
#include "torse/proofs/claims/bzz19/common.hpp"

namespace torse::proofs::bzz19 {

/// Refuted: 'an increasing mapping guarantees a surface without self-intersection'. Two exact counterexamples.
struct Witnesses {
  static constexpr PointKind points = PointKind::space;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "BZZ19.5.witnesses",
        .source = "sections 1 and 3.1, no self-intersections",
        .title = "refuted: an increasing sigma gives no simple, regular patch",
        .statement = R"(\sigma(t)=t:\ \text{(a) }C_1=(\tau^2-1,\tau^3-\tau,\tfrac{\tau+1}4),\ \tau=3t-\tfrac32,\
C_2=C_1+(0,0,1):\ S(\tfrac12,\tfrac16)=S(0,\tfrac56);\quad
\text{(b) }r=(\tau,\tau^2,\tau^3),\ \tau=2+t,\ C_1=r+r',\ C_2=r-r':\ S_s\times S_t=0\text{ at }s=\tfrac12)",
        .kind = Kind::example,
        .hypotheses = {},
        .mutants = {"(a) C2 = C1 + (0, 0, 1/3)", "(a) at t = 1/4 and 3/4", "(b) C2 = r - 2 r'"},
        .min_degree = 3,
        .max_degree = 3,
        .max_pieces = 1,
        .remark =
            "The paper says that the result is guaranteed to have no self-intersections as sigma increases; this "
            "is false. Both surfaces are exactly developable and their rails are regular and do not meet "
            "themselves or each other. (a) is a regular cylinder that goes through itself, (b) is cut along by its "
            "edge of regression although the rails run the same way. What an increasing sigma gives: the rulings "
            "leave both rails in the same order."};
    return info;
  }

  template <class S, class P>
  struct In {
    std::vector<P> loop;  ///< C1 of (a)
    P up;
    std::vector<P> edge;  ///< r of (b)
    std::vector<P> tangent;
  };

  /// The cubic with these coefficients of 1, t, t^2, t^3, in eighths.
  template <class S, class P>
  static std::vector<P> cubic(const std::array<std::array<std::int64_t, 3>, 4>& eighths) {
    std::vector<P> powers;
    for (const auto& row : eighths) {
      P x;
      for (int j = 0; j < 3; ++j) x[j] = ratio<S>(row[static_cast<std::size_t>(j)], 8);
      powers.push_back(std::move(x));
    }
    return from_powers<S, P>(powers, 3);
  }

  template <class S, class P>
  static In<S, P> draw(Source<S>&, Size) {
    P up;
    for (int j = 0; j < 3; ++j) up[j] = from_int<S>(j == 2 ? 1 : 0);
    return {cubic<S, P>({{{10, -15, -1}, {-72, 138, 6}, {72, -324, 0}, {0, 216, 0}}}), up,
            cubic<S, P>({{{16, 32, 64}, {8, 32, 96}, {0, 8, 48}, {0, 0, 8}}}),
            cubic<S, P>({{{8, 32, 96}, {0, 16, 96}, {0, 0, 24}, {0, 0, 0}}})};
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>&) {
    return {};
  }

  template <class S, class P>
  static void require_developable(const std::vector<P>& c, const std::vector<P>& d, Equations<S>& equations) {
    const BinaryForm<S> det = span_determinant<S>(bezier_knots<S>(3), c, d, 1);
    for (int i = 0; i <= det.degree(); ++i) equations.zero(det[i]);
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    crossing(in, mutant, equations);
    regression(in, mutant, equations);
  }

  /// (a): z increases along C1, which is regular in the plane too: |C1'|^2 - (3/4)^2 = (9 tau^2 - 1)^2 + 8.
  template <class S, class P>
  static void crossing(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const std::vector<S> same{from_int<S>(0), from_int<S>(1)};
    std::vector<P> row = in.loop;
    for (P& x : row) add_scaled(x, ratio<S>(1, mutant.is(1) ? 3 : 1), in.up);
    const std::vector<P> second = composed_points<S, P>(row, same);
    require_developable<S, P>(in.loop, second, equations);
    const S t = mutant.is(2) ? ratio<S>(1, 4) : ratio<S>(1, 6);
    const std::vector<P> middle = restrict_rulings<S, P>(in.loop, second, ratio<S>(1, 2));
    equations.equal(value(middle, t), value(in.loop, from_int<S>(1) - t));
    for (int i = 0; i <= 4; ++i) {  // a polynomial of degree 4
      const P slope = derivative(in.loop, from_int<S>(i));
      const S tau = from_int<S>(3 * i) - ratio<S>(3, 2);
      const S square = from_int<S>(9) * tau * tau - from_int<S>(1);
      equations.equal(slope[0] * slope[0] + slope[1] * slope[1], square * square + from_int<S>(8));
      equations.equal(slope[2], ratio<S>(3, 4));
    }
  }

  /// (b): the normal vanishes along s = 1/2; the tangents of the rails are less than a right angle apart.
  template <class S, class P>
  static void regression(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    std::vector<P> first = in.edge;
    std::vector<P> row = in.edge;
    for (std::size_t i = 0; i < row.size(); ++i) {
      add(first[i], in.tangent[i]);
      add_scaled(row[i], from_int<S>(mutant.is(3) ? -2 : -1), in.tangent[i]);
    }
    const std::vector<P> second = composed_points<S, P>(row, std::vector<S>{from_int<S>(0), from_int<S>(1)});
    require_developable<S, P>(first, second, equations);
    const std::vector<P> middle = restrict_rulings<S, P>(first, second, ratio<S>(1, 2));
    for (int i = 0; i <= 5; ++i) {  // the normal has degree 5
      const S t = from_int<S>(i);
      const P ruling = difference(value(second, t), value(first, t));
      equations.equal(cross<S>(derivative(middle, t), ruling), PointTraits<P>::zero());
    }
    Bernstein<S> product({from_int<S>(0)});
    for (int j = 0; j < 3; ++j) {
      std::vector<S> x;
      std::vector<S> y;
      for (const P& p : fj21::hodograph<S, P>(first)) x.push_back(p[j]);
      for (const P& p : fj21::hodograph<S, P>(second)) y.push_back(p[j]);
      product = product + Bernstein<S>(x) * Bernstein<S>(y);
    }
    for (const S& b : product.coefficients()) equations.positive(b);
  }
};

}  // namespace torse::proofs::bzz19
