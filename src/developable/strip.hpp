// A strip of a ruled surface between two rulings, and how far two triangles are from it: certified, in intervals.
//   ArcRow               the Bezier points of a rail over a part of a piece, homogeneous      halves     of it
//   arc_points           the points themselves
//   norm_bound           the length of a vector
//   rail_deviation       of a rail from the chord of its ends
//   quad_deviation       of the segments between two chords from the two triangles
// docs/decisions/0005-meshes.md has the derivation.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "torse/algebra/determinant.hpp"
#include "torse/algebra/point.hpp"
#include "torse/scalar/interval.hpp"

namespace torse {

/// The homogeneous Bezier points w (1, x, y, z) of a rail over a part of a piece.
using ArcRow = std::vector<Vec<Interval, 4>>;
/// Its points.
using ArcPoints = std::vector<Vec<Interval, 3>>;

/// The rows over both halves of the part, by de Casteljau's algorithm.
inline std::pair<ArcRow, ArcRow> halves(ArcRow row) {
  const Interval half = Interval::point(0.5);
  ArcRow left{row.front()};
  ArcRow right{row.back()};
  for (std::size_t size = row.size(); size > 1; --size) {
    for (std::size_t i = 0; i + 1 < size; ++i) row[i] = scaled(half, sum(row[i], row[i + 1]));
    left.push_back(row.front());
    right.push_back(row[size - 2]);
  }
  std::ranges::reverse(right);
  return {std::move(left), std::move(right)};
}

/// The Bezier points; none unless all weights are certainly positive or all negative. The rail is in their convex hull.
inline std::optional<ArcPoints> arc_points(const ArcRow& row) {
  const auto keep = [&](auto&& sign) { return std::ranges::all_of(row, [&](const auto& x) { return sign(x[0]); }); };
  if (!keep([](const Interval& w) { return w.lower() > 0; }) &&
      !keep([](const Interval& w) { return w.upper() < 0; })) {
    return std::nullopt;
  }
  ArcPoints points;
  points.reserve(row.size());
  for (const Vec<Interval, 4>& x : row) {
    Vec<Interval, 3> point(x[1], x[2], x[3]);
    if (x[0].lower() != 1 || x[0].upper() != 1) divide(point, x[0]);
    points.push_back(std::move(point));
  }
  return points;
}

/// x^2; the product of an interval with itself may be negative.
inline Interval square(const Interval& x) {
  const Interval product = x * x;
  return product.lower() < 0 ? Interval::hull(0, product.upper()) : product;
}

/// The length of a vector.
inline Interval norm_bound(const Vec<Interval, 3>& x) {
  return ScalarTraits<Interval>::sqrt(square(x[0]) + square(x[1]) + square(x[2]));
}

/// An upper bound of the distance of p from the segment between a and b.
inline double segment_distance(const Vec<Interval, 3>& p, const Vec<Interval, 3>& a, const Vec<Interval, 3>& b) {
  const Vec<Interval, 3> from_a = difference(p, a);
  const Vec<Interval, 3> chord = difference(b, a);
  const Interval length2 = square(chord[0]) + square(chord[1]) + square(chord[2]);
  if (length2.lower() > 0) {
    const Interval foot = dot(from_a, chord) / length2;
    if (foot.lower() >= 0 && foot.upper() <= 1) return norm_bound(difference(from_a, scaled(foot, chord))).upper();
  }
  return std::min(norm_bound(from_a).upper(), norm_bound(difference(p, b)).upper());
}

/// An upper bound of the distance of the rail from the chord between its ends: the distance from a segment is a convex
/// function, so on the hull of the Bezier points it is largest at one of them.
inline double rail_deviation(const ArcPoints& points) {
  double most = 0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    most = std::max(most, segment_distance(points[i], points.front(), points.back()));
  }
  return most;
}

/// An upper bound of the distance, both ways, between the segments that join a point of the chord c0 c1 to one of the
/// chord d0 d1 (any pairing that runs along both chords in step) and the two triangles on one of the diagonals.
///
/// Where the quadrangle, seen along the common perpendicular of its diagonals, is convex, each of the segments crosses
/// the diagonal in that view, a distance of at most that of the diagonals before or behind it. Elsewhere the twist c0 -
/// c1 - d0 + d1 bounds it, by half its length.
inline double quad_deviation(const Vec<Interval, 3>& c0, const Vec<Interval, 3>& c1, const Vec<Interval, 3>& d0,
                             const Vec<Interval, 3>& d1) {
  const Vec<Interval, 3> a = difference(c1, c0);
  const Vec<Interval, 3> b = difference(d1, d0);
  const Vec<Interval, 3> w = difference(d0, c0);
  const Vec<Interval, 3> z = difference(d1, c1);
  const Vec<Interval, 3> across = cross(difference(d1, c0), difference(d0, c1));
  const auto turns_left = [&](const Vec<Interval, 3>& x, const Vec<Interval, 3>& y) {
    return dot(cross(x, y), across).lower() >= 0;
  };
  const Interval size = norm_bound(across);
  const Interval twist = norm_bound(difference(b, a)) * Interval::point(0.5);
  if (!(size.lower() > 0) || !turns_left(a, w) || !turns_left(a, z) || !turns_left(b, w) || !turns_left(b, z)) {
    return twist.upper();
  }
  const Interval volume = dot(a, across);
  return std::min(twist.upper(), (Interval::hull(0, std::max(-volume.lower(), volume.upper())) / size).upper());
}

}  // namespace torse
