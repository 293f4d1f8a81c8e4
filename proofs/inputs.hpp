// Inputs that many claims share.
//   NetInput         u, c, d_0, L*, M*: the free parameters of FJ07.13
//   off_knots        the hypothesis that M* is none of the knots      proper    ... that no piece is empty
#pragma once

#include <vector>

#include "torse/proofs/claim.hpp"
#include "torse/spline/knots.hpp"

namespace torse::proofs {

/// The free parameters of the linear construction.
template <class S, class P>
struct NetInput {
  KnotList<S> u;
  std::vector<P> c;
  P d0;
  S lambda;
  S m;

  static NetInput draw(Source<S>& from, Size size);
};

template <class S, class P>
NetInput<S, P> NetInput<S, P>::draw(Source<S>& from, Size size) {
  KnotList<S> u(size.n, from.knots(size));
  std::vector<P> c = from.template points<P>(size.last() + 1);
  P d0 = from.template point<P>();
  S lambda = from.scalar();
  S m = from.scalar();
  return {std::move(u), std::move(c), std::move(d0), std::move(lambda), std::move(m)};
}

/// x - u_i for all knots: none is zero iff x is none of the knots.
template <class S>
std::vector<S> off_knots(const KnotList<S>& u, const S& x) {
  std::vector<S> factors;
  for (const S& knot : u.list()) factors.push_back(x - knot);
  return factors;
}

/// The lengths of all pieces: none is zero iff all pieces are proper.
template <class S>
std::vector<S> proper(const KnotList<S>& u) {
  std::vector<S> factors;
  for (int k = 1; k <= u.pieces(); ++k) factors.push_back(u.piece_end(k) - u.piece_begin(k));
  return factors;
}

}  // namespace torse::proofs
