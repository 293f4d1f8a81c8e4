#include "torse/exact/quasi/crossing.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "torse/exact/repair/real.hpp"

namespace torse::quasi {

namespace {

using Q = Rational;

/// Where in [0, 1] the Bernstein polynomial, which grows through zero, does so but for rounding. Its coefficients are
/// scaled to at most 1.
double rounded_root(std::vector<double> b) {
  double low = 0;
  double high = 1;
  for (double t = 0.5; low < t && t < high; t = (low + high) / 2) {
    std::vector<double> row = b;
    for (std::size_t size = row.size(); size > 1; --size) {
      for (std::size_t i = 0; i + 1 < size; ++i) row[i] += t * (row[i + 1] - row[i]);
    }
    (row.front() < 0 ? low : high) = t;
  }
  return low;
}

/// The parameter of [a, b] where sigma has the value but for rounding.
Q guessed(const Mapping<Q>& sigma, const Q& value, const Q& a, const Q& b) {
  const auto points = restricted_points(sigma.knots, sigma.points(), piece_at(sigma.knots, a), a, b);
  Q scale = points.back()[0] - points.front()[0];
  if (scale.sign() == 0) return a;
  std::vector<double> row;
  for (const Vec<Q, 1>& p : points) row.push_back(((p[0] - value) / scale).to_double());
  return a + Q::from_double(rounded_root(std::move(row))) * (b - a);
}

/// How far coefficient j may change by itself: to the nearer one of its neighbours, which keeps level parts level, or
/// with `sign` to the neighbour in that direction.
Q room_of(const Mapping<Q>& sigma, std::size_t j, int sign) {
  const Q up = sigma.control[j + 1][0] - sigma.control[j][0];
  const Q down = sigma.control[j][0] - sigma.control[j - 1][0];
  const Q room = sign > 0 ? up : sign < 0 ? down : std::min(up, down);
  return room.sign() < 0 ? -room : room;
}

/// The crossing's coefficient: beyond `last`, with the largest product of its weight and its room.
int chosen(const Mapping<Q>& sigma, const Form<Q>& weights, const Q& missing, int last) {
  int best = -1;
  Q best_score(-1);
  for (const int sign : {0, missing.sign()}) {
    for (const auto& [j, weight] : weights.terms()) {
      if (j <= last) continue;
      Q score = weight * room_of(sigma, static_cast<std::size_t>(j), sign);
      if (best_score < score) {
        best = j;
        best_score = std::move(score);
      }
    }
    if (best_score.sign() > 0) break;
  }
  return best;
}

}  // namespace

long exponent_of(const Rational& x) {
  return static_cast<long>(x.numerator_bits()) - static_cast<long>(x.denominator_bits());
}

Rational last_below(const Mapping<Rational>& sigma, const Rational& value, const Rational& share) {
  const auto below = [&](const Q& t) { return !(value < mapping_value(sigma, t)); };
  const std::vector<int> pieces = sigma.knots.proper_pieces();
  const auto passing =
      std::ranges::find_if(pieces, [&](int k) { return k == pieces.back() || !below(sigma.knots.piece_end(k)); });
  const Q& a = sigma.knots.piece_begin(*passing);
  const Q& b = sigma.knots.piece_end(*passing);
  const long exponent = exponent_of((b - a) * share);
  const Q grid = repair::power_of_two(exponent);
  Q low = std::clamp(repair::rounded(guessed(sigma, value, a, b), exponent), a, b);
  Q high = std::min(low + grid, b);
  for (Q step = grid; a < low && !below(low); step *= Q(16)) low = std::max(low - step, a);
  for (Q step = grid; high < b && below(high); step *= Q(16)) high = std::min(high + step, b);
  while (grid < high - low) {
    const Q middle = repair::rounded((low + high) / Q(2), exponent);
    if (!(low < middle && middle < high)) break;
    (below(middle) ? low : high) = middle;
  }
  return low;
}

Form<Rational> weights_at(const KnotList<Rational>& u, const Rational& t) {
  std::vector<Form<Q>> generators;
  for (int i = 0; i <= u.last(); ++i) generators.push_back(Form<Q>::generator(i));
  return curve_point<Q, Form<Q>>(u, generators, piece_at(u, t), t);
}

void fit_coefficients(Mapping<Rational>& sigma, const std::vector<Crossing>& crossings) {
  const int count = static_cast<int>(crossings.size());
  std::vector<int> columns;        // the coefficient of each crossing
  std::vector<Form<Q>> equations;  // in their changes; generator `count` is the constant
  std::vector<Form<Q>> weights;
  for (const Crossing& crossing : crossings) {
    weights.push_back(weights_at(sigma.knots, crossing.t));
    Q missing = crossing.value;
    for (const auto& [j, weight] : weights.back().terms())
      missing -= weight * sigma.control[static_cast<std::size_t>(j)][0];
    columns.push_back(chosen(sigma, weights.back(), missing, columns.empty() ? -1 : columns.back()));
    Form<Q> equation;
    add_scaled(equation, -missing, Form<Q>::generator(count));
    equations.push_back(std::move(equation));
  }
  for (int i = 0; i < count; ++i) {
    Form<Q>& equation = equations[static_cast<std::size_t>(i)];
    for (int l = 0; l < count; ++l) {
      const Q weight = weights[static_cast<std::size_t>(i)].coefficient(columns[static_cast<std::size_t>(l)]);
      add_scaled(equation, weight, Form<Q>::generator(l));
    }
    for (int l = 0; l < i; ++l) {
      const Q factor = equation.coefficient(l);
      add_scaled(equation, -factor, equations[static_cast<std::size_t>(l)]);
    }
    divide(equation, equation.coefficient(i));
  }
  std::vector<Q> changes(static_cast<std::size_t>(count) + 1, Q(0));
  changes.back() = Q(1);
  for (int i = count - 1; i >= 0; --i) {
    Q& change = changes[static_cast<std::size_t>(i)];
    for (const auto& [l, factor] : equations[static_cast<std::size_t>(i)].terms()) {
      if (l != i) change -= factor * changes[static_cast<std::size_t>(l)];
    }
    sigma.control[static_cast<std::size_t>(columns[static_cast<std::size_t>(i)])][0] += change;
  }
}

}  // namespace torse::quasi
