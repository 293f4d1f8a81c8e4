// FJ21 on splines with several pieces.
//   T3_2     Theorem 3.2, each piece with its own functions       K     knot insertion
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "torse/algebra/dependence.hpp"
#include "torse/proofs/claims/fj21/pair.hpp"

namespace torse::proofs::fj21 {

/// FJ21.T3.2 at one parameter: a spline whose pieces obey 3.5, each with its own Lam, M, sigma.
struct T3_2 {
  static constexpr PointKind points = PointKind::coplanar;
  static constexpr int dimension = 4;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "FJ21.T3.2",
        .source = "Theorem 3.2",
        .title = "characterisation of spline surfaces",
        .statement = R"(p[t^{<n-1>},\Lambda_k(t)]=\sigma_k(t)\,q[t^{<n-1>},M_k(t)]\iff
\operatorname{rank}(p_0^{n-1},p_1^{n-1},q_0^{n-1},q_1^{n-1})(t)\le 3\ \text{on piece } k,\ k=1..N)",
        .kind = Kind::equivalence,
        .hypotheses = {{"t is not the start of a piece", false},
                       {"no M_k is the start of piece k", false},
                       {"no sigma_k is 0", false}},
        .mutants = {"Lam_k and M_k exchanged", "1/sigma_k in the place of sigma_k",
                    "the functions of the first piece on all pieces", "the last vertex of q moved"},
        .remark =
            "The paper asks for one triple of rational functions on the whole spline. That is sufficient but not "
            "necessary: "
            "each piece has its own triple, and a developable spline may change it at any knot, as two planar cells of "
            "degree "
            "one show. The hypotheses only say that the last vertex of q in a piece can be found from the relation; "
            "the "
            "equivalence on a piece is Theorem 3.1 and needs what that needs."};
    return info;
  }

  template <class S, class P>
  struct In {
    KnotList<S> u;
    std::vector<P> p;
    std::vector<P> q;  ///< the last vertex of each proper piece is a placeholder
    S t;
    std::vector<BlossomFunctions<S>> f;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    KnotList<S> u(size.n, from.knots(size));
    std::vector<P> p = from.template points<P>(size.last() + 1);
    std::vector<P> q = from.template points<P>(size.last() + 1);
    S t = from.scalar();
    std::vector<BlossomFunctions<S>> f;
    for (int k = 1; k <= u.pieces(); ++k) f.push_back(draw_functions(from));
    return {std::move(u), std::move(p), std::move(q), std::move(t), std::move(f)};
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    NonZero<S> factors(3);
    for (int k = 1; k <= in.u.pieces(); ++k) {
      const BlossomFunctions<S>& f = in.f[static_cast<std::size_t>(k) - 1];
      if (in.u.degree() > 1) factors[0].push_back(in.t - in.u.piece_begin(k));
      factors[1].push_back(f.m - in.u.piece_begin(k));
      factors[2].push_back(f.sigma);
    }
    return factors;
  }

  /// The row q with the last vertex of each proper piece such that 3.5 holds on the piece at t.
  template <class S, class P>
  static std::vector<P> solve(const In<S, P>& in) {
    const auto& [u, p, placeholder, t, functions] = in;
    const int n = u.degree();
    std::vector<P> q = placeholder;
    for (int k : u.proper_pieces()) {
      const BlossomFunctions<S>& f = functions[static_cast<std::size_t>(k) - 1];
      const std::size_t last = static_cast<std::size_t>(k + n - 1);
      S weight = (f.m - u.piece_begin(k)) / (u[n + k - 1] - u.piece_begin(k));
      for (int j = 1; j < n; ++j) weight *= (t - u.piece_begin(k)) / (u[n + k - 1 + j] - u.piece_begin(k));
      q[last] = PointTraits<P>::zero();
      P rest = tangent_point<S, P>(u, p, k, t, at(f.lambda));
      divide(rest, f.sigma);
      subtract(rest, tangent_point<S, P>(u, q, k, t, at(f.m)));
      divide(rest, weight);
      q[last] = std::move(rest);
    }
    return q;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    std::vector<P> q = solve(in);
    if (mutant.is(4)) add(q.back(), in.p.front());
    for (int k : in.u.proper_pieces()) {
      BlossomFunctions<S> f = in.f[mutant.is(3) ? 0 : static_cast<std::size_t>(k) - 1];
      if (mutant.is(1)) std::swap(f.lambda, f.m);
      if (mutant.is(2)) f.sigma = from_int<S>(1) / f.sigma;
      equations.equal(tangent_point<S, P>(in.u, in.p, k, in.t, at(f.lambda)),
                      scaled(f.sigma, tangent_point<S, P>(in.u, q, k, in.t, at(f.m))));
      const auto [p0, p1] = last_pair<S, P>(in.u, in.p, k, in.t);
      const auto [q0, q1] = last_pair<S, P>(in.u, q, k, in.t);
      equations.zero(dependence_residual(std::array<P, 4>{p0, p1, q0, q1}));
    }
  }

  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const S zero = from_int<S>(0);
    const S one = from_int<S>(1);
    const S two = from_int<S>(2);
    const auto make = [&](const S& t, const S& m, const S& sigma) {
      In<S, P> in{bezier_knots<S>(2), {}, {}, t, {{two, m, sigma}}};
      const PairInput<S, P> pair = line_pair<S, P>(t, in.f[0]);
      in.p = {pair.p[0], pair.q[0], pair.p[1]};
      in.q = {pair.q[1], pair.p[0], pair.q[0]};
      return in;
    };
    return {{0, make(zero, two, one)}, {1, make(two, zero, one)}, {2, make(two, two, zero)}};
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
        .statement = R"(\hat p[t^{<n-1>},\Lambda]-\sigma\hat q[t^{<n-1>},M]=p[t^{<n-1>},\Lambda]-\sigma q[t^{<n-1>},M]
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
