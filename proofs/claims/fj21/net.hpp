// FJ21, section 7: nets with constant Lam, M, sigma.
//   Eq7_1     the construction, its cells and the polarised relation, with knots
#pragma once

#include <utility>
#include <vector>

#include "torse/algebra/dependence.hpp"
#include "torse/developable/linear_net.hpp"
#include "torse/proofs/claims/fj21/pair.hpp"
#include "torse/proofs/inputs.hpp"

namespace torse::proofs::fj21 {

/// FJ21.7.1: the net through p and q_0 obeys the relation cell by cell, on the diagonal and, polarised, everywhere.
struct Eq7_1 {
  static constexpr PointKind points = PointKind::coplanar;
  static constexpr int dimension = 4;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "FJ21.7.1",
        .source = "equation (7.1)",
        .title = "the net for constant Lam, M, sigma",
        .statement = R"((u_{j+n}-\Lambda)p_j+(\Lambda-u_j)p_{j+1}=\sigma\bigl((u_{j+n}-M)q_j+(M-u_j)q_{j+1}\bigr)\iff
p[t_1,\dots,t_{n-1},\Lambda]=\sigma q[t_1,\dots,t_{n-1},M]\iff
p[t^{\langle n-1\rangle},\Lambda]=\sigma q[t^{\langle n-1\rangle},M],\quad
(n-1)!\,F[t_1,\dots,t_{n-1}]=\sum_{S}(-1)^{n-1-|S|}F\bigl[(\textstyle\sum_{i\in S}t_i:|S|)^{\langle n-1\rangle}\bigr])",
        .kind = Kind::equivalence,
        .hypotheses = {{"M is not a knot (on [0, 1]: not 0 or 1)", false}, {"sigma is not 0", false}},
        .mutants = {"Lam and M exchanged", "1/sigma in the place of sigma", "the last vertex of q moved",
                    "the factor (n-1)! left out of one term"},
        .max_degree = 8,
        .remark =
            "For M = u_j, j < L, the vertex q_{j+1} is not determined by the relation; for a later knot q forgets q_0. "
            "The same "
            "cells, with the knots of the list, hold on splines with any number of pieces. The polarised sum is "
            "evaluated for n <= 6."};
    return info;
  }

  template <class S, class P>
  struct In {
    KnotList<S> u;
    std::vector<P> p;
    P start;
    BlossomFunctions<S> f;
    std::vector<S> t;  ///< n-1 arguments
    S diagonal;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    KnotList<S> u(size.n, from.knots(size));
    std::vector<P> p = from.template points<P>(size.last() + 1);
    P start = from.template point<P>();
    BlossomFunctions<S> f = draw_functions(from);
    std::vector<S> t;
    for (int i = 1; i < size.n; ++i) t.push_back(from.scalar());
    return {std::move(u), std::move(p), std::move(start), std::move(f), std::move(t), from.scalar()};
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return {off_knots(in.u, in.f.m), {in.f.sigma}};
  }

  /// The sum has 2^{n-1} terms: it is left out above this degree.
  static constexpr int polarised_degrees = 6;

  /// (n-1)! rows[t_1, ..., t_{n-1}, x] on piece k from diagonal values alone.
  template <class S, class P>
  static P polarised(const In<S, P>& in, const std::vector<P>& rows, int k, const S& x, Mutant mutant) {
    const int order = in.u.degree() - 1;
    P total = PointTraits<P>::zero();
    for (unsigned subset = order == 0 ? 0 : 1; subset < 1U << order; ++subset) {
      Parameter<S> mean{from_int<S>(0), from_int<S>(0)};
      int size = 0;
      for (int i = 0; i < order; ++i) {
        if ((subset >> i & 1U) == 0) continue;
        mean.a += in.t[static_cast<std::size_t>(i)];
        ++size;
      }
      mean.w = from_int<S>(size);
      std::vector<Parameter<S>> arguments = repeated(mean, order);
      arguments.push_back(at(x));
      const bool twice = mutant.is(4) && size == order;
      const int sign = (order - size) % 2 == 0 ? 1 : -1;
      add_scaled(total, from_int<S>(twice ? 2 * sign : sign), blossom<S, P>(in.u, rows, k, arguments));
    }
    return total;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, p, start, f, t, diagonal] = in;
    const S sigma = mutant.is(2) ? from_int<S>(1) / f.sigma : f.sigma;
    std::vector<P> q = mutant.is(1) ? rational_net<S, P>(u, p, f.m, f.lambda, f.sigma, start)
                                    : rational_net<S, P>(u, p, f.lambda, f.m, f.sigma, start);
    if (mutant.is(3)) add(q.back(), p.front());
    const int n = u.degree();
    for (int j = 0; j < u.last(); ++j) {
      const std::size_t at_j = static_cast<std::size_t>(j);
      equations.equal(combine(u[j + n] - f.lambda, p[at_j], f.lambda - u[j], p[at_j + 1]),
                      scaled(sigma, combine(u[j + n] - f.m, q[at_j], f.m - u[j], q[at_j + 1])));
    }
    S factorial = from_int<S>(1);
    for (int i = 2; i < n; ++i) factorial *= from_int<S>(i);
    const std::vector<int> pieces = u.proper_pieces();
    for (int k : pieces) {
      std::vector<Parameter<S>> arguments;
      for (const S& argument : t) arguments.push_back(at(argument));
      arguments.push_back(at(f.lambda));
      const P left = blossom<S, P>(u, p, k, arguments);
      arguments.back() = at(f.m);
      equations.equal(left, scaled(sigma, blossom<S, P>(u, q, k, arguments)));
      if (k == pieces.front() && n <= polarised_degrees) {
        equations.equal(scaled(factorial, left), scaled(sigma, polarised(in, q, k, f.m, mutant)));
      }
      equations.equal(tangent_point<S, P>(u, p, k, diagonal, at(f.lambda)),
                      scaled(sigma, tangent_point<S, P>(u, q, k, diagonal, at(f.m))));
      const auto [p0, p1] = last_pair<S, P>(u, p, k, diagonal);
      const auto [q0, q1] = last_pair<S, P>(u, q, k, diagonal);
      equations.zero(dependence_residual(std::array<P, 4>{p0, p1, q0, q1}));
    }
  }

  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    const S zero = from_int<S>(0);
    const S one = from_int<S>(1);
    const S two = from_int<S>(2);
    const PairInput<S, P> pair = line_pair<S, P>(one, {one, one, one});
    const KnotList<S> u = bezier_knots<S>(1);
    return {{0, {u, pair.p, pair.q[0], {two, zero, one}, {}, one}},
            {0, {u, pair.p, pair.q[0], {two, one, one}, {}, one}},
            {1, {u, pair.p, pair.q[0], {two, two, zero}, {}, one}}};
  }
};

}  // namespace torse::proofs::fj21
