// The parts of a spline between knots of multiplicity n, which hang together by one control point only.
//   Segment, segments_of       the parts
//   part_of                    the net of a part
#pragma once

#include <vector>

#include "torse/exact/repair/frame.hpp"
#include "torse/spline/knots.hpp"

namespace torse::repair {

/// The control points from index `begin` to `end`, over their own knots. Neighbours share a control point.
struct Segment {
  int begin;
  int end;
  KnotList<Rational> knots;
};

/// The parts into which the knots of multiplicity n inside the domain cut a spline; one where there are none.
std::vector<Segment> segments_of(const KnotList<Rational>& u);

/// The points of a segment.
template <int D>
RealNet<D> part_of(const RealNet<D>& net, const Segment& segment);

}  // namespace torse::repair
