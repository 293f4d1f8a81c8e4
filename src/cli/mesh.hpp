// Meshes of the surfaces of a file.
//   arcs_of               the Bezier pieces of a surface in intervals
//   default_tolerance     of its mesh
//   mesh_surface          its mesh
#pragma once

#include "torse/developable/mesh.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/io/spline_file.hpp"

namespace torse::cli {

/// The pieces of positive length, scaled to a size near 1. Throws InvalidInput naming "points" where the surface is one
/// point or beyond the range of doubles.
RuledArcs arcs_of(const RuledFile<Rational>& surface);

/// A thousandth of the diagonal of the box around the Bezier points.
double default_tolerance(const RuledArcs& arcs);

/// The mesh with the corners rounded to `precision`. Throws InvalidInput as `cut_strips` does, and naming "points"
/// where the rails are one curve, also if they are that only for a part that is not within the tolerance of the rest.
TriangleMesh mesh_surface(const RuledArcs& arcs, double tolerance, MeshPrecision precision);

}  // namespace torse::cli
