// What the claims of BZZ19 share.
//   from_powers, powers_of     Bezier points from coefficients of 1, t, t^2, ... and back (BZZ19.14)
//   PieceInput                 Bezier rows of the rails, a piece of the mapping in C2's coordinate, a parameter
//   mapped                     sigma(t) of such a piece        first_row, second_row    the rows of the surface
#pragma once

#include <utility>
#include <vector>

#include "torse/proofs/claims/fj07/common.hpp"
#include "torse/proofs/claims/fj21/pair.hpp"
#include "torse/quasi/surface.hpp"

namespace torse::proofs::bzz19 {

using fj21::bernstein_sum;
using fj21::degree_of;
using fj21::derivative;
using fj21::value;

/// b_i = sum_k C(i, k) / C(D, k) f_k, i = 0..D (BZZ19.14).
template <class S, class P>
std::vector<P> from_powers(const std::vector<P>& f, int degree) {
  std::vector<P> row;
  for (int i = 0; i <= degree; ++i) {
    P total = PointTraits<P>::zero();
    for (int k = 0; k <= i && k <= degree_of(f); ++k) {
      add_scaled(total, binomial<S>(i, k) / binomial<S>(degree, k), f[static_cast<std::size_t>(k)]);
    }
    row.push_back(std::move(total));
  }
  return row;
}

/// f_k = C(p, k) sum_j (-1)^{k-j} C(k, j) b_j: the coefficients of 1, t, t^2, ... of a Bezier curve.
template <class S, class P>
std::vector<P> powers_of(const std::vector<P>& b) {
  std::vector<P> f;
  for (int k = 0; k <= degree_of(b); ++k) {
    P total = PointTraits<P>::zero();
    for (int j = 0; j <= k; ++j) {
      const S sign = from_int<S>((k - j) % 2 == 0 ? 1 : -1);
      add_scaled(total, sign * binomial<S>(k, j) * binomial<S>(degree_of(b), k), b[static_cast<std::size_t>(j)]);
    }
    f.push_back(std::move(total));
  }
  return f;
}

/// Bezier rows of degree p = n, d + 1 = N + 1 Bernstein coefficients of the mapping in the coordinate of C2's piece, a
/// parameter and a place on the ruling.
template <class S, class P>
struct PieceInput {
  std::vector<P> c1;
  std::vector<P> c2;
  std::vector<S> e;
  S t;
  S s;

  int degree() const { return degree_of(c1) * (static_cast<int>(e.size()) - 1); }

  static PieceInput draw(Source<S>& from, Size size);
};

template <class S, class P>
PieceInput<S, P> PieceInput<S, P>::draw(Source<S>& from, Size size) {
  std::vector<P> c1 = from.template points<P>(size.n + 1);
  std::vector<P> c2 = from.template points<P>(size.n + 1);
  std::vector<S> e;
  for (int i = 0; i <= size.pieces; ++i) e.push_back(from.scalar());
  S t = from.scalar();
  return {std::move(c1), std::move(c2), std::move(e), std::move(t), from.scalar()};
}

inline constexpr std::string_view degrees_remark =
    "n stands for the degree p of the rails, N for the degree d of sigma.";

/// sum_i B_i^d(t) e_i and its derivative, by powers of t.
template <class S>
S mapped(const std::vector<S>& e, const S& t) {
  S total = from_int<S>(0);
  const int d = static_cast<int>(e.size()) - 1;
  for (int i = 0; i <= d; ++i) {
    S weight = binomial<S>(d, i);
    for (int j = 0; j < d; ++j) weight *= j < i ? t : from_int<S>(1) - t;
    total += weight * e[static_cast<std::size_t>(i)];
  }
  return total;
}
template <class S>
S mapped_slope(const std::vector<S>& e, const S& t) {
  std::vector<S> slopes;
  for (std::size_t i = 0; i + 1 < e.size(); ++i) {
    slopes.push_back(from_int<S>(static_cast<std::int64_t>(e.size()) - 1) * (e[i + 1] - e[i]));
  }
  return mapped(slopes, t);
}

}  // namespace torse::proofs::bzz19
