// Whether a plate overlaps itself in the plane.
//   PlatePoint, Outline      a closed polygon, each edge with the distance to the true curve
//   Overlap, find_overlap    yes, no, or too close to tell, with the edges that meet
//
// The development is locally one to one, and its image turns one way round its outline, so the plate covers a point as
// often as the outline winds around it. Therefore it overlaps itself iff its outline crosses itself.
#pragma once

#include <cstddef>
#include <vector>

#include "torse/scalar/truth.hpp"

namespace torse {

struct PlatePoint {
  double x;
  double y;

  friend bool operator==(const PlatePoint&, const PlatePoint&) = default;
};

/// Edge i goes from points[i] to points[i+1], the last one back to points[0]. The true outline has an arc for each edge
/// that is nowhere farther than slack[i] from it, as its ends are from the edge's ends.
struct Outline {
  std::vector<PlatePoint> points;
  std::vector<double> slack;
};

/// Two edges whose arcs cross, or may touch or cross.
struct Meeting {
  std::size_t first;
  std::size_t second;
  PlatePoint at;  ///< the point where the edges cross, or an end of one that is near the other
  bool certain;
};

struct Overlap {
  Truth verdict = Truth::no;
  std::vector<Meeting> meetings{};  ///< none for no; else as many as were found, up to `most_meetings`
};

inline constexpr std::size_t most_meetings = 100;

/// `inside` are points of the plate: one around which the outline certainly winds twice decides what edges that merely
/// touch do not. Edges that share an end are not compared, nor are edges of length zero.
Overlap find_overlap(const Outline& outline, const std::vector<PlatePoint>& inside);

}  // namespace torse
