#include "torse/exact/quasi/strip_crossing.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "torse/algebra/determinant.hpp"
#include "torse/algebra/linear_system.hpp"
#include "torse/exact/quasi/krawczyk.hpp"
#include "torse/exact/warp/quotient.hpp"
#include "torse/spline/insertion.hpp"

namespace torse {
namespace {

using Q = Rational;

/// Newton's method doubles the digits with a step once it is near; what it does not find by then it is not near to.
constexpr int most_steps = 30;

/// Where rulings that slide along each other are looked at: one of so many places, and its neighbours up to as many
/// halvings.
constexpr long most_places = 40;
constexpr int most_halvings = 40;

/// Of two or three coordinates.
using Slopes = Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::ColMajor, 3, 4>;
using Gap = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 3, 1>;

/// Of the digits behind the point that a place keeps where it is tried exactly: knots and other simple places are one.
constexpr double grid = 0x1p30;

template <int D>
std::vector<Vec<Q, 4>> homogeneous(const std::vector<Vec<Q, D>>& points) {
  if constexpr (D == 4) {
    return points;
  } else {
    std::vector<Vec<Q, 4>> rows;
    for (const Vec<Q, 3>& x : points) rows.push_back({Q(1), x[0], x[1], x[2]});
    return rows;
  }
}

template <class S, class Change>
std::vector<Vec<S, 4>> changed(const std::vector<Vec<Q, 4>>& rows, const Change& change) {
  std::vector<Vec<S, 4>> result;
  for (const Vec<Q, 4>& x : rows) result.push_back({change(x[0]), change(x[1]), change(x[2]), change(x[3])});
  return result;
}

/// Points of a plane n_0 + n . x = 0 are equal where they are in all coordinates but one for which n is not 0.
std::vector<int> coordinates_in(const Vec<Q, 4>& plane) {
  std::vector<int> kept{0, 1, 2};
  kept.erase(std::ranges::find_if(kept, [&](int k) { return plane[k + 1].sign() != 0; }));
  return kept;
}

}  // namespace

template <int D>
CrossingFinder::CrossingFinder(const KnotList<Q>& u, std::span<const Vec<Q, D>> c, std::span<const Vec<Q, D>> d) {
  Echelon<Q, 4> span;
  for (const int k : u.proper_pieces()) {
    begins_.push_back(u.piece_begin(k).to_double());
    lengths_.push_back(Q(u.piece_end(k) - u.piece_begin(k)).to_double());
    const auto c_rows = homogeneous<D>(bezier_points(u, c, k));
    const auto d_rows = homogeneous<D>(bezier_points(u, d, k));
    Echelon<Q, 4> of_piece;
    for (const auto* rows : {&c_rows, &d_rows}) {
      for (const auto& row : *rows) {
        span.insert(row);
        of_piece.insert(row);
      }
    }
    on_a_line_.push_back(of_piece.rank() <= 2);
    const auto nearest = [](const Q& x) { return x.to_double(); };
    const auto hull = [](const Q& x) { return enclosure(x); };
    rounded_.push(changed<double>(c_rows, nearest), changed<double>(d_rows, nearest));
    enclosed_.push(changed<Interval>(c_rows, hull), changed<Interval>(d_rows, hull));
    exact_.push(c_rows, d_rows);
  }
  if (span.rank() == 3) coordinates_ = coordinates_in(span.kernel().front());
}

template CrossingFinder::CrossingFinder(const KnotList<Q>&, std::span<const Vec<Q, 3>>, std::span<const Vec<Q, 3>>);
template CrossingFinder::CrossingFinder(const KnotList<Q>&, std::span<const Vec<Q, 4>>, std::span<const Vec<Q, 4>>);

std::optional<RulingCrossing> CrossingFinder::near(double s, double t) const {
  Vec<double, 4> x(s, 0.5, t, 0.5);
  for (int step = 0; step < most_steps; ++step) {
    const Meeting<double> here = meeting(rounded_, pair_at(x));
    if (!here.gap.allFinite()) return std::nullopt;
    const Slopes slopes = here.slopes(coordinates_, Eigen::all);
    const Gap gap = here.gap(coordinates_);
    x -= slopes.completeOrthogonalDecomposition().solve(gap);
  }
  if (!x.allFinite()) return std::nullopt;
  Pair<double> at = pair_at(x);
  if (!proved_by_krawczyk(at)) {
    at = pair_at(Vec<double, 4>((x * grid).array().round() / grid));
    if (!proved_exactly(at)) return std::nullopt;
  }
  return RulingCrossing{parameter(at.first_piece, at.x[0]), at.x[1], parameter(at.second_piece, at.x[2]), at.x[3],
                        meeting(rounded_, at).gap.norm()};
}

std::optional<RulingCrossing> CrossingFinder::within(std::size_t piece) const {
  if (!on_a_line_[piece]) return std::nullopt;
  for (long inverse = 2; inverse < most_places; ++inverse) {
    const Q share = ratio<Q>(1, inverse);
    try {
      const StripPoint<Q> start = exact_.at(piece, share, Q(0));
      const Q square = dot(start.by_v, start.by_v);
      // The middles of the rulings nearby come to that of this one.
      Q step = share;
      for (int halvings = 0; halvings < most_halvings; ++halvings) {
        step /= Q(2);
        const Vec<Q, 3> middle = exact_.at(piece, share - step, ratio<Q>(1, 2)).point;
        const Q way = dot(difference(middle, start.point), start.by_v) / square;
        if (way.sign() <= 0 || way >= Q(1)) continue;
        return RulingCrossing{parameter(piece, Q(share - step).to_double()), 0.5, parameter(piece, share.to_double()),
                              way.to_double(), 0};
      }
    } catch (const DivisionByZero&) {
      // A ruling that is a point, or a weight of 0: there are some such shares at most, if not all are.
    }
  }
  return std::nullopt;
}

template <class S>
CrossingFinder::Meeting<S> CrossingFinder::meeting(const StripPoints<S>& strip, const Pair<S>& at) {
  const StripPoint<S> first = strip.at(at.first_piece, at.x[0], at.x[1]);
  const StripPoint<S> second = strip.at(at.second_piece, at.x[2], at.x[3]);
  Meeting<S> found{difference(first.point, second.point), {}};
  for (int k = 0; k < 3; ++k) {
    found.slopes.row(k) << first.by_share[k], first.by_v[k], -second.by_share[k], -second.by_v[k];
  }
  return found;
}

/// The shares are exact: they are what is left of doubles without their integer parts.
CrossingFinder::Pair<double> CrossingFinder::pair_at(const Vec<double, 4>& x) const {
  const auto piece = [&](double number) {
    return std::clamp(std::floor(number), 0.0, static_cast<double>(rounded_.pieces()) - 1);
  };
  const double first = piece(x[0]);
  const double second = piece(x[2]);
  return {static_cast<std::size_t>(first), static_cast<std::size_t>(second), {x[0] - first, x[1], x[2] - second, x[3]}};
}

/// Whether all of the box is in its pieces and between the rails, and no ruling of the one part is one of the other.
/// The ends of a closed strip are one ruling.
bool CrossingFinder::of_two_rulings(const Pair<Interval>& box) const {
  const auto in_piece = [](const Interval& share) { return 0 <= share.lower() && share.upper() <= 1; };
  const auto between = [](const Interval& way) { return 0 < way.lower() && way.upper() < 1; };
  const auto number = [](std::size_t piece, const Interval& share) {
    return Interval(static_cast<long>(piece)) + share;
  };
  const auto parted = [&](const Interval& x, const Interval& y) {
    return x.upper() < y.lower() && (0 < x.lower() || y.upper() < static_cast<double>(exact_.pieces()));
  };
  const Interval first = number(box.first_piece, box.x[0]);
  const Interval second = number(box.second_piece, box.x[2]);
  return in_piece(box.x[0]) && in_piece(box.x[2]) && between(box.x[1]) && between(box.x[3]) &&
         (parted(first, second) || parted(second, first));
}

bool CrossingFinder::proved_by_krawczyk(const Pair<double>& at) const {
  const Eigen::MatrixXd slopes = meeting(rounded_, at).slopes(coordinates_, Eigen::all);
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> pivoted(slopes);
  const Eigen::VectorXi unknowns = pivoted.colsPermutation().indices().head(slopes.rows());
  const Eigen::MatrixXd inverse = slopes(Eigen::all, unknowns).inverse();
  if (!inverse.allFinite()) return false;

  Pair<Interval> box{at.first_piece, at.second_piece, at.x.unaryExpr(&Interval::point)};
  const Krawczyk test(inverse, meeting(enclosed_, box).gap(coordinates_));
  box.x(unknowns) += test.box();
  return of_two_rulings(box) && test.has_zero(meeting(enclosed_, box).slopes(coordinates_, unknowns));
}

bool CrossingFinder::proved_exactly(const Pair<double>& at) const {
  if (!of_two_rulings({at.first_piece, at.second_piece, at.x.unaryExpr(&Interval::point)})) return false;
  try {
    const Pair<Q> exact{at.first_piece, at.second_piece, at.x.unaryExpr(&Q::from_double)};
    return meeting(exact_, exact).gap == Vec<Q, 3>(Q(0), Q(0), Q(0));
  } catch (const DivisionByZero&) {
    return false;
  }
}

double CrossingFinder::parameter(std::size_t piece, double share) const {
  return begins_[piece] + share * lengths_[piece];
}

}  // namespace torse
