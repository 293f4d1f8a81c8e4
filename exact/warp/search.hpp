// Branch and bound for the largest value of a piecewise quotient: sin^2 of the warp angle.
//   WarpGoal        when a sub-interval needs no further look
//   WarpRecord      what is known so far
//   WarpPiece<Q>    one piece of the surface
//   search          works through pieces, and returns those that the arithmetic cannot settle
//   bound_above     what the arithmetic can say of these all the same
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "torse/exact/warp/quotient.hpp"

namespace torse {

/// Either an enclosure whose ends agree to a relative `tolerance` of the angle, or the comparison with a limit.
struct WarpGoal {
  double tolerance = 1e-3;
  std::optional<Interval> limit{};  ///< sin^2 of the limit, times the factor of the record
};

/// Bounds of sin^2 of the warp angle times 4^scale, over what was searched.
struct WarpRecord {
  double lower = 0;  ///< attained at (piece, position)
  double upper = 0;  ///< over the settled sub-intervals
  long scale = 0;
  int piece = 0;         ///< where `lower` is attained; 0: nowhere
  double position = 0;   ///< in [0, 1] over the piece, exact
  long intervals = 0;    ///< looked at
  bool complete = true;  ///< the budget sufficed
};

/// sin^2 of the warp angle on a piece.
template <BoundedQuotient Q>
struct WarpPiece {
  int piece;
  Q quotient;
};

namespace detail {

/// The value from which on a bound is too high: that of an angle larger by somewhat less than the tolerance. It only
/// steers the search, so it need not be rigorous.
inline double search_threshold(const WarpRecord& record, const WarpGoal& goal) {
  if (goal.limit) return goal.limit->lower();
  const double growth = 1 + 0.9 * goal.tolerance;
  if (record.lower < 1e-6 || record.scale != 0) return record.lower * growth * growth;
  const double angle = growth * std::asin(std::sqrt(std::min(1.0, record.lower)));
  const double sine = std::sin(angle);
  return angle < std::numbers::pi / 2 ? sine * sine : 1;
}

/// A value attained at a position of a piece. Whether it is the largest so far.
inline bool note(WarpRecord& record, double value, int piece, double position) {
  if (value <= record.lower) return false;
  record.lower = value;
  record.piece = piece;
  record.position = position;
  return true;
}

template <class Q>
struct SearchNode {
  Q quotient;
  double begin;
  double width;
};

/// Whether the error of the coefficients, not the width of the interval, keeps the bound high.
inline bool error_rules(const QuotientBound& bound, double threshold, const WarpGoal& goal) {
  return bound.nominal <= threshold || bound.value > bound.nominal * (1 + goal.tolerance / 2);
}

}  // namespace detail

/// Searches the pieces with at most `budget` sub-intervals and brings the record up to date. Returns the indices of the
/// pieces that it could not settle because of errors of the coefficients; in them only `lower` is up to date.
///
/// A sub-interval is settled once its upper bound is below the goal's threshold. Where the budget runs out the record
/// is not complete, and its upper bound is that of what was left, which may be infinite. Stops early once a limit is
/// exceeded; the upper bound is then of no use.
template <BoundedQuotient Q>
std::vector<std::size_t> search(std::vector<WarpPiece<Q>>& pieces, const WarpGoal& goal, long budget,
                                WarpRecord& record) {
  constexpr double narrowest = 0x1p-48;
  double threshold = detail::search_threshold(record, goal);
  const auto note = [&](double value, int piece, double position) {
    if (detail::note(record, value, piece, position)) threshold = detail::search_threshold(record, goal);
  };
  const auto exceeded = [&] { return goal.limit && record.lower > goal.limit->upper(); };
  for (const WarpPiece<Q>& piece : pieces) {
    note(piece.quotient.lower_at_begin(), piece.piece, 0);
    note(piece.quotient.lower_at_end(), piece.piece, 1);
  }
  const auto settle = [&](const QuotientBound& bound) {
    record.upper = std::max(record.upper, record.scale == 0 ? std::min(bound.value, 1.0) : bound.value);
  };
  std::vector<std::size_t> open;
  std::vector<detail::SearchNode<Q>> stack;
  for (std::size_t i = 0; i < pieces.size() && !exceeded(); ++i) {
    stack.clear();
    stack.push_back({std::move(pieces[i].quotient), 0, 1});
    while (!stack.empty() && !exceeded()) {
      if (budget-- <= 0) {
        record.complete = false;
        for (const detail::SearchNode<Q>& rest : stack) settle(rest.quotient.upper());
        for (++i; i < pieces.size(); ++i) settle(pieces[i].quotient.upper());
        return open;
      }
      ++record.intervals;
      const detail::SearchNode<Q> node = std::move(stack.back());
      stack.pop_back();
      const QuotientBound bound = node.quotient.upper();
      if (bound.value <= threshold || (threshold >= 1 && record.scale == 0 && bound.value < detail::infinity)) {
        settle(bound);
        continue;
      }
      if (detail::error_rules(bound, threshold, goal) || node.width <= narrowest) {
        open.push_back(i);
        break;
      }
      std::pair<Q, Q> halves = node.quotient.split();
      const double half = node.width / 2;
      note(halves.first.lower_at_end(), pieces[i].piece, node.begin + half);
      stack.push_back({std::move(halves.first), node.begin, half});
      stack.push_back({std::move(halves.second), node.begin + half, half});
    }
  }
  return open;
}

/// An upper bound of all quotients by at most `budget` sub-intervals: the one with the largest bound is halved until
/// that is below the threshold or owes more to the errors of its coefficients than to its width. Infinite where a
/// denominator is not certified.
template <BoundedQuotient Q>
double bound_above(std::vector<Q> quotients, double threshold, long budget) {
  constexpr double narrowest = 0x1p-48;
  struct Node {
    QuotientBound bound;
    Q quotient;
    double width;
  };
  const auto lower = [](const Node& x, const Node& y) { return x.bound.value < y.bound.value; };
  std::vector<Node> heap;
  const auto push = [&](Q quotient, double width) {
    const QuotientBound bound = quotient.upper();
    heap.push_back({bound, std::move(quotient), width});
    std::push_heap(heap.begin(), heap.end(), lower);
  };
  for (Q& quotient : quotients) push(std::move(quotient), 1);
  while (!heap.empty()) {
    std::pop_heap(heap.begin(), heap.end(), lower);
    const Node node = std::move(heap.back());
    heap.pop_back();
    const bool only_error = node.bound.value < detail::infinity && node.bound.value > 2 * node.bound.nominal;
    if (budget-- <= 0 || node.bound.value <= threshold || only_error || node.width <= narrowest) {
      return node.bound.value;
    }
    std::pair<Q, Q> halves = node.quotient.split();
    push(std::move(halves.first), node.width / 2);
    push(std::move(halves.second), node.width / 2);
  }
  return 0;
}

}  // namespace torse
