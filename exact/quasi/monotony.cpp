#include "torse/exact/quasi/monotony.hpp"

#include <cstddef>
#include <utility>
#include <vector>

#include "torse/algebra/bernstein.hpp"
#include "torse/algebra/polynomial.hpp"
#include "torse/exact/roots/real_roots.hpp"
#include "torse/spline/insertion.hpp"

namespace torse {

namespace {

using Q = Rational;

/// A positive multiple of (1 + s)^(d-1) sigma'((a + b s) / (1 + s)) on piece k = [a, b], with the sign of sigma' inside
/// for positive s: the steps of the Bezier points times binomials are its coefficients.
Polynomial<Q> slope_of(const Mapping<Q>& sigma, int k) {
  const std::vector<Vec<Q, 1>> points = bezier_points(sigma.knots, sigma.points(), k);
  const int degree = sigma.knots.degree() - 1;
  std::vector<Q> list = binomials<Q>(degree);
  for (std::size_t i = 0; i < list.size(); ++i) list[i] *= points[i + 1][0] - points[i][0];
  return Polynomial<Q>(std::move(list));
}

/// A positive number where f, which is not zero, is negative.
std::optional<Q> negative_place(const Polynomial<Q>& f) {
  constexpr int bits = 16;
  Q last(0);
  for (const RealRoot& root : real_roots(f.coefficients(), bits)) {
    if (root.upper.sign() <= 0) continue;  // intervals of roots have no zero inside
    Q between = (last + root.lower) / Q(2);
    if (f(between).sign() < 0) return between;
    last = root.upper;
  }
  const Q beyond = last + Q(1);
  return f(beyond).sign() < 0 ? std::optional(beyond) : std::nullopt;
}

}  // namespace

MonotonyVerdict decide_monotony(const Mapping<Rational>& sigma) {
  MonotonyVerdict verdict;
  const bool ordered = definitely(monotone(sigma));
  for (int k : sigma.knots.proper_pieces()) {
    const Q& a = sigma.knots.piece_begin(k);
    const Q& b = sigma.knots.piece_end(k);
    const Polynomial<Q> slope = slope_of(sigma, k);
    if (slope.zero()) {
      if (verdict.kind == Monotony::strict) verdict = {Monotony::weak, (a + b) / Q(2)};
    } else if (!ordered) {
      if (const std::optional<Q> s = negative_place(slope)) return {Monotony::none, (a + b * *s) / (Q(1) + *s)};
    }
  }
  return verdict;
}

}  // namespace torse
