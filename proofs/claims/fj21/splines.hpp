// FJ21 on splines with several pieces.
//   T3_2     Theorem 3.2, each piece with its own functions       T3_2_pieces     an example of that
//   K        knot insertion
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "torse/algebra/dependence.hpp"
#include "torse/developable/condition.hpp"
#include "torse/developable/recovery.hpp"
#include "torse/proofs/claims/fj21/characterisation.hpp"
#include "torse/proofs/claims/fj21/pair.hpp"

namespace torse::proofs::fj21 {

/// FJ21.T3.2 on every piece at one parameter: vertices with any dependence there obey 3.5 with the piece's own Lam, M,
/// sigma, and vertices that obey 3.5 are dependent.
struct T3_2 {
  static constexpr PointKind points = PointKind::coplanar;
  static constexpr int dimension = 4;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "FJ21.T3.2",
        .source = "Theorem 3.2",
        .title = "characterisation of spline surfaces",
        .statement = R"(p[t^{\langle n-1\rangle},\Lambda_k(t)]=\sigma_k(t)\,q[t^{\langle n-1\rangle},M_k(t)]\iff
\operatorname{rank}(p_0^{n-1},p_1^{n-1},q_0^{n-1},q_1^{n-1})(t)\le 3\ \text{on piece } k,\ k=1..N)",
        .kind = Kind::equivalence,
        .hypotheses = {{"the dependence on each piece has lambda_0 + lambda_1 not 0", true},
                       {"the dependence on each piece has mu_0 + mu_1 not 0", false}},
        .mutants = {"Lam_k and M_k exchanged", "1/sigma_k in the place of sigma_k",
                    "the functions of the first piece on all pieces", "a vertex of q moved"},
        .remark =
            "The paper asks for one triple of rational functions on the whole spline. That is sufficient but not "
            "necessary: each piece has its own triple, and a developable spline may change it at a knot, see "
            "FJ21.T3.2.pieces."};
    return info;
  }

  /// The part of a spline surface that one piece sees.
  template <class S, class P>
  struct Piece {
    std::vector<P> p;
    std::vector<P> q;
    Coefficients<S> k;
  };

  template <class S, class P>
  struct In {
    KnotList<S> u;
    S t;
    std::vector<Piece<S, P>> pieces;
  };

  /// The row c_0..c_L in which the n + 1 vertices of piece k belong to the curve with the given Bezier rows on [t,
  /// t+1].
  template <class S, class P>
  static std::vector<P> vertices(const KnotList<S>& u, int k, const std::vector<P>& local, const S& t) {
    const int n = u.degree();
    const KnotList<S> at_t = bezier_knots(n, t, t + from_int<S>(1));
    std::vector<P> row(static_cast<std::size_t>(u.last()) + 1, PointTraits<P>::zero());
    for (int i = k - 1; i < k + n; ++i) {
      std::vector<Parameter<S>> arguments;
      for (int j = i; j < i + n; ++j) arguments.push_back(at(u[j]));
      row[static_cast<std::size_t>(i)] = blossom<S, P>(at_t, local, 1, arguments);
    }
    return row;
  }

  template <class S, class P>
  static In<S, P> build(KnotList<S> u, const S& t, std::vector<Piece<S, P>> pieces, const std::vector<P>& z) {
    for (int k = 1; k <= u.pieces(); ++k) {
      auto& [p, q, coefficients] = pieces[static_cast<std::size_t>(k) - 1];
      make_dependent(p, q, t, coefficients, z[static_cast<std::size_t>(k) - 1]);
      p = vertices(u, k, p, t);
      q = vertices(u, k, q, t);
    }
    return {std::move(u), t, std::move(pieces)};
  }

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    KnotList<S> u(size.n, from.knots(size));
    const S t = from.scalar();
    std::vector<Piece<S, P>> pieces;
    for (int k = 1; k <= u.pieces(); ++k) {
      std::vector<P> p = from.template points<P>(size.n + 1);
      std::vector<P> q = from.template points<P>(size.n + 1);
      pieces.push_back({std::move(p), std::move(q), draw_coefficients(from)});
    }
    return build<S, P>(std::move(u), t, std::move(pieces), from.template points<P>(size.pieces));
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    NonZero<S> factors(2);
    for (const Piece<S, P>& piece : in.pieces) {
      factors[0].push_back(piece.k.l0 + piece.k.l1);
      factors[1].push_back(piece.k.m0 + piece.k.m1);
    }
    return factors;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    for (int k : in.u.proper_pieces()) {
      const auto& [p, q_row, coefficients] = in.pieces[static_cast<std::size_t>(k) - 1];
      std::vector<P> q = q_row;
      if (mutant.is(4)) add(q[static_cast<std::size_t>(k) - 1], p[static_cast<std::size_t>(k)]);
      BlossomFunctions<S> f = mutant.is(3) ? in.pieces.front().k.functions() : coefficients.functions();
      if (mutant.is(1)) std::swap(f.lambda, f.m);
      if (mutant.is(2)) f.sigma = from_int<S>(1) / f.sigma;
      equations.equal(tangent_point<S, P>(in.u, p, k, in.t, at(f.lambda)),
                      scaled(f.sigma, tangent_point<S, P>(in.u, q, k, in.t, at(f.m))));
      const auto [p0, p1] = last_pair<S, P>(in.u, p, k, in.t);
      const auto [q0, q1] = last_pair<S, P>(in.u, q, k, in.t);
      equations.zero(dependence_residual(std::array<P, 4>{p0, p1, q0, q1}));
    }
  }

  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const S one = from_int<S>(1);
    const S third = ratio<S>(1, 3);
    const PairInput<S, P> pair = line_pair<S, P>(third, {one, one, one});
    const auto make = [&](const Coefficients<S>& k) {
      return build<S, P>(bezier_knots<S>(1), third, {{pair.p, pair.q, k}}, {pair.p[0]});
    };
    return {{0, make({one, -one, one, one})}, {1, make({one, one, one, -one})}};
  }
};

/// A developable spline of degree one whose two cells have different Lam, M, sigma.
struct T3_2_pieces {
  static constexpr PointKind points = PointKind::space;
  static constexpr int dimension = 4;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "FJ21.T3.2.pieces",
        .source = "Theorem 3.2, read with one triple of functions",
        .title = "Lam, M, sigma may change at a knot",
        .statement =
            R"(n=1,\ N=2,\ u=(0,1,2):\quad(\Lambda_1,M_1,\sigma_1)=(3,5,2),\ (\Lambda_2,M_2,\sigma_2)=(4,-1,1))",
        .kind = Kind::example,
        .hypotheses = {},
        .mutants = {"the second cell left its plane", "the first cell left its plane", "one triple on both cells"},
        .max_degree = 1,
        .max_pieces = 2,
        .remark =
            "Both determinants vanish, so the surface is developable on both pieces, and each cell determines its "
            "own triple. Degree one is the simplest instance; with n-fold knots the same happens in every degree."};
    return info;
  }

  template <class S, class P>
  struct In {
    KnotList<S> u;
    std::vector<P> p;
    std::vector<P> q;
    std::vector<BlossomFunctions<S>> f;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>&, Size) {
    const auto number = [](int i) { return from_int<S>(i); };
    const auto row = [&](int w, int x, int y, int z) { return P(number(w), number(x), number(y), number(z)); };
    In<S, P> in{KnotList<S>(1, {number(0), number(1), number(2)}),
                {row(1, 0, 0, 0), row(1, 1, 0, 2), row(2, 3, 1, 0)},
                {row(1, 0, 1, 1)},
                {{number(3), number(5), number(2)}, {number(4), number(-1), number(1)}}};
    for (int i = 0; i < 2; ++i) {
      const std::size_t cell = static_cast<std::size_t>(i);
      const auto& [lambda, m, sigma] = in.f[cell];
      P next = combine(in.u[i + 1] - lambda, in.p[cell], lambda - in.u[i], in.p[cell + 1]);
      divide(next, sigma);
      add_scaled(next, m - in.u[i + 1], in.q[cell]);
      divide(next, m - in.u[i]);
      in.q.push_back(std::move(next));
    }
    return in;
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>&) {
    return {};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    std::vector<P> q = in.q;
    if (mutant.is(1)) q[2][3] += from_int<S>(1);
    if (mutant.is(2)) q[0][3] += from_int<S>(1);
    for (int i = 0; i < 2; ++i) {
      equations.zero(span_determinant<S>(in.u, std::span<const P>(in.p), std::span<const P>(q), i + 1)[0]);
      const BlossomFunctions<S>& printed = in.f[mutant.is(3) ? 0 : static_cast<std::size_t>(i)];
      const BlossomFunctions<S> found = cell_functions<S>(in.u, in.p, q, i);
      equations.equal(found.lambda, printed.lambda);
      equations.equal(found.m, printed.m);
      equations.equal(found.sigma, printed.sigma);
    }
  }
};

/// FJ21.K: the blossom relation is the same before and after knot insertion, on every piece.
struct K {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 4;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "FJ21.K",
        .source = "section 5, knot insertion",
        .title = "knot insertion leaves Lam, M, sigma unchanged",
        .statement =
            R"(\hat p[t^{\langle n-1\rangle},\Lambda]-\sigma\hat q[t^{\langle n-1\rangle},M]
=p[t^{\langle n-1\rangle},\Lambda]-\sigma q[t^{\langle n-1\rangle},M]
\ \text{ on every piece of the refined knot list})",
        .hypotheses = {{"x + y is not 0: the new knot (x a + y b)/(x + y) exists", false}},
        .mutants = {"the new knot one vertex too early", "the vertices of the old net at the new knots",
                    "the mean in the place of the affine step"},
        .remark =
            "For any number of pieces, repeated knots included, inside any proper piece. In the modular and symbolic "
            "arithmetics "
            "the new knot is any number."};
    return info;
  }

  template <class S, class P>
  struct In {
    KnotList<S> u;
    std::vector<P> p;
    std::vector<P> q;
    S t;
    BlossomFunctions<S> f;
    S x;
    S y;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    KnotList<S> u(size.n, from.knots(size));
    std::vector<P> p = from.template points<P>(size.last() + 1);
    std::vector<P> q = from.template points<P>(size.last() + 1);
    S t = from.scalar();
    BlossomFunctions<S> f = draw_functions(from);
    S x = from.positive();
    return {std::move(u), std::move(p), std::move(q), std::move(t), std::move(f), std::move(x), from.positive()};
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return {{in.x + in.y}};
  }

  template <class S, class P>
  static Spline<S, P> refined(const KnotList<S>& u, const std::vector<P>& row, const S& knot, int interval,
                              Mutant mutant) {
    Spline<S, P> finer = insert_knot(Spline<S, P>(u, row), knot, interval);
    if (mutant.is(1)) std::swap(finer.control[finer.control.size() - 2], finer.control.back());
    if (mutant.is(2)) finer.control[static_cast<std::size_t>(interval) + 1] = row[static_cast<std::size_t>(interval)];
    if (mutant.is(3)) {
      const std::size_t at = static_cast<std::size_t>(interval) + 1;
      finer.control[at] = combine(from_int<S>(2), row[at - 1], from_int<S>(-1), row[at]);
    }
    return finer;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, p, q, t, f, x, y] = in;
    const std::vector<int> pieces = u.proper_pieces();
    const int split = pieces[pieces.size() / 2];
    const S knot = (x * u.piece_begin(split) + y * u.piece_end(split)) / (x + y);
    const int interval = u.degree() + split - 2;
    const Spline<S, P> p_finer = refined(u, p, knot, interval, mutant);
    const Spline<S, P> q_finer = refined(u, q, knot, interval, mutant);
    for (int k : pieces) {
      P before = tangent_point<S, P>(u, p, k, t, at(f.lambda));
      add_scaled(before, -f.sigma, tangent_point<S, P>(u, q, k, t, at(f.m)));
      for (int piece : {k, k + 1}) {  // after the insertion piece k is piece k, k + 1 or, if it is split, both
        if ((k < split && piece != k) || (k > split && piece == k)) continue;
        P after = tangent_point<S, P>(p_finer.knots, p_finer.points(), piece, t, at(f.lambda));
        add_scaled(after, -f.sigma, tangent_point<S, P>(q_finer.knots, q_finer.points(), piece, t, at(f.m)));
        equations.equal(after, before);
      }
    }
  }

  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const S one = from_int<S>(1);
    const PairInput<S, P> pair = line_pair<S, P>(one, {one, one, one});
    return {{0, {bezier_knots<S>(1), pair.p, pair.q, one, pair.f, one, -one}}};
  }
};

}  // namespace torse::proofs::fj21
