// A ruled surface as a flat plate: polylines in doubles with certified errors, docs/decisions/0008-unroll.md.
//   PlateOptions                  accuracy, marked rulings, which side is seen
//   Plate, PlateRail, PlateRuling what is drawn, and what is known of it
//   ruling_marks                  parameters of the rulings to be marked
//   unroll_plate                  the development
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "torse/exact/unroll/overlap.hpp"
#include "torse/exact/unroll/strip.hpp"
#include "torse/scalar/interval.hpp"

namespace torse {

struct PlateOptions {
  double tolerance;              ///< how far a drawn boundary curve may be from the true one
  std::vector<Rational> marks;   ///< rulings that get a vertex and are marked; the first and the last always are
  double warp_degrees = 0;       ///< an upper bound of the warp angle, below 90; 0 for a developable surface
  bool mirrored = false;         ///< seen from the other side
  std::size_t stations = 5'001;  ///< as many rulings as it may take to develop the plate
};

/// A boundary curve. The rail on the surface and in the plane have the same length, the polyline a shorter one.
struct PlateRail {
  std::vector<PlatePoint> points{};
  std::vector<double> deviation{};  ///< of each edge from its arc, both ends included
  Interval before;                  ///< length on the surface
  Interval after;                   ///< length of the polyline
  double error = 0;                 ///< bound of |before - after|, for every part between two vertices
};

/// A marked ruling.
struct PlateRuling {
  Rational t;
  std::size_t vertex;  ///< of both rails
  Interval before;     ///< |D(t) - C(t)|
  double error;        ///< bound of its difference from the length of the drawn segment
  double bend = 0;     ///< where pieces meet at an angle: that angle in degrees, positive towards the viewer
};

/// The plate, its bounding box at the origin, the chord from the middle of the first to the middle of the last ruling
/// along x. Seen so that the parameter runs to the right where the rulings from C to D run up.
struct Plate {
  std::vector<Rational> parameters;  ///< of the vertices
  PlateRail c;
  PlateRail d;
  std::vector<PlateRuling> rulings;
  double width;
  double height;
  double vertex_error;   ///< bound of the distance of every vertex from its true place
  double deviation;      ///< bound of the distance of every boundary point from the true boundary
  double ruling_error;   ///< bound of the error in length of the ruling at any vertex
  double stretch;        ///< bound of (planar length)/(true length) - 1 for every curve on the surface
  Interval area_before;  ///< of the surface
  Interval area_after;   ///< of the drawn polygon, counted as often as it is covered
  Overlap overlap;
};

/// The outline of a plate: C forward, the last ruling, D backward, the first ruling. Edge i of n - 1 belongs to C, then
/// comes the last ruling, then D, then the first ruling, n being the number of vertices of a rail.
Outline outline_of(const Plate& plate);

/// The ends of `count` equal parts of the domain, and the knots where two strips meet at an angle.
std::vector<Rational> ruling_marks(const KnotList<Rational>& u, const std::vector<PieceStrip>& strips, int count);

/// The strips have no obstacle (strip.hpp); the rows are those of the strips. Throws InvalidInput naming "tolerance"
/// where that cannot be reached, with so many rulings at least, and "points" for a surface whose size is not between
/// 1e-100 and 1e100.
Plate unroll_plate(const std::vector<PieceStrip>& strips, const PlateOptions& options);

}  // namespace torse
