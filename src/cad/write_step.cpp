// STEP (AP214): each surface a B-spline surface of degree (n, 1), one face over all of it or within its outline.
#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepLib.hxx>
#include <GCE2d_MakeSegment.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Interface_Static.hxx>
#include <Precision.hxx>
#include <STEPControl_Writer.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <StepGeom_BSplineSurface.hxx>
#include <StepShape_AdvancedFace.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <sstream>

#include "torse/cad/write.hpp"

namespace torse::cad {
namespace {

/// The largest degree that OpenCASCADE has.
int most_degree() { return Geom_BSplineSurface::MaxDegree(); }

/// The list with each knot once, and how often it is there.
struct Multiplicities {
  std::vector<double> knots;
  std::vector<int> times;
};

Multiplicities multiplicities_of(const std::vector<double>& list) {
  Multiplicities result;
  for (double knot : list) {
    if (result.knots.empty() || result.knots.back() != knot) {
      result.knots.push_back(knot);
      result.times.push_back(0);
    }
    ++result.times.back();
  }
  return result;
}

/// Throws where OpenCASCADE leaves the weights out, since they are equal but for their last digits.
void require_weights(const Geom_BSplineSurface& surface, const CadSheet& sheet) {
  if (surface.IsURational() || surface.IsVRational()) return;
  const auto equal = [&](double w) { return w == sheet.c.weights.front(); };
  if (!std::ranges::all_of(sheet.c.weights, equal) || !std::ranges::all_of(sheet.d.weights, equal)) {
    throw Unwritable("OpenCASCADE takes its weights for equal, which differ in their last digits");
  }
}

Handle(Geom_BSplineSurface) surface_of(const CadSheet& sheet) {
  const int count = static_cast<int>(sheet.c.points.size());
  TColgp_Array2OfPnt poles(1, count, 1, 2);
  TColStd_Array2OfReal weights(1, count, 1, 2);
  for (int i = 1; i <= count; ++i) {
    const std::size_t at = static_cast<std::size_t>(i - 1);
    for (int j : {1, 2}) {
      const CadRail& rail = j == 1 ? sheet.c : sheet.d;
      poles(i, j) = gp_Pnt(rail.points[at][0], rail.points[at][1], rail.points[at][2]);
      weights(i, j) = rail.weights[at];
    }
  }
  const Multiplicities u = multiplicities_of(sheet.c.knots);
  TColStd_Array1OfReal knots(1, static_cast<int>(u.knots.size()));
  TColStd_Array1OfInteger times(1, static_cast<int>(u.knots.size()));
  for (int i = 1; i <= knots.Length(); ++i) {
    knots(i) = u.knots[static_cast<std::size_t>(i - 1)];
    times(i) = u.times[static_cast<std::size_t>(i - 1)];
  }
  TColStd_Array1OfReal ends(1, 2);
  ends(1) = 0;
  ends(2) = 1;
  TColStd_Array1OfInteger twice(1, 2);
  twice.Init(2);
  const Handle(Geom_BSplineSurface) surface =
      new Geom_BSplineSurface(poles, weights, knots, ends, times, twice, sheet.c.degree, 1);
  require_weights(*surface, sheet);
  return surface;
}

/// The sides of the outline as lines in the plane of the parameters. A side of no length is left out.
TopoDS_Wire wire_of(const CadSheet& sheet, const Handle(Geom_BSplineSurface) & surface) {
  BRepBuilderAPI_MakeWire wire;
  for (std::size_t i = 0; i < sheet.outline.size(); ++i) {
    const std::array<double, 2>& a = sheet.outline[i];
    const std::array<double, 2>& b = sheet.outline[(i + 1) % sheet.outline.size()];
    if (a == b) continue;
    const Handle(Geom2d_TrimmedCurve) side = GCE2d_MakeSegment(gp_Pnt2d(a[0], a[1]), gp_Pnt2d(b[0], b[1]));
    wire.Add(BRepBuilderAPI_MakeEdge(side, surface).Edge());
  }
  return wire.Wire();
}

TopoDS_Face trimmed_face(const CadSheet& sheet) {
  const Handle(Geom_BSplineSurface) surface = surface_of(sheet);
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(surface, wire_of(sheet, surface)).Face();
  BRepLib::BuildCurves3d(face);
  return face;
}

TopoDS_Face face_of(const CadSheet& sheet) {
  if (sheet.c.degree > most_degree()) {
    throw Unwritable("its degree is " + std::to_string(sheet.c.degree) + "; OpenCASCADE has " +
                     std::to_string(most_degree()) + " at most");
  }
  if (!sheet.outline.empty()) return trimmed_face(sheet);
  return BRepBuilderAPI_MakeFace(surface_of(sheet), Precision::Confusion()).Face();
}

void set_names(const Handle(StepData_StepModel) & model, const CadSheets& sheets) {
  std::size_t next = 0;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const Handle(StepShape_AdvancedFace) face = Handle(StepShape_AdvancedFace)::DownCast(model->Value(i));
    if (face.IsNull()) continue;
    if (next == sheets.sheets.size()) throw Unwritable("OpenCASCADE splits a face");
    face->SetName(own_string(sheets.sheets[next].name));
    face->FaceGeometry()->SetName(own_string(sheets.sheets[next].name));
    ++next;
  }
  if (next != sheets.sheets.size()) throw Unwritable("OpenCASCADE leaves out a face");
}

void set_header(const Handle(StepData_StepModel) & model) {
  APIHeaderSection_MakeHeader header(model);
  header.SetName(own_string("torse"));
  header.SetOriginatingSystem(own_string("torse"));
  header.SetAuthorValue(1, own_string(""));
  header.SetOrganizationValue(1, own_string(""));
}

}  // namespace

std::string write_step(const CadSheets& sheets) {
  STEPControl_Writer writer;
  Interface_Static::SetCVal("write.step.sequence", "none");
  Interface_Static::SetCVal("write.step.schema", "AP214IS");
  Interface_Static::SetIVal("write.surfacecurve.mode", 0);
  if (!Interface_Static::SetCVal("write.step.unit", sheets.step_unit.c_str())) {
    throw Unwritable("OpenCASCADE writes no STEP file in this unit");
  }
  // Its own unit is that of the file, so that it scales by 1.
  writer.Model(true)->SetLocalLengthUnit(sheets.metres * 1000);
  writer.Model()->SetWriteLengthUnit(sheets.metres * 1000);
  writer.SetTolerance(sheets.tolerance);
  for (const CadSheet& sheet : sheets.sheets) {
    Interface_Static::SetCVal("write.step.product.name", sheet.name.c_str());
    if (writer.Transfer(face_of(sheet), STEPControl_AsIs) != IFSelect_RetDone) {
      throw Unwritable("OpenCASCADE does not translate it to STEP");
    }
  }
  const Handle(StepData_StepModel) model = writer.Model();
  set_names(model, sheets);
  set_header(model);
  StepData_StepWriter text(model);
  text.FloatWriter().SetFormat("%.16E");  // all 17 digits; where zeros are dropped, exponents are too
  text.SendModel(Handle(StepData_Protocol)::DownCast(writer.WS()->Protocol()));
  std::ostringstream bytes;
  if (!text.Print(bytes)) throw Unwritable("OpenCASCADE does not write it");
  return std::move(bytes).str();
}

}  // namespace torse::cad
