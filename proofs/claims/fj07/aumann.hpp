// FJ07, section 3: Aumann's relation on one Bezier piece and on the pieces of a spline, equations (12), (19),
// Corollary 1.
//   Eq12, Corollary1, Eq19
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "torse/developable/linear_net.hpp"
#include "torse/developable/pieces.hpp"
#include "torse/proofs/claims/fj07/common.hpp"

namespace torse::proofs::fj07 {

/// One Bezier piece on [0, 1] by Aumann's relation.
template <class S, class P>
struct AumannInput {
  std::vector<P> c;
  P d0;
  S lambda;
  S m;
  S t;

  static AumannInput draw(Source<S>& from, Size size);
};

inline constexpr Hypothesis m_not_zero{"M is not 0: the relation then leaves D_{i+1} undetermined", false};

template <class S, class P>
AumannInput<S, P> AumannInput<S, P>::draw(Source<S>& from, Size size) {
  std::vector<P> c = from.template points<P>(size.n + 1);
  P d0 = from.template point<P>();
  S lambda = from.scalar();
  S m = from.scalar();
  return {std::move(c), std::move(d0), std::move(lambda), std::move(m), from.scalar()};
}

/// Hypothesis and failure of the claims on one Bezier piece.
struct AumannClaim : Takes<AumannInput> {
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return {{in.m}};
  }
  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const NetInput<S, P> net = example_net<S, P>(0);
    return {{0, {net.c, net.d0, net.lambda, net.m, from_int<S>(4)}}};
  }
};

/// FJ07.12: Aumann's relation from blossoms.
struct Eq12 : AumannClaim {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo value{
        .id = "FJ07.12",
        .source = "equation (12)",
        .title = "Aumann's relation",
        .statement = R"($(1-\Lambda)C_i+\Lambda C_{i+1}=(1-M)D_i+MD_{i+1}$, $i=0..n-1$, is
$c[0^{\langle n-1-i\rangle},1^{\langle i\rangle},\Lambda]=d[0^{\langle n-1-i\rangle},1^{\langle i\rangle},M]$, and
$D_{i+1}=(1-\lambda-\mu)C_i+\lambda C_{i+1}+\mu D_i$ with $\lambda=\Lambda/M$, $\mu=1-1/M$.)",
        .kind = Kind::identity,
        .hypotheses = {m_not_zero},
        .mutants = {"Lam and M exchanged", "lam and mu exchanged", "1 - Lam in the place of Lam"},
        .max_pieces = 1};
    return value;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const S one = from_int<S>(1);
    const int n = static_cast<int>(in.c.size()) - 1;
    const KnotList<S> u = bezier_knots<S>(n);
    const std::vector<P> d = aumann_net<S, P>(in.c, in.lambda, in.m, in.d0);
    S lambda = mutant.is(3) ? one - in.lambda : in.lambda;
    S m = in.m;
    if (mutant.is(1)) std::swap(lambda, m);
    AffineCell<S> cell = affine_from_local(in.lambda, in.m);
    if (mutant.is(2)) std::swap(cell.lam, cell.mu);
    for (int i = 0; i < n; ++i) {
      const std::size_t at_i = static_cast<std::size_t>(i);
      std::vector<Parameter<S>> arguments = repeated(at(from_int<S>(0)), n - 1 - i);
      arguments.insert(arguments.end(), at_i, at(one));
      arguments.push_back(at(lambda));
      const P on_c = blossom<S, P>(u, in.c, 1, arguments);
      arguments.back() = at(m);
      equations.equal(on_c, blossom<S, P>(u, d, 1, arguments));
      P vertex = combine(one - cell.lam - cell.mu, in.c[at_i], cell.lam, in.c[at_i + 1]);
      add_scaled(vertex, cell.mu, d[at_i]);
      equations.equal(d[at_i + 1], vertex);
    }
  }
};

/// FJ07.C1: cells with one barycentric combination make a developable Bezier surface.
struct Corollary1 : AumannClaim {
  static constexpr PointKind points = PointKind::coplanar;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo value{
        .id = "FJ07.C1",
        .source = "Corollary 1",
        .title = "developable Bezier surfaces by cells",
        .statement =
            R"(The net of (12) has plane cells and spans a developable surface; for $\Lambda=M$ it is a cylinder
with $D_i-C_i=(1-1/M)^i(D_0-C_0)$.)",
        .kind = Kind::identity,
        .hypotheses = {m_not_zero},
        .mutants = {"the last vertex moved", "Lam of the first cell changed", "rulings of the cylinder all equal"},
        .max_pieces = 1,
        .remark =
            "Plane cells alone do not suffice, nor does every developable surface have them with one combination. For "
            "cones the paper prints Lam as the ratio of the sides; the ratio is alpha of (6)."};
    return value;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [c, d0, lambda, m, t] = in;
    std::vector<P> d = aumann_net<S, P>(c, lambda, m, d0);
    if (mutant.is(1)) add(d.back(), difference(d.back(), c.front()));
    if (mutant.is(2)) d.front() = combine(from_int<S>(3), d.front(), from_int<S>(-2), c.front());
    for (std::size_t i = 0; i + 1 < c.size(); ++i) {
      equations.zero(dependence_residual(std::array<P, 4>{c[i], c[i + 1], d[i], d[i + 1]}));
    }
    require_coplanar<S, P>(bezier_knots<S>(static_cast<int>(c.size()) - 1), c, d, t, equations);

    const std::vector<P> cylinder = aumann_net<S, P>(c, m, m, d0);
    const P first = difference(d0, c.front());
    S power = from_int<S>(1);
    for (std::size_t i = 0; i < c.size(); ++i) {
      equations.equal(difference(cylinder[i], c[i]), scaled(power, first));
      if (!mutant.is(3)) power *= (m - from_int<S>(1)) / m;
    }
  }
};

/// FJ07.19: the Bezier nets of the pieces of a developable spline.
struct Eq19 : NetClaim {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo value{
        .id = "FJ07.19",
        .source = "equation (19)",
        .title = "the pieces obey Aumann's relation with Lam_k, M_k",
        .statement = R"(The Bezier net of piece $k$ of the spline of (13) obeys
$(1-\Lambda_k)C_i+\Lambda_kC_{i+1}=(1-M_k)D_i+M_kD_{i+1}$, and the pieces built one after the other by (10) and (12) are
the pieces of that spline.)",
        .kind = Kind::identity,
        .hypotheses = {off_before_last, off_from_last},
        .mutants = {"Lam_k and M_k exchanged", "Lam_k of the whole domain", "pieces started at D_1"}};
    return value;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, c, d0, lambda, m] = in;
    const S one = from_int<S>(1);
    const std::vector<P> d = linear_net<S, P>(u, c, lambda, m, d0);
    const std::vector<int> pieces = u.proper_pieces();
    const std::vector<P> first = bezier_points<S, P>(u, d, pieces.front());
    const auto rows = piecewise_net<S, P>(u, c, lambda, m, mutant.is(3) ? first[1] : first[0]);
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      const int k = pieces[p];
      const std::vector<P> c_k = bezier_points<S, P>(u, c, k);
      const std::vector<P> d_k = bezier_points<S, P>(u, d, k);
      equations.equal(d_k, rows[p]);
      const S length = u.piece_end(k) - u.piece_begin(k);
      S lambda_k = (lambda - u.piece_begin(k)) / length;
      S m_k = (m - u.piece_begin(k)) / length;
      if (mutant.is(1)) std::swap(lambda_k, m_k);
      if (mutant.is(2)) lambda_k = (lambda - u[0]) / (u.domain_end() - u[0] + one);
      for (std::size_t i = 0; i + 1 < c_k.size(); ++i) {
        equations.equal(combine(one - lambda_k, c_k[i], lambda_k, c_k[i + 1]),
                        combine(one - m_k, d_k[i], m_k, d_k[i + 1]));
      }
    }
  }
};

}  // namespace torse::proofs::fj07
