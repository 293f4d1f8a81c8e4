// The surfaces of OpenCASCADE that straight lines sweep: planes, cylinders, cones, extrusions, straight lines that
// turn.
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <algorithm>
#include <cmath>

#include "torse/cad/read.hpp"
#include "torse/cad/strips.hpp"

namespace torse::cad {
namespace {

template <class T>
Handle(T) as(const Handle(Standard_Transient) & object) {
  return Handle(T)::DownCast(object);
}

std::vector<double> list_of(const TColStd_Array1OfReal& array) { return {array.begin(), array.end()}; }

CadRail rail_of_spline(const Handle(Geom_BSplineCurve) & given) {
  Handle(Geom_BSplineCurve) curve = given;
  if (curve->IsPeriodic()) {
    curve = as<Geom_BSplineCurve>(curve->Copy());
    curve->SetNotPeriodic();
  }
  CadRail rail{curve->Degree(), list_of(curve->KnotSequence()), {}, {}};
  for (int i = 1; i <= curve->NbPoles(); ++i) {
    rail.points.push_back(point_of(curve->Pole(i).XYZ()));
    rail.weights.push_back(curve->Weight(i));
  }
  return rail;
}

/// The ends of a polygon's sides, if a curve is straight or a polygon.
std::optional<CadRail> polygon_of(const Handle(Geom_Curve) & curve) {
  if (const Handle(Geom_BSplineCurve) spline = as<Geom_BSplineCurve>(curve); !spline.IsNull()) {
    if (spline->Degree() == 1) return rail_of_spline(spline);
  }
  if (const Handle(Geom_BezierCurve) bezier = as<Geom_BezierCurve>(curve); !bezier.IsNull() && bezier->Degree() == 1) {
    return CadRail{1, {0, 0, 1, 1}, {point_of(bezier->Pole(1).XYZ()), point_of(bezier->Pole(2).XYZ())}, {1, 1}};
  }
  return std::nullopt;
}

/// The curve under trimmed ones; their own ends cut the range.
Handle(Geom_Curve) basis_of(Handle(Geom_Curve) curve, CadRange& range) {
  while (true) {
    const Handle(Geom_TrimmedCurve) trimmed = as<Geom_TrimmedCurve>(curve);
    if (trimmed.IsNull()) return curve;
    range.from = std::max(range.from, trimmed->FirstParameter());
    range.to = std::min(range.to, trimmed->LastParameter());
    curve = trimmed->BasisCurve();
  }
}

void add_plane(const Geom_Plane& plane, CadRange u, CadRange v, CadFace& face) {
  const gp_Ax3& frame = plane.Position();
  const gp_XYZ origin = frame.Location().XYZ();
  const gp_XYZ x = frame.XDirection().XYZ();
  const CadRail rail{1, {0, 0, 1, 1}, {point_of(origin + x * u.from), point_of(origin + x * u.to)}, {1, 1}};
  face.strips.push_back({CadExtrusion{rail, point_of(frame.YDirection().XYZ()), {}}, std::nullopt, v});
}

/// A cylinder or cone: at the parameter v the meridian is `radius` + v `slope` from the axis, at the height v `rise`.
/// An end within `resolution` of the vertex is the vertex.
struct Profile {
  double radius;
  double slope;
  double rise;
  double resolution;
};

void add_elementary(const gp_Ax3& frame, const Profile& profile, CadRange u, CadRange v, CadFace& face) {
  const CadPoint origin = point_of(frame.Location().XYZ());
  const CadRange turn = frame.Direct() ? u : CadRange{-u.to, -u.from};
  const auto end = [&](double at) {
    const double radius = profile.radius + at * profile.slope;
    return CadMeridianEnd{origin, std::abs(radius) <= std::abs(profile.slope) * profile.resolution ? 0 : radius,
                          at * profile.rise};
  };
  face.strips.push_back({CadRevolution{origin,
                                       point_of(frame.Direction().XYZ()),
                                       point_of(frame.XDirection().XYZ()),
                                       {end(v.from), end(v.to)},
                                       turn},
                         std::nullopt, std::nullopt});
}

void add_extrusion(const Geom_SurfaceOfLinearExtrusion& surface, CadRange u, CadRange v, double resolution,
                   CadFace& face) {
  const Handle(Geom_Curve) curve = surface.BasisCurve();
  const CadRange natural{curve->FirstParameter(), curve->LastParameter()};
  const bool over_the_seam =
      curve->IsPeriodic() && (u.from < natural.from - resolution || u.to > natural.to + resolution);
  auto [rail, along] = rail_of(curve, over_the_seam ? u : snapped(u, natural, resolution));
  face.strips.push_back({CadExtrusion{std::move(rail), point_of(surface.Direction().XYZ()), {}}, along, v});
}

void add_turned(const Geom_SurfaceOfRevolution& surface, CadRange u, CadRange v, CadFace& face) {
  const Handle(Geom_Curve) curve = basis_of(surface.BasisCurve(), v);
  const gp_Ax1 axis = surface.Axis();
  const Turning turning{point_of(axis.Location().XYZ()), point_of(axis.Direction().XYZ()), u};
  if (const Handle(Geom_Line) line = as<Geom_Line>(curve); !line.IsNull()) {
    const CadPoint base = point_of(line->Position().Location().XYZ());
    const CadRange part = finite(v);
    face.strips.push_back({CadRevolution{turning.origin,
                                         turning.axis,
                                         point_of(line->Position().Direction().XYZ()),
                                         {CadMeridianEnd{base, part.from, 0}, CadMeridianEnd{base, part.to, 0}},
                                         u},
                           std::nullopt, std::nullopt});
  } else if (const std::optional<CadRail> polygon = polygon_of(curve)) {
    add_revolution(turning, polygon->points, face);
    face.remark = "the whole meridian";
  } else {
    face.reason = "its meridian is curved";
  }
}

Net net_of(const Geom_BSplineSurface& surface) {
  // OpenCASCADE 7.6 leaves weights of zero to a polynomial surface that was periodic.
  const bool rational = surface.IsURational() || surface.IsVRational();
  Net net{surface.UDegree(),
          surface.VDegree(),
          list_of(surface.UKnotSequence()),
          list_of(surface.VKnotSequence()),
          static_cast<std::size_t>(surface.NbVPoles()),
          {},
          {}};
  for (int i = 1; i <= surface.NbUPoles(); ++i) {
    for (int j = 1; j <= surface.NbVPoles(); ++j) {
      net.points.push_back(point_of(surface.Pole(i, j).XYZ()));
      net.weights.push_back(rational ? surface.Weight(i, j) : 1);
    }
  }
  return net;
}

Handle(Geom_BSplineSurface) not_periodic(const Handle(Geom_BSplineSurface) & given) {
  if (!given->IsUPeriodic() && !given->IsVPeriodic()) return given;
  Handle(Geom_BSplineSurface) surface = as<Geom_BSplineSurface>(given->Copy());
  if (surface->IsUPeriodic()) surface->SetUNotPeriodic();
  if (surface->IsVPeriodic()) surface->SetVNotPeriodic();
  return surface;
}

std::string type_of(const Handle(Geom_Surface) & surface) {
  if (surface->IsKind(STANDARD_TYPE(Geom_Plane))) return "plane";
  if (surface->IsKind(STANDARD_TYPE(Geom_CylindricalSurface))) return "cylinder";
  if (surface->IsKind(STANDARD_TYPE(Geom_ConicalSurface))) return "cone";
  if (surface->IsKind(STANDARD_TYPE(Geom_SphericalSurface))) return "sphere";
  if (surface->IsKind(STANDARD_TYPE(Geom_ToroidalSurface))) return "torus";
  if (surface->IsKind(STANDARD_TYPE(Geom_SurfaceOfLinearExtrusion))) return "extrusion";
  if (surface->IsKind(STANDARD_TYPE(Geom_SurfaceOfRevolution))) return "revolution";
  if (surface->IsKind(STANDARD_TYPE(Geom_OffsetSurface))) return "offset surface";
  return "B-spline surface";
}

}  // namespace

CadRange finite(CadRange range) {
  const bool low = Precision::IsInfinite(range.from);
  const bool high = Precision::IsInfinite(range.to);
  if (low && high) return {-1, 1};
  if (low) return {range.to - 1, range.to};
  if (high) return {range.from, range.from + 1};
  return range;
}

std::pair<CadRail, std::optional<CadRange>> rail_of(const Handle(Geom_Curve) & given, CadRange range) {
  const Handle(Geom_Curve) curve = basis_of(given, range);
  const CadRange natural{curve->FirstParameter(), curve->LastParameter()};
  if (!curve->IsPeriodic()) range = snapped(range, natural, 0);
  range = finite(range);
  const bool whole = range.from == natural.from && range.to == natural.to;
  const auto part = whole ? std::nullopt : std::optional<CadRange>(range);
  if (const Handle(Geom_Line) line = as<Geom_Line>(curve); !line.IsNull()) {
    const CadPoint from = point_of(line->Value(range.from).XYZ());
    return {CadRail{1, {0, 0, 1, 1}, {from, point_of(line->Value(range.to).XYZ())}, {1, 1}}, std::nullopt};
  }
  if (const Handle(Geom_BSplineCurve) spline = as<Geom_BSplineCurve>(curve); !spline.IsNull()) {
    if (range.from >= natural.from && range.to <= natural.to) return {rail_of_spline(spline), part};
    const auto over_the_seam = as<Geom_BSplineCurve>(spline->Copy());
    over_the_seam->Segment(range.from, range.to);
    return {rail_of_spline(over_the_seam), std::nullopt};
  }
  if (curve->IsKind(STANDARD_TYPE(Geom_BezierCurve)))
    return {rail_of_spline(GeomConvert::CurveToBSplineCurve(curve)), part};
  const Handle(Geom_Curve) cut = new Geom_TrimmedCurve(curve, range.from, range.to);
  return {rail_of_spline(GeomConvert::CurveToBSplineCurve(cut)), std::nullopt};
}

void add_revolution(const Turning& turning, const std::vector<CadPoint>& polygon, CadFace& face) {
  for (std::size_t i = 0; i + 1 < polygon.size(); ++i) {
    if (polygon[i] == polygon[i + 1]) continue;
    const CadMeridianEnd from{polygon[i], 0, 0};
    const CadMeridianEnd to{polygon[i + 1], 0, 0};
    face.strips.push_back(
        {CadRevolution{turning.origin, turning.axis, {}, {from, to}, turning.turn}, std::nullopt, std::nullopt});
  }
  if (face.strips.empty()) face.reason = "its meridian is a point";
}

void add_surface(const Handle(Geom_Surface) & given, const std::optional<Box>& box, CadFace& face) {
  if (given.IsNull()) throw Unreadable("expected a surface");
  Box cut;
  given->Bounds(cut.u.from, cut.u.to, cut.v.from, cut.v.to);
  if (box) cut = *box;
  Handle(Geom_Surface) surface = given;
  while (const auto trimmed = as<Geom_RectangularTrimmedSurface>(surface)) surface = trimmed->BasisSurface();
  if (face.type.empty()) face.type = type_of(surface);
  if (const auto spline = as<Geom_BSplineSurface>(surface)) return add_net(net_of(*not_periodic(spline)), cut, face);
  if (const auto bezier = as<Geom_BezierSurface>(surface)) {
    return add_net(net_of(*GeomConvert::SurfaceToBSplineSurface(bezier)), cut, face);
  }
  const CadRange u = finite(cut.u);
  const CadRange v = finite(cut.v);
  if (const auto plane = as<Geom_Plane>(surface)) {
    add_plane(*plane, u, v, face);
  } else if (const auto cylinder = as<Geom_CylindricalSurface>(surface)) {
    add_elementary(cylinder->Position(), {cylinder->Radius(), 0, 1, 0}, u, v, face);
  } else if (const auto cone = as<Geom_ConicalSurface>(surface)) {
    add_elementary(cone->Position(),
                   {cone->RefRadius(), std::sin(cone->SemiAngle()), std::cos(cone->SemiAngle()), cut.v_resolution}, u,
                   v, face);
  } else if (const auto extrusion = as<Geom_SurfaceOfLinearExtrusion>(surface)) {
    add_extrusion(*extrusion, cut.u, v, cut.u_resolution, face);
  } else if (const auto turned = as<Geom_SurfaceOfRevolution>(surface)) {
    add_turned(*turned, u, cut.v, face);
  } else {
    face.reason = "no straight lines sweep it";
  }
}

}  // namespace torse::cad
