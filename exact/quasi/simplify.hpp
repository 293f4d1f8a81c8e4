// The reverse of Algorithm 1's question: which simpler surface is near enough to a result?
//   SimplifiedSurface         a surface and how far it is from the given one
//   with_fewest_knots         of a given degree, knots removed as long as the tolerance allows
//   with_lowest_degree        of the lowest degree that the given surface's breakpoints allow
//   with_fewest_points        of any degree up to the given one
#pragma once

#include <optional>

#include "torse/developable/ruled.hpp"
#include "torse/exact/rational/rational.hpp"

namespace torse {

using ExactSurface = RuledSpline<Rational, Vec<Rational, 3>>;

/// A ruled B-spline surface with the same four corners. Near points do not make near normals: its warp angles are its
/// own, and its rails are no longer exactly the given ones.
struct SimplifiedSurface {
  ExactSurface surface;
  /// No point is further than this from the point of the given surface with the same parameters: an upper bound from
  /// exact arithmetic, not above the tolerance.
  double distance;
};

/// A surface of the given degree whose knots are some of the breakpoints of the given clamped surface, by least
/// squares, within `tolerance` (a length) of it; nothing if even all breakpoints with as many knots as the degree give
/// none. Knots are removed in the order of the jumps of their derivatives until no other single one can be: few, but no
/// proof that there are not fewer. Breakpoints whose shares of the domain are one double count as the first of them.
/// Throws InvalidInput naming "tolerance" unless it is positive, "degree" unless it is at least 1 and at most that of
/// the surface, "knots" for a surface that is not clamped.
std::optional<SimplifiedSurface> with_fewest_knots(const ExactSurface& surface, int degree, const Rational& tolerance);

/// The one of the lowest degree for which there is one. The surface itself where there is none.
SimplifiedSurface with_lowest_degree(const ExactSurface& surface, const Rational& tolerance);

/// The one with the fewest control points over all degrees.
SimplifiedSurface with_fewest_points(const ExactSurface& surface, const Rational& tolerance);

}  // namespace torse
