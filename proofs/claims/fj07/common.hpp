// What the claims of FJ07 share.
//   before_last, from_last   the hypothesis that M* is none of the knots, in two parts
//   require_coplanar         the surface is developable at a parameter of every piece
//   RuledJets                two curves given by their Taylor expansions at one parameter
//   example_knots, example_points, example_net      fixed inputs for the failures without a hypothesis
//   NetClaim, NetClaimAt     inputs, hypotheses and failures of claims about the net of (13)
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <utility>
#include <vector>

#include "torse/algebra/bernstein.hpp"
#include "torse/algebra/dependence.hpp"
#include "torse/proofs/inputs.hpp"
#include "torse/spline/blossom.hpp"

namespace torse::proofs::fj07 {

inline constexpr Hypothesis off_before_last{
    "M* is none of the knots u_0, ..., u_{L-1}: the recursion divides by M* - u_i", false};
inline constexpr Hypothesis off_from_last{
    "M* is none of the knots u_L, ..., u_{L+n-1}: the formulas hold there, but d forgets d_0 and the library refuses",
    false};

/// x - u_i for i < L.
template <class S>
std::vector<S> before_last(const KnotList<S>& u, const S& x) {
  std::vector<S> factors;
  for (int i = 0; i < u.last(); ++i) factors.push_back(x - u[i]);
  return factors;
}

/// x - u_i for i >= L.
template <class S>
std::vector<S> from_last(const KnotList<S>& u, const S& x) {
  std::vector<S> factors;
  for (int i = u.last(); i < u.size(); ++i) factors.push_back(x - u[i]);
  return factors;
}

/// Asserts that the surface between c and d is developable at the parameter t of every proper piece: its last but one
/// points of de Boor's algorithm are coplanar.
template <class S, class P>
void require_coplanar(const KnotList<S>& u, const std::vector<P>& c, const std::vector<P>& d, const S& t,
                      Equations<S>& equations) {
  for (int k : u.proper_pieces()) {
    const auto [c0, c1] = last_pair<S, P>(u, c, k, t);
    const auto [d0, d1] = last_pair<S, P>(u, d, k, t);
    equations.zero(dependence_residual(std::array<P, 4>{c0, c1, d0, d1}));
  }
}

/// The curves c and d on one piece by their Taylor coefficients at t, as free as their control points: c(t) =
/// c_taylor[0], c'(t) = c_taylor[1]. Nets that start from jets keep determinants of derivatives small for
/// indeterminates.
template <class S, class P>
struct RuledJets {
  KnotList<S> u;
  int piece;
  S t;
  std::vector<P> c_taylor;
  std::vector<P> d_taylor;
  std::vector<P> c;
  std::vector<P> d;
};

/// The control points of sum_j a_j (x - t)^j on piece k: c_i = sum_j a_j e_j(u_i - t, ..., u_{i+n-1} - t) / C(n, j)
/// with the elementary symmetric polynomials e_j. The points of other pieces are zero.
template <class S, class P>
std::vector<P> taylor_net(const KnotList<S>& u, int piece, const S& t, const std::vector<P>& a) {
  const int n = u.degree();
  std::vector<P> row(static_cast<std::size_t>(u.last()) + 1, PointTraits<P>::zero());
  for (int i = piece - 1; i <= piece + n - 1; ++i) {
    std::vector<S> e{from_int<S>(1)};
    for (int j = i; j < i + n; ++j) {
      e.push_back(from_int<S>(0));
      for (std::size_t r = e.size() - 1; r > 0; --r) e[r] += (u[j] - t) * e[r - 1];
    }
    for (int j = 0; j <= n; ++j) {
      const std::size_t at_j = static_cast<std::size_t>(j);
      add_scaled(row[static_cast<std::size_t>(i)], e[at_j] / binomial<S>(n, j), a[at_j]);
    }
  }
  return row;
}

template <class S, class P>
RuledJets<S, P> draw_jets(Source<S>& from, Size size) {
  KnotList<S> u(size.n, from.knots(size));
  const std::vector<int> pieces = u.proper_pieces();
  const int piece = pieces[pieces.size() / 2];
  S t = from.scalar();
  std::vector<P> c_taylor = from.template points<P>(size.n + 1);
  std::vector<P> d_taylor = from.template points<P>(size.n + 1);
  std::vector<P> c = taylor_net(u, piece, t, c_taylor);
  std::vector<P> d = taylor_net(u, piece, t, d_taylor);
  return {std::move(u), piece, std::move(t), std::move(c_taylor), std::move(d_taylor), std::move(c), std::move(d)};
}

template <class S>
KnotList<S> example_knots(int degree, std::initializer_list<std::int64_t> list) {
  std::vector<S> u;
  for (std::int64_t knot : list) u.push_back(from_int<S>(knot));
  return KnotList<S>(degree, std::move(u));
}

/// Points in general position: generators, or points of the moment curve (x, x^2, x^3, ...) at x = first + 1, first +
/// 2, ...
template <class S, class P>
std::vector<P> example_points(int count, int first = 0) {
  std::vector<P> row;
  for (int i = first; i < first + count; ++i) {
    if constexpr (requires { P::generator(0); }) {
      row.push_back(P::generator(i));
    } else {
      P point;
      S power = from_int<S>(1);
      for (int j = 0; j < static_cast<int>(point.size()); ++j) point[j] = power *= from_int<S>(i + 1);
      row.push_back(std::move(point));
    }
  }
  return row;
}

/// A quadratic net of one piece over the knots 0, 1, 2, 3 with L* = 7.
template <class S, class P>
NetInput<S, P> example_net(std::int64_t m) {
  std::vector<P> points = example_points<S, P>(4);
  P d0 = points.back();
  points.pop_back();
  return {example_knots<S>(2, {0, 1, 2, 3}), std::move(points), std::move(d0), from_int<S>(7), from_int<S>(m)};
}

/// Inputs, hypotheses and failures (M* at the knot u_1, at the knot u_L) of a claim about the net of (13).
struct NetClaim : Takes<NetInput> {
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return {before_last(in.u, in.m), from_last(in.u, in.m)};
  }
  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    return {{0, example_net<S, P>(1)}, {1, example_net<S, P>(2)}};
  }
};

/// A net and a parameter.
template <class S, class P>
struct NetAtInput {
  NetInput<S, P> net;
  S t;

  static NetAtInput draw(Source<S>& from, Size size);
};

template <class S, class P>
NetAtInput<S, P> NetAtInput<S, P>::draw(Source<S>& from, Size size) {
  NetInput<S, P> net = NetInput<S, P>::draw(from, size);
  return {std::move(net), from.scalar()};
}

/// The same of a claim about that net at a parameter.
struct NetClaimAt : Takes<NetAtInput> {
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    return NetClaim::nonzero<S, P>(in.net);
  }
  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    std::vector<Failure<In<S, P>>> list;
    for (Failure<NetInput<S, P>>& failure : NetClaim::failures<S, P>()) {
      list.push_back({failure.hypothesis, {std::move(failure.in), from_int<S>(4)}});
    }
    return list;
  }
};

}  // namespace torse::proofs::fj07
