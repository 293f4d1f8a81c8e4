// Ruled strips of surfaces: what a face becomes for torse.
//   Box                       parameters of a face on its surface
//   Net                       a B-spline surface, bit for bit as the file has it
//   add_net                   its strips if it has degree 1 in a direction
//   add_surface               the strips of a surface of OpenCASCADE          rail_of       a curve of it
//   add_revolution            a polygon that turns about an axis
//   snapped, finite           ranges of parameters
#pragma once

#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <gp_XYZ.hxx>
#include <optional>
#include <utility>
#include <vector>

#include "torse/io/cad.hpp"

namespace torse::cad {

/// The parameters of a face on its surface, and what counts as equal there.
struct Box {
  CadRange u{};
  CadRange v{};
  double u_resolution = 0;
  double v_resolution = 0;
};

/// A B-spline surface with CAD lists of knots; the point (i, j) stands at i * columns + j, i running along u.
struct Net {
  int degree_u = 0;
  int degree_v = 0;
  std::vector<double> knots_u{};
  std::vector<double> knots_v{};
  std::size_t columns = 0;
  std::vector<CadPoint> points{};
  std::vector<double> weights{};
};

inline CadPoint point_of(const gp_XYZ& x) { return {x.X(), x.Y(), x.Z()}; }

/// The range with ends within `resolution` of those of `natural` put there, and no part outside.
CadRange snapped(CadRange range, const CadRange& natural, double resolution);

/// The range with infinite ends drawn to a length of 1 or 2.
CadRange finite(CadRange range);

/// The curve as B-spline, and the part of it between the parameters (none for the whole). Throws Unreadable.
std::pair<CadRail, std::optional<CadRange>> rail_of(const Handle(Geom_Curve) & curve, CadRange range);

/// Adds the strips of a net, cut to a box (none for the whole), and says in `face` whether it is ruled and trimmed.
/// Throws Unreadable for a net whose numbers do not fit together.
void add_net(const Net& net, const std::optional<Box>& box, CadFace& face);

/// A polygon that turns: a strip for each of its sides.
struct Turning {
  CadPoint origin{};
  CadPoint axis{};
  CadRange turn{};
};
void add_revolution(const Turning& turning, const std::vector<CadPoint>& polygon, CadFace& face);

/// The same of a surface of OpenCASCADE; `face.type` is set where it is empty.
void add_surface(const Handle(Geom_Surface) & surface, const std::optional<Box>& box, CadFace& face);

}  // namespace torse::cad
