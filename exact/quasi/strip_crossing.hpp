// A crossing of two rulings near a place: looked for in doubles, proved in intervals or exactly.
//   RulingCrossing     two points of different rulings that coincide
//   CrossingFinder     looks near a pair of rulings
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "torse/exact/quasi/strip_points.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/scalar/builtin.hpp"
#include "torse/scalar/interval.hpp"
#include "torse/spline/knots.hpp"

namespace torse {

/// Two rulings cross near the point at `first_share` of the ruling of `first` and the point at `second_share` of that
/// of `second`, between 0 (on c) and 1. `distance` is how far apart doubles see these two points. Parameters of the
/// knot list.
struct RulingCrossing {
  double first;
  double first_share;
  double second;
  double second_share;
  double distance;
};

/// The strip between two rails: rows of points (D = 3) or homogeneous rows (D = 4).
class CrossingFinder {
 public:
  template <int D>
  CrossingFinder(const KnotList<Rational>& u, std::span<const Vec<Rational, D>> c, std::span<const Vec<Rational, D>> d);

  /// A crossing to which Newton's method leads from the middles of two rulings, each given by the number of its piece
  /// plus the share of it. Where the method stops decides nothing: nothing is returned unless one of these tells that
  /// two different rulings have a point in common.
  /// - Krawczyk's test: two points have four numbers, shares of pieces and ways along rulings, and their gap has three
  ///   coordinates, or two that matter where the whole strip lies in a plane. As many of the numbers as there are
  ///   coordinates make the gap vanish once in a box about where the method stopped, the others being left as they are,
  ///   and the box has no ruling twice.
  /// - The points at the nearest simple numbers are equal in exact arithmetic, as where sheets lie upon each other or
  ///   cross along a ruling at a knot.
  /// Points of the rails, which rulings may share, are left out, and so is the pair of both end rulings, which are one
  /// where the strip is closed.
  std::optional<RulingCrossing> near(double s, double t) const;

  /// A crossing in a piece that lies on a line, whose rulings slide along each other, unless both rails are the same
  /// there. Proved exactly; the witness is rounded.
  std::optional<RulingCrossing> within(std::size_t piece) const;

 private:
  /// Two points, by the numbers of their pieces and both shares and ways.
  template <class S>
  struct Pair {
    std::size_t first_piece;
    std::size_t second_piece;
    Vec<S, 4> x;  ///< share, way, share, way
  };
  template <class S>
  struct Meeting {
    Vec<S, 3> gap;
    Eigen::Matrix<S, 3, 4> slopes;  ///< by each of the four numbers
  };

  template <class S>
  static Meeting<S> meeting(const StripPoints<S>& strip, const Pair<S>& at);

  Pair<double> pair_at(const Vec<double, 4>& x) const;
  bool of_two_rulings(const Pair<Interval>& box) const;
  bool proved_by_krawczyk(const Pair<double>& at) const;
  bool proved_exactly(const Pair<double>& at) const;
  double parameter(std::size_t piece, double share) const;

  std::vector<double> begins_{};
  std::vector<double> lengths_{};
  StripPoints<Rational> exact_{};
  StripPoints<double> rounded_{};
  StripPoints<Interval> enclosed_{};
  std::vector<bool> on_a_line_{};
  std::vector<int> coordinates_{0, 1, 2};  ///< that tell points of the strip apart
};

}  // namespace torse
