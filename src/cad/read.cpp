// What is the same for both formats.
#include "torse/cad/read.hpp"

#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Surface.hxx>
#include <IGESControl_Reader.hxx>
#include <Interface_Check.hxx>
#include <STEPControl_Reader.hxx>
#include <ShapeFix_Face.hxx>
#include <algorithm>
#include <gp_Trsf.hxx>
#include <sstream>

#include "torse/cad/face.hpp"

namespace torse::cad {
namespace {

struct Unit {
  double metres;
  const char* name;
};

/// Units are products of a few decimals: what differs by a few roundings is the same.
const Unit* find_unit(double metres) {
  static constexpr Unit units[] = {{1e-3, "mm"},     {1e-2, "cm"},     {1, "m"},       {1e3, "km"},
                                   {1e-6, "um"},     {0.0254, "inch"}, {0.3048, "ft"}, {1609.344, "mile"},
                                   {2.54e-5, "mil"}, {2.54e-8, "uin"}};
  for (const Unit& unit : units) {
    if (metres > unit.metres * (1 - 1e-9) && metres < unit.metres * (1 + 1e-9)) return &unit;
  }
  return nullptr;
}

}  // namespace

CadModel read_model(CadFormat format, const std::string& path) {
  CadModel model = format == CadFormat::step ? read_step(path) : read_iges(path);
  if (model.faces.empty()) throw Unreadable("expected a face or a surface, found none");
  return model;
}

std::string complaint_of(const Handle(Interface_InterfaceModel) & model, int number) {
  if (number < 1 || number > model->NbEntities()) return {};
  const Handle(Interface_Check) check = model->Check(number, true);
  if (check.IsNull() || !check->HasFailed()) return {};
  std::ostringstream label;
  model->Print(model->Value(number), label, 1);
  const std::string text = label.str();
  return text.substr(std::min(text.find_first_not_of(' '), text.size())) + ": " + check->CFail(1);
}

std::string first_complaint(CadFormat format, const std::string& path) {
  STEPControl_Reader step;
  IGESControl_Reader iges;
  XSControl_Reader& reader = format == CadFormat::step ? static_cast<XSControl_Reader&>(step) : iges;
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone || reader.Model().IsNull()) return {};
  const Handle(Interface_InterfaceModel) model = reader.Model();
  for (int i = 1; i <= model->NbEntities(); ++i) {
    if (std::string text = complaint_of(model, i); !text.empty()) return text;
  }
  return {};
}

CadPlacement placement_of(const gp_Trsf& map, double scale) {
  CadPlacement placement{};
  for (int row = 1; row <= 3; ++row) {
    for (int column = 1; column <= 4; ++column) {
      placement[static_cast<std::size_t>(row - 1)][static_cast<std::size_t>(column - 1)] =
          map.Value(row, column) * (column < 4 ? scale : 1);
    }
  }
  return placement;
}

std::optional<Box> box_of(const TopoDS_Face& given, double tolerance) {
  if (given.IsNull() || BRep_Tool::Surface(given).IsNull()) return std::nullopt;
  ShapeFix_Face fix(given);
  fix.Perform();
  const TopoDS_Face face = fix.Face();
  Box box;
  BRepTools::UVBounds(face, box.u.from, box.u.to, box.v.from, box.v.to);
  const BRepAdaptor_Surface surface(face, false);
  box.u_resolution = surface.UResolution(tolerance);
  box.v_resolution = surface.VResolution(tolerance);
  return box;
}

std::string without_surface(int face, const Handle(Interface_InterfaceModel) & model, int entity) {
  const std::string complaint = complaint_of(model, entity);
  return "expected the surface of face " + std::to_string(face) + (complaint.empty() ? "" : ": " + complaint);
}

void require_sound(const Handle(Interface_InterfaceModel) & model, const Handle(Standard_Transient) & entity) {
  if (const std::string complaint = complaint_of(model, model->Number(entity)); !complaint.empty()) {
    throw Unreadable(complaint);
  }
}

double exact_metres(double metres) {
  const Unit* const unit = find_unit(metres);
  return unit == nullptr ? metres : unit->metres;
}

std::string unit_name(double metres) {
  const Unit* const unit = find_unit(metres);
  return unit == nullptr ? "other" : unit->name;
}

}  // namespace torse::cad
