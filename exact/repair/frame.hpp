// A net in coordinates of size about 1, as the search wants it.
//   Frame            centre and scale
//   RealNet<D>       the control points c_0, d_0, c_1, d_1, ... with the weights of the distance
//   ExactNet<D>      the same points as rational numbers
//   RuledRows        two rows of weighted points, as they are in files
//   frame_of, real_net, mean_point, rows_of
#pragma once

#include <optional>
#include <vector>

#include "torse/exact/repair/real.hpp"
#include "torse/spline/curve.hpp"

namespace torse::repair {

/// The control rows of a ruled surface.
struct RuledRows {
  WeightedPoints<Rational, 3> c;
  WeightedPoints<Rational, 3> d;
};

/// x = centre + 2^exponent y with coordinates of y in [-1, 1] for the control points x of a net.
struct Frame {
  Vec<Rational, 3> centre;
  long exponent;
};

/// The frame of all control points of both rows, which do not all coincide.
Frame frame_of(const RuledRows& rows);

/// The points c_0, d_0, c_1, d_1, ... of two rows in a frame: D = 3, points; D = 4, homogeneous rows w (1, y). The
/// squared distance of two nets is the sum of |x' - x|^2 / scale: between points it is Euclid's, between homogeneous
/// rows that of w' / w (1, y') and (1, y).
template <int D>
struct RealNet {
  std::vector<Vec<Real, D>> points;
  std::vector<Real> scale;

  std::size_t size() const { return points.size(); }
};

/// The mean of the points first, first + step, ...
Vec<Real, 3> mean_point(const RealNet<3>& net, std::size_t first, std::size_t step);

/// Exact points in the same order.
template <int D>
using ExactNet = std::vector<Vec<Rational, D>>;

/// The net of two rows in their frame; for D = 3 the weights do not matter.
template <int D>
RealNet<D> real_net(const RuledRows& rows, const Frame& frame);

/// The rows of an exact net; for D = 3 with the weights of `original`. Nothing where a weight is zero.
template <int D>
std::optional<RuledRows> rows_of(const ExactNet<D>& net, const Frame& frame, const RuledRows& original);

}  // namespace torse::repair
