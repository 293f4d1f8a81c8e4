// How far two ruled surfaces with the same knots are apart.
//   NetDistance, distance_between
#pragma once

#include <optional>

#include "torse/exact/repair/frame.hpp"

namespace torse {

/// Distances of the control points x of one surface from those x' of another, and what they say of the surfaces. Every
/// number is rounded upwards, so it is a bound; one beyond the largest double is infinite.
struct NetDistance {
  double largest = 0;           ///< max |x' - x|
  double root_mean_square = 0;  ///< of |x' - x| over both rows
  double relative = 0;          ///< `largest` by the diagonal of the bounding box of the points x
  double weights = 0;           ///< max |w' - w| / |w|
  /// The largest change of a coordinate in units in the last place (binary64, at least 2^-1074) of its own value;
  /// coordinates 0 are left out. None if all are 0.
  std::optional<double> ulps{};
  /// The same in units in the last place of the largest coordinate in absolute value.
  double ulps_of_largest = 0;
  /// A bound of the distance of points with equal parameters: `largest` by the convex hull property if the weights are
  /// the same and positive, `largest` + diagonal `weights` for other positive weights. None if some weight is negative.
  std::optional<double> surfaces{};
};

/// From `before` to `after`, which have as many points.
NetDistance distance_between(const repair::RuledRows& before, const repair::RuledRows& after);

}  // namespace torse
