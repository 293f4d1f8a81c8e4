#include "torse/fuzz/plain/determinant.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace torse::fuzz::plain {
namespace {

/// a d - b c.
Poly minor(const Poly& a, const Poly& b, const Poly& c, const Poly& d) {
  return plus(times(a, d), scaled(Rational(-1), times(b, c)));
}

/// The six minors of two rows, by the columns 01, 02, 03, 12, 13, 23.
std::array<Poly, 6> minors(const PolyRow<4>& x, const PolyRow<4>& y) {
  std::array<Poly, 6> m;
  std::size_t next = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) m[next++] = minor(x[i], x[j], y[i], y[j]);
  }
  return m;
}

PolyRow<4> row_in_unit_interval(const PolyRow<4>& row, const Rational& a, const Rational& b) {
  PolyRow<4> result;
  for (std::size_t j = 0; j < 4; ++j) result[j] = in_unit_interval(row[j], a, b);
  return result;
}

}  // namespace

Poly in_unit_interval(const Poly& f, const Rational& a, const Rational& b) {
  Poly result;
  for (std::size_t i = f.size(); i-- > 0;) result = plus(times(result, {a, b - a}), {f[i]});
  return result;
}

Poly twist_polynomial(const Strip& strip, int j) {
  const auto at = static_cast<std::size_t>(j);
  const Rational& a = strip.p.breaks[at];
  const Rational& b = strip.p.breaks[at + 1];
  const PolyRow<4> p = row_in_unit_interval(strip.p.rows[at], a, b);
  const PolyRow<4> q = row_in_unit_interval(strip.q.rows[at], a, b);
  const std::array<Poly, 6> top = minors(p, derivative<4>(p));
  const std::array<Poly, 6> low = minors(q, derivative<4>(q));
  // Laplace: the sign of the columns 0 2 | 1 3 and 1 3 | 0 2 is negative.
  Poly sum;
  for (std::size_t i = 0; i < 6; ++i) {
    const Rational sign(i == 1 || i == 4 ? -1 : 1);
    sum = plus(sum, scaled(sign, times(top[i], low[5 - i])));
  }
  return sum;
}

std::vector<Rational> bernstein_coefficients(const Poly& f, int degree) {
  std::vector<Rational> b(static_cast<std::size_t>(degree) + 1);
  for (int i = 0; i <= degree; ++i) {
    Rational factor(1);  // C(i, j) / C(degree, j)
    for (int j = 0; j <= std::min(i, static_cast<int>(f.size()) - 1); ++j) {
      b[static_cast<std::size_t>(i)] += factor * f[static_cast<std::size_t>(j)];
      if (j < degree) factor = factor * Rational(i - j) / Rational(degree - j);
    }
  }
  return b;
}

}  // namespace torse::fuzz::plain
