// IGES: each surface a ruled surface (entity 118, form 1) between two rational B-spline curves (126).
#include <IGESBasic_Name.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESData_BasicEditor.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <IGESData_IGESWriter.hxx>
#include <IGESData_Protocol.hxx>
#include <IGESGeom_BSplineCurve.hxx>
#include <IGESGeom_HArray1OfCurveOnSurface.hxx>
#include <IGESGeom_RuledSurface.hxx>
#include <IGESGeom_TrimmedSurface.hxx>
#include <IGESSelect_WorkLibrary.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfXYZ.hxx>
#include <algorithm>
#include <sstream>

#include "torse/cad/iges_weights.hpp"
#include "torse/cad/write.hpp"

namespace torse::cad {
namespace {

constexpr std::size_t label_length = 8;

Handle(TColStd_HArray1OfReal) real_array(const std::vector<double>& list, int first) {
  const Handle(TColStd_HArray1OfReal) array =
      new TColStd_HArray1OfReal(first, first + static_cast<int>(list.size()) - 1);
  for (std::size_t i = 0; i < list.size(); ++i) array->SetValue(first + static_cast<int>(i), list[i]);
  return array;
}

Handle(IGESGeom_BSplineCurve) curve_of(const CadRail& rail) {
  const int last = static_cast<int>(rail.points.size()) - 1;
  const Handle(TColgp_HArray1OfXYZ) poles = new TColgp_HArray1OfXYZ(0, last);
  for (int i = 0; i <= last; ++i) {
    const CadPoint& x = rail.points[static_cast<std::size_t>(i)];
    poles->SetValue(i, gp_XYZ(x[0], x[1], x[2]));
  }
  const bool polynomial = std::ranges::all_of(rail.weights, [&](double w) { return w == rail.weights.front(); });
  const bool closed = rail.points.front() == rail.points.back();
  const Handle(IGESGeom_BSplineCurve) curve = new IGESGeom_BSplineCurve;
  curve->Init(last, rail.degree, false, closed, polynomial, false, real_array(rail.knots, -rail.degree),
              real_array(told_apart(rail.weights), 0), poles, rail.knots.front(), rail.knots.back(), gp_XYZ(0, 0, 0));
  return curve;
}

void name(const Handle(IGESData_IGESEntity) & entity, const std::string& text) {
  const Handle(IGESBasic_Name) property = new IGESBasic_Name;
  property->Init(1, own_string(text));
  entity->AddProperty(property);
  const bool ascii = std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~'; });
  if (ascii) entity->SetLabel(own_string(text.substr(0, label_length)));
}

/// The ruled surface within its natural boundary.
Handle(IGESGeom_TrimmedSurface) face_of(const CadSheet& sheet) {
  const Handle(IGESGeom_RuledSurface) ruled = new IGESGeom_RuledSurface;
  ruled->Init(curve_of(sheet.c), curve_of(sheet.d), 0, sheet.developable ? 1 : 0);
  ruled->SetRuledByParameter(true);
  const Handle(IGESGeom_TrimmedSurface) face = new IGESGeom_TrimmedSurface;
  face->Init(ruled, 0, {}, {});
  name(ruled, sheet.name);
  name(face, sheet.name);
  return face;
}

double largest_coordinate(const CadSheets& sheets) {
  double most = 0;
  for (const CadSheet& sheet : sheets.sheets) {
    for (const CadRail* rail : {&sheet.c, &sheet.d}) {
      for (const CadPoint& x : rail->points) {
        for (double value : x) most = std::max(most, std::abs(value));
      }
    }
  }
  return most;
}

void fill_header(const Handle(IGESData_IGESModel) & model, const CadSheets& sheets) {
  IGESData_GlobalSection header = model->GlobalSection();
  header.SetSendName(own_string("torse"));
  header.SetFileName(own_string("torse.igs"));
  header.SetSystemId(own_string("torse"));
  header.SetInterfaceVersion(own_string("torse"));
  header.SetIntegerBits(32);
  header.SetMaxPower10Single(38);
  header.SetMaxDigitsSingle(6);
  header.SetMaxPower10Double(308);
  header.SetMaxDigitsDouble(15);
  header.SetScale(1);
  header.SetLineWeightGrad(1);
  header.SetMaxLineWeight(0.01);
  header.SetIGESVersion(11);
  header.SetDraftingStandard(0);
  header.SetDate(IGESData_GlobalSection::NewDateString(0, 0, 0, 0, 0, 0, 0));
  header.SetLastChangeDate();
  header.SetResolution(sheets.tolerance);
  header.SetMaxCoord(largest_coordinate(sheets));
  model->SetGlobalSection(header);
}

}  // namespace

std::string write_iges(const CadSheets& sheets) {
  IGESControl_Controller::Init();
  const Handle(IGESData_Protocol) protocol = IGESSelect_WorkLibrary::DefineProtocol();
  const Handle(IGESData_IGESModel) model = new IGESData_IGESModel;
  fill_header(model, sheets);
  IGESData_BasicEditor editor(model, protocol);
  if (!editor.SetUnitFlag(sheets.iges_unit)) throw Unwritable("IGES has no such unit");
  for (const CadSheet& sheet : sheets.sheets) model->AddWithRefs(face_of(sheet), protocol);
  editor.ComputeStatus();
  editor.AutoCorrectModel();
  IGESData_IGESWriter text(model);
  text.FloatWriter().SetFormat("%.16E");
  text.FloatWriter().SetZeroSuppress(false);
  text.SendModel(protocol);
  std::ostringstream bytes;
  if (!text.Print(bytes)) throw Unwritable("OpenCASCADE does not write it");
  return std::move(bytes).str();
}

}  // namespace torse::cad
