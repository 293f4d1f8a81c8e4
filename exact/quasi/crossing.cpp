#include "torse/exact/quasi/crossing.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
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

/// A coefficient that a crossing may change, and the logarithm of its weight times its room.
struct Candidate {
  int column;
  long score;
};

/// The coefficients of a crossing. One with room on the side only that the value asks for is worse than others, one
/// with none a last resort.
std::vector<Candidate> candidates_of(const Mapping<Q>& sigma, const Form<Q>& weights, const Q& missing) {
  constexpr long on_one_side = -100;
  constexpr long nowhere = -100000;
  std::vector<Candidate> list;
  for (const auto& [j, weight] : weights.terms()) {
    const std::size_t at = static_cast<std::size_t>(j);
    const Q room = room_of(sigma, at, 0);
    const Q ahead = room_of(sigma, at, missing.sign());
    const long score = room.sign() > 0    ? exponent_of(weight * room)
                       : ahead.sign() > 0 ? exponent_of(weight * ahead) + on_one_side
                                          : nowhere;
    list.push_back({j, score});
  }
  return list;
}

/// One coefficient for each crossing, in increasing order, such that the product of weights and rooms is as large as it
/// may be. There is a way, as each crossing has a knot of its own.
std::vector<int> chosen(std::vector<std::vector<Candidate>> all) {
  constexpr long no_way = std::numeric_limits<long>::min() / 2;
  std::vector<std::vector<std::size_t>> before(all.size());  // the best way to each candidate
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (Candidate& candidate : all[i]) {
      std::size_t best = 0;
      long reached = i == 0 ? 0 : no_way;
      for (std::size_t l = 0; i > 0 && l < all[i - 1].size(); ++l) {
        const Candidate& previous = all[i - 1][l];
        if (previous.column >= candidate.column || previous.score <= reached) continue;
        best = l;
        reached = previous.score;
      }
      candidate.score = reached == no_way ? no_way : candidate.score + reached;
      before[i].push_back(best);
    }
  }
  std::vector<int> columns(all.size());
  std::size_t at = 0;
  for (std::size_t i = all.size(); i-- > 0;) {
    if (i + 1 == all.size()) {
      at = static_cast<std::size_t>(std::ranges::max_element(all[i], {}, &Candidate::score) - all[i].begin());
    }
    columns[i] = all[i][at].column;
    at = before[i][at];
  }
  return columns;
}

/// The changes x of these coefficients with sum_l weights_i(columns_l) x_l = missing_i. Elimination needs no pivots:
/// the matrix is totally positive.
std::vector<Q> solved(const std::vector<Form<Q>>& weights, const std::vector<int>& columns,
                      const std::vector<Q>& missing) {
  const int count = static_cast<int>(columns.size());
  std::vector<Form<Q>> rows;  // generator l is x_l, the last one the constant -1
  for (std::size_t i = 0; i < columns.size(); ++i) {
    Form<Q> row;
    for (int l = 0; l < count; ++l) {
      add_scaled(row, weights[i].coefficient(columns[static_cast<std::size_t>(l)]), Form<Q>::generator(l));
    }
    add_scaled(row, missing[i], Form<Q>::generator(count));
    for (std::size_t l = 0; l < i; ++l) {
      const Q factor = row.coefficient(static_cast<int>(l));
      add_scaled(row, -factor, rows[l]);
    }
    divide(row, row.coefficient(static_cast<int>(i)));
    rows.push_back(std::move(row));
  }
  std::vector<Q> x(columns.size());
  for (std::size_t i = columns.size(); i-- > 0;) {
    x[i] = rows[i].extract(count);
    for (const auto& [l, factor] : rows[i].terms()) {
      if (l != static_cast<int>(i)) x[i] -= factor * x[static_cast<std::size_t>(l)];
    }
  }
  return x;
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
    const Q middle = repair::rounded((low + high) / Q(2), exponent);  // off by half a step, so between them
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
  std::vector<Form<Q>> weights;
  std::vector<Q> missing;
  std::vector<std::vector<Candidate>> candidates;
  for (const Crossing& crossing : crossings) {
    weights.push_back(weights_at(sigma.knots, crossing.t));
    missing.push_back(crossing.value);
    for (const auto& [j, weight] : weights.back().terms()) {
      missing.back() -= weight * sigma.control[static_cast<std::size_t>(j)][0];
    }
    candidates.push_back(candidates_of(sigma, weights.back(), missing.back()));
  }
  const std::vector<int> columns = chosen(std::move(candidates));
  const std::vector<Q> changes = solved(weights, columns, missing);
  for (std::size_t i = 0; i < columns.size(); ++i) sigma.control[static_cast<std::size_t>(columns[i])][0] += changes[i];
}

}  // namespace torse::quasi
