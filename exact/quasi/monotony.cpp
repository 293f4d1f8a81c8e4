#include "torse/exact/quasi/monotony.hpp"

#include <cstddef>
#include <utility>
#include <vector>

#include "torse/exact/roots/real_roots.hpp"
#include "torse/spline/piece_polynomials.hpp"

namespace torse {

namespace {

using Q = Rational;

Q middle(const Q& a, const Q& b) { return (a + b) / Q(2); }

/// Whether the intervals leave room on both sides of every root, within [a, b] too.
bool separated(const std::vector<RealRoot>& roots, const Q& a, const Q& b) {
  for (std::size_t i = 0; i < roots.size(); ++i) {
    if (i > 0 && !(roots[i - 1].upper < roots[i].lower)) return false;
    if (roots[i].rational()) continue;
    for (const Q* end : {&a, &b}) {
      if (!(*end < roots[i].lower || roots[i].upper < *end)) return false;
    }
  }
  return true;
}

/// The real roots of f, which is not zero, in intervals that are separated. An irrational root is neither a nor b.
std::vector<RealRoot> separated_roots(const Polynomial<Q>& f, const Q& a, const Q& b) {
  int bits = 16;
  std::vector<RealRoot> roots = real_roots(f.coefficients(), bits);
  while (!separated(roots, a, b)) roots = real_roots(f.coefficients(), bits *= 2);
  return roots;
}

/// One point of (a, b) between any two neighbours among a, b and the roots of f.
std::vector<Q> between_roots(const Polynomial<Q>& f, const Q& a, const Q& b) {
  std::vector<Q> samples;
  Q last = a;
  for (const RealRoot& root : separated_roots(f, a, b)) {
    if (!(a < root.upper && root.lower < b)) continue;
    samples.push_back(middle(last, root.lower));
    last = root.upper;
  }
  samples.push_back(middle(last, b));
  return samples;
}

/// A parameter of (a, b) where f < 0.
std::optional<Q> negative_inside(const Polynomial<Q>& f, const Q& a, const Q& b) {
  for (const Q& t : between_roots(f, a, b)) {
    if (f(t).sign() < 0) return t;
  }
  return std::nullopt;
}

}  // namespace

MonotonyVerdict decide_monotony(const Mapping<Rational>& sigma) {
  MonotonyVerdict verdict;
  const bool ordered = definitely(monotone(sigma));
  for (int k : sigma.knots.proper_pieces()) {
    const Q& a = sigma.knots.piece_begin(k);
    const Q& b = sigma.knots.piece_end(k);
    const Polynomial<Q> slope = derivative(piece_polynomials<Q, 1>(sigma.knots, sigma.points(), k))[0];
    if (slope.zero()) {
      if (verdict.kind == Monotony::strict) verdict = {Monotony::weak, middle(a, b)};
    } else if (!ordered) {
      if (std::optional<Q> t = negative_inside(slope, a, b)) return {Monotony::none, std::move(t)};
    }
  }
  return verdict;
}

}  // namespace torse
