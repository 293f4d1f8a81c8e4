#include "torse/cad/iges_curve.hpp"

#include <Geom_Curve.hxx>
#include <IGESGeom_BSplineCurve.hxx>
#include <IGESGeom_Line.hxx>
#include <IGESToBRep_BasicCurve.hxx>
#include <gp_GTrsf.hxx>
#include <string>

#include "torse/cad/face.hpp"
#include "torse/cad/read.hpp"
#include "torse/cad/strips.hpp"

namespace torse::cad {
namespace {

CadRail rail_of_line(const IGESGeom_Line& line) {
  return {1, {0, 0, 1, 1}, {point_of(line.StartPoint().XYZ()), point_of(line.EndPoint().XYZ())}, {1, 1}};
}

CadRail rail_of_spline(const IGESGeom_BSplineCurve& spline) {
  CadRail rail{spline.Degree(), {}, {}, {}};
  for (int i = -spline.Degree(); i <= spline.UpperIndex() + 1; ++i) rail.knots.push_back(spline.Knot(i));
  for (int i = 0; i <= spline.UpperIndex(); ++i) {
    rail.points.push_back(point_of(spline.Pole(i).XYZ()));
    rail.weights.push_back(spline.IsPolynomial() ? 1 : spline.Weight(i));
  }
  const CadRange domain{spline.Knot(0), spline.Knot(spline.UpperIndex() + 1 - spline.Degree())};
  const CadRange part = snapped({spline.UMin(), spline.UMax()}, domain, 0);
  if (part.from != domain.from || part.to != domain.to) rail.part = part;
  return rail;
}

}  // namespace

CadRail IgesCurves::rail(const Handle(IGESData_IGESEntity) & curve) const {
  if (curve.IsNull()) throw Unreadable("expected a curve, found nothing");
  require_sound(model_, curve);
  CadRail rail;
  if (const auto line = Handle(IGESGeom_Line)::DownCast(curve); !line.IsNull()) {
    rail = rail_of_line(*line);
  } else if (const auto spline = Handle(IGESGeom_BSplineCurve)::DownCast(curve); !spline.IsNull()) {
    rail = rail_of_spline(*spline);
  } else {
    return through_occt(curve);
  }
  if (!curve->HasTransf()) return rail;
  const gp_GTrsf map = curve->Location();
  for (CadPoint& x : rail.points) {
    gp_XYZ image(x[0], x[1], x[2]);
    map.Transforms(image);
    x = point_of(image);
  }
  return rail;
}

CadRail IgesCurves::through_occt(const Handle(IGESData_IGESEntity) & curve) const {
  IGESToBRep_BasicCurve reader;
  reader.SetModel(model_);
  reader.SetTransferProcess(process_);
  const Handle(Geom_Curve) geometry = reader.TransferBasicCurve(curve);
  if (geometry.IsNull()) throw Unreadable("its curve is an IGES entity " + std::to_string(curve->TypeNumber()));
  auto [rail, part] = rail_of(geometry, {geometry->FirstParameter(), geometry->LastParameter()});
  rail.part = part;
  return rail;
}

}  // namespace torse::cad
