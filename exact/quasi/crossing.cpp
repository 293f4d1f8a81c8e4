#include "torse/exact/quasi/crossing.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "torse/exact/repair/real.hpp"

namespace torse::quasi {

namespace {

using Q = Rational;

/// A coefficient that a crossing may change, the logarithm of its weight times its room or, later, of the product of
/// all up to this crossing, and the coefficient of the crossing before.
struct Candidate {
  int column;
  double score;
  const Candidate* before = nullptr;
};

/// The coefficients of a crossing. Room is the way to the nearer one of the neighbours, which keeps level parts level.
/// A coefficient with room on the side only that the value asks for is worse than others, one with none a last resort.
std::vector<Candidate> candidates_of(const Mapping<Q>& sigma, const Form<Q>& weights, const Q& missing) {
  constexpr double on_one_side = -100;
  constexpr double nowhere = -100000;
  const auto logarithm = [](const Q& x) { return static_cast<double>(exponent_of(x)); };
  std::vector<Candidate> list;
  for (const auto& [column, weight] : weights.terms()) {
    const std::size_t j = static_cast<std::size_t>(column);
    const Q up = sigma.control[j + 1][0] - sigma.control[j][0];
    const Q down = sigma.control[j][0] - sigma.control[j - 1][0];
    const Q room = std::min(up, down);  // below zero where the coefficients fall, though sigma does not
    const Q& ahead = missing.sign() > 0 ? up : down;
    const double score = room.sign() != 0    ? logarithm(weight * room)
                         : ahead.sign() != 0 ? logarithm(weight * ahead) + on_one_side
                                             : nowhere;
    list.push_back({column, score});
  }
  return list;
}

/// One coefficient for each crossing, in increasing order, such that the product of weights and rooms is as large as it
/// may be. There is a way, as each crossing has a knot of its own.
std::vector<int> chosen(std::vector<std::vector<Candidate>> all) {
  for (std::size_t i = 1; i < all.size(); ++i) {
    for (Candidate& candidate : all[i]) {
      double reached = -std::numeric_limits<double>::infinity();
      for (const Candidate& previous : all[i - 1]) {
        if (candidate.column <= previous.column || previous.score <= reached) continue;
        candidate.before = &previous;
        reached = previous.score;
      }
      candidate.score += reached;
    }
  }
  std::vector<int> columns;
  const Candidate* last = &*std::ranges::max_element(all.back(), {}, &Candidate::score);
  for (const Candidate* at = last; at != nullptr; at = at->before) columns.push_back(at->column);
  std::ranges::reverse(columns);
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
  const KnotList<Q>& u = sigma.knots;
  const auto below = [&](int k, const Q& t) { return !(value < curve_point(u, sigma.points(), k, t)[0]); };
  const std::vector<int> pieces = u.proper_pieces();
  const int piece = *std::ranges::partition_point(pieces, [&](int k) { return below(k, u.piece_end(k)); });
  Q low = u.piece_begin(piece);
  Q high = u.piece_end(piece);
  const long exponent = exponent_of((high - low) * share);
  const Q grid = repair::power_of_two(exponent);
  while (grid < high - low) {
    const Q middle = repair::rounded((low + high) / Q(2), exponent);  // off by half a step, so between them
    (below(piece, middle) ? low : high) = middle;
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
