#include "torse/fuzz/plain/rewriting.hpp"

#include <algorithm>
#include <utility>

namespace torse::fuzz::plain {
namespace {

/// Sum_j f_j (a s + b)^j (c s + d)^(degree - j).
Poly substituted(const Poly& f, int degree, const Substitution& by) {
  const Poly above{by.b, by.a};
  const Poly below{by.d, by.c};
  Poly sum;
  for (int j = 0; j <= degree; ++j) {
    Poly term{Rational(1)};
    for (int i = 0; i < j; ++i) term = times(term, above);
    for (int i = j; i < degree; ++i) term = times(term, below);
    if (static_cast<std::size_t>(j) < f.size()) sum = plus(sum, scaled(f[static_cast<std::size_t>(j)], term));
  }
  return sum;
}

}  // namespace

Pieces<4> substituted(const Pieces<4>& curve, int degree, const Substitution& by) {
  Pieces<4> result;
  for (const Rational& t : curve.breaks) result.breaks.push_back(by.inverse(t));
  for (const PolyRow<4>& row : curve.rows) {
    PolyRow<4> next;
    for (std::size_t j = 0; j < row.size(); ++j) next[j] = substituted(row[j], degree, by);
    result.rows.push_back(std::move(next));
  }
  if (result.breaks.front() > result.breaks.back()) {
    std::reverse(result.breaks.begin(), result.breaks.end());
    std::reverse(result.rows.begin(), result.rows.end());
  }
  return result;
}

Pieces<4> multiplied(const Poly& factor, const Pieces<4>& curve) {
  Pieces<4> product = curve;
  for (PolyRow<4>& row : product.rows) {
    for (Poly& f : row) f = times(factor, f);
  }
  return product;
}

Pieces<4> added(const Pieces<4>& x, const Pieces<4>& y) {
  Pieces<4> sum = x;
  for (std::size_t i = 0; i < sum.rows.size(); ++i) {
    for (std::size_t j = 0; j < 4; ++j) sum.rows[i][j] = plus(sum.rows[i][j], y.rows[i][j]);
  }
  return sum;
}

Pieces<4> trimmed(const Pieces<4>& curve, const Rational& a, const Rational& b) {
  Pieces<4> part{{a}, {}};
  for (std::size_t j = 0; j < curve.rows.size(); ++j) {
    if (curve.breaks[j + 1] <= a || curve.breaks[j] >= b) continue;
    part.rows.push_back(curve.rows[j]);
    part.breaks.push_back(std::min(curve.breaks[j + 1], b));
  }
  return part;
}

}  // namespace torse::fuzz::plain
