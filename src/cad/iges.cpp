// IGES: trimmed and bounded surfaces, faces of solids, and the surfaces that belong to none; curves.
#include <BRep_Tool.hxx>
#include <IGESBasic_Name.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESData_IGESModel.hxx>
#include <IGESData_TransfEntity.hxx>
#include <IGESGeom_BSplineSurface.hxx>
#include <IGESGeom_BoundedSurface.hxx>
#include <IGESGeom_Line.hxx>
#include <IGESGeom_RuledSurface.hxx>
#include <IGESGeom_SurfaceOfRevolution.hxx>
#include <IGESGeom_TabulatedCylinder.hxx>
#include <IGESGeom_TrimmedSurface.hxx>
#include <IGESSolid_Face.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <Interface_Protocol.hxx>
#include <Interface_Static.hxx>
#include <Precision.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TransferBRep.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <gp_GTrsf.hxx>
#include <string_view>

#include "torse/cad/curves.hpp"
#include "torse/cad/face.hpp"
#include "torse/cad/iges_curve.hpp"
#include "torse/cad/iges_places.hpp"
#include "torse/cad/iges_weights.hpp"
#include "torse/cad/read.hpp"

namespace torse::cad {
namespace {

using Entity = Handle(IGESData_IGESEntity);

template <class T>
Handle(T) as(const Handle(Standard_Transient) & object) {
  return Handle(T)::DownCast(object);
}

/// The surface types of IGES, by entity number.
bool is_surface(int type) {
  constexpr int types[] = {108, 114, 118, 120, 122, 128, 140, 190, 192, 194, 196, 198};
  return std::ranges::find(types, type) != std::end(types);
}

/// The curve types.
bool is_curve(int type) {
  constexpr int types[] = {100, 102, 104, 106, 110, 112, 126};
  return std::ranges::find(types, type) != std::end(types);
}

/// Instances of subfigures and solids: what they place would stand elsewhere without them.
bool is_instance(int type) { return type == 184 || type == 408 || type == 430; }

/// Entities whose surface is a part of them: curves on it, offsets, trimmed surfaces, faces.
bool takes_up(int type) {
  constexpr int types[] = {130, 140, 141, 142, 143, 144, 508, 510};
  return std::ranges::find(types, type) != std::end(types);
}

std::string trimmed_text(const Handle(TCollection_HAsciiString) & text) {
  if (text.IsNull()) return {};
  std::string_view name = text->ToCString();
  while (!name.empty() && name.front() == ' ') name.remove_prefix(1);
  while (!name.empty() && name.back() == ' ') name.remove_suffix(1);
  return std::string(name);
}

/// The name property, or label and subscript.
std::string name_of(const Entity& entity) {
  for (Interface_EntityIterator properties = entity->Properties(); properties.More(); properties.Next()) {
    if (const auto name = as<IGESBasic_Name>(properties.Value()); !name.IsNull()) return trimmed_text(name->Value());
  }
  std::string name = trimmed_text(entity->ShortLabel());
  const int subscript = entity->SubScriptNumber();  // 0 for none
  if (!name.empty() && subscript > 0) name += "(" + std::to_string(subscript) + ")";
  return name;
}

Net net_of_iges(const IGESGeom_BSplineSurface& surface) {
  Net net{.degree_u = surface.DegreeU(), .degree_v = surface.DegreeV()};
  net.columns = static_cast<std::size_t>(surface.NbPolesV());
  for (int i = -surface.DegreeU(); i <= surface.UpperIndexU() + 1; ++i) net.knots_u.push_back(surface.KnotU(i));
  for (int j = -surface.DegreeV(); j <= surface.UpperIndexV() + 1; ++j) net.knots_v.push_back(surface.KnotV(j));
  for (int i = 0; i <= surface.UpperIndexU(); ++i) {
    for (int j = 0; j <= surface.UpperIndexV(); ++j) {
      net.points.push_back(point_of(surface.Pole(i, j).XYZ()));
      net.weights.push_back(surface.IsPolynomial() ? 1 : surface.Weight(i, j));
    }
  }
  return net;
}

/// What bounds a surface: the entity itself, and the face that OpenCASCADE makes of it; where instances place it.
struct Item {
  Entity entity{};
  Entity surface{};
  gp_GTrsf place{};

  bool bounded() const { return entity != surface; }
};

class IgesFile {
 public:
  explicit IgesFile(const std::string& path) {
    Interface_Static::SetCVal("read.iges.sequence", "none");
    Interface_Static::SetIVal("read.iges.bspline.continuity", 0);
    if (reader_.ReadFile(path.c_str()) != IFSelect_RetDone || reader_.IGESModel().IsNull()) {
      throw Unreadable("expected an IGES file, found what OpenCASCADE cannot read");
    }
    model_ = reader_.IGESModel();
    if (model_->NbEntities() == 0) throw Unreadable("expected an entity, found none");
    restore_weights(path, model_);
    // OpenCASCADE scales to its own unit: let that be the file's, so that the factor is 1.
    millimetres_ = model_->GlobalSection().UnitValue();
    if (!(millimetres_ > 0)) millimetres_ = 1;
    model_->ChangeGlobalSection().SetCascadeUnit(millimetres_);
  }

  CadModel read() {
    const double metres = exact_metres(millimetres_ / 1000);
    CadModel model{.unit = unit_name(metres), .metres = metres, .tolerance = model_->GlobalSection().Resolution()};
    tolerance_ = std::max(model.tolerance, Precision::Confusion());
    for (const Item& item : find_items()) {
      CadFace face{.number = static_cast<int>(model.faces.size()) + 1, .name = name_of(item.entity)};
      if (item.surface.IsNull()) throw Unreadable(without_surface(face.number, model_, model_->Number(item.entity)));
      require_sound(model_, item.surface);
      if (item.surface->HasTransf()) require_sound(model_, item.surface->Transf());
      if (face.name.empty()) face.name = name_of(item.surface);
      fill(item, face);
      model.faces.push_back(std::move(face));
    }
    return model;
  }

  CadCurves read_curves() {
    const double metres = exact_metres(millimetres_ / 1000);
    CadCurves curves{.unit = unit_name(metres), .metres = metres, .tolerance = model_->GlobalSection().Resolution()};
    for (int i = 1; i <= model_->NbEntities(); ++i) {
      const Entity entity = as<IGESData_IGESEntity>(model_->Value(i));
      if (!entity.IsNull() && is_curve(entity->TypeNumber())) require_sound(model_, entity);
    }
    reader_.TransferRoots();
    const Handle(Transfer_TransientProcess) process = reader_.WS()->TransferReader()->TransientProcess();
    CurveNames names;
    for (int i = 1; i <= model_->NbEntities(); ++i) {
      const Entity entity = as<IGESData_IGESEntity>(model_->Value(i));
      if (entity.IsNull() || !is_curve(entity->TypeNumber())) continue;
      const TopoDS_Shape shape = TransferBRep::ShapeResult(process, entity);
      if (!shape.IsNull()) names[shape.TShape().get()] = name_of(entity);
    }
    for (int i = 1; i <= reader_.NbShapes(); ++i) add_curves(reader_.Shape(i), names, curves);
    return curves;
  }

 private:
  /// In the order of the file, once for each place.
  std::vector<Item> find_items() const {
    const Interface_Graph graph(model_, reader_.WS()->Protocol());
    std::vector<Item> items;
    for (int i = 1; i <= model_->NbEntities(); ++i) {
      const Entity entity = as<IGESData_IGESEntity>(model_->Value(i));
      if (entity.IsNull()) continue;
      if (is_instance(entity->TypeNumber())) require_sound(model_, entity);
      const auto add = [&](const Entity& surface) {
        for (const gp_GTrsf& place : places_of(model_, graph, entity)) items.push_back({entity, surface, place});
      };
      if (const auto trimmed = as<IGESGeom_TrimmedSurface>(entity); !trimmed.IsNull()) {
        add(trimmed->Surface());
      } else if (const auto bounded = as<IGESGeom_BoundedSurface>(entity); !bounded.IsNull()) {
        add(bounded->Surface());
      } else if (const auto face = as<IGESSolid_Face>(entity); !face.IsNull()) {
        add(face->Surface());
      } else if (is_surface(entity->TypeNumber()) && alone(graph, entity)) {
        add(entity);
      }
    }
    return items;
  }

  static bool alone(const Interface_Graph& graph, const Entity& surface) {
    for (Interface_EntityIterator above = graph.Sharings(surface); above.More(); above.Next()) {
      const Entity user = as<IGESData_IGESEntity>(above.Value());
      if (!user.IsNull() && takes_up(user->TypeNumber())) return false;
    }
    return true;
  }

  /// A trimmed surface without curves ends where its surface does.
  static bool has_boundary(const Entity& entity) {
    const auto trimmed = as<IGESGeom_TrimmedSurface>(entity);
    if (!trimmed.IsNull()) return trimmed->HasOuterContour() || trimmed->NbInnerContours() > 0;
    return !entity->IsKind(STANDARD_TYPE(IGESGeom_RuledSurface));
  }

  /// The face that OpenCASCADE makes of an entity; null where it makes none, or several.
  TopoDS_Face face_of(const Entity& entity) {
    reader_.TransferEntity(entity);
    const TopoDS_Shape shape = TransferBRep::ShapeResult(reader_.WS()->TransferReader()->TransientProcess(), entity);
    if (shape.IsNull()) return {};
    TopExp_Explorer faces(shape, TopAbs_FACE);
    if (!faces.More()) return {};
    const TopoDS_Face face = TopoDS::Face(faces.Current());
    faces.Next();
    return faces.More() ? TopoDS_Face() : face;
  }

  /// Ruled surfaces and B-spline surfaces number for number, straight lines that turn and tabulated cylinders from
  /// their entities; the others, and the boundaries, as OpenCASCADE has them.
  void fill(const Item& item, CadFace& face) {
    const bool whole = !item.bounded();
    if (const auto spline = as<IGESGeom_BSplineSurface>(item.surface); !spline.IsNull()) {
      place(item, face);
      return add_net(net_of_iges(*spline), box_on(item, *spline, face), face);
    }
    if (const auto ruled = as<IGESGeom_RuledSurface>(item.surface); !ruled.IsNull()) {
      place(item, face);
      return add_ruled(*ruled, item, face);
    }
    if (const auto turned = as<IGESGeom_SurfaceOfRevolution>(item.surface); !turned.IsNull() && whole) {
      if (add_turned(*turned, face)) return place(item, face);
    }
    if (const auto moved = as<IGESGeom_TabulatedCylinder>(item.surface); !moved.IsNull() && whole) {
      place(item, face);
      return add_moved(*moved, face);
    }
    const TopoDS_Face shape = face_of(item.entity);
    if (shape.IsNull()) {
      face.type = "entity " + std::to_string(item.surface->TypeNumber());
      face.reason = "OpenCASCADE makes no single face of it";
      return;
    }
    gp_GTrsf map = item.place;
    map.Multiply(gp_GTrsf(shape.Location().Transformation()));
    face.placement = placement_of(map);
    TopLoc_Location location;
    const TopoDS_Face local = TopoDS::Face(shape.Located(TopLoc_Location()));
    add_surface(BRep_Tool::Surface(shape, location), box_of(local, tolerance_), face);
  }

  /// The maps of the surface, of what bounds it and of its instance.
  static void place(const Item& item, CadFace& face) {
    gp_GTrsf map = item.place;
    if (item.bounded()) map.Multiply(item.entity->Location());
    map.Multiply(item.surface->Location());
    face.placement = placement_of(map);
  }

  /// The parameters of a spline surface's boundary, or those between which the entity uses its knots.
  std::optional<Box> box_on(const Item& item, const IGESGeom_BSplineSurface& spline, CadFace& face) {
    // The file has U(0), U(1), V(0), V(1); OpenCASCADE 7.6 takes the second for the least v and the third for the
    // largest u.
    const Box used{{spline.UMin(), spline.VMin()}, {spline.UMax(), spline.VMax()}};
    if (!item.bounded()) return used;
    const TopoDS_Face shape = face_of(item.entity);
    if (!shape.IsNull()) return box_of(TopoDS::Face(shape.Located(TopLoc_Location())), tolerance_);
    face.remark = "its boundary cannot be used: the whole surface";
    return used;
  }

  void add_ruled(const IGESGeom_RuledSurface& ruled, const Item& item, CadFace& face) {
    face.type = "ruled surface";
    face.claimed_developable = ruled.IsDevelopable();
    face.by_arc_length = !ruled.IsRuledByParameter();
    if (has_boundary(item.entity)) face.remark = "its boundary is not used: the whole ruled surface";
    CadRails rails;
    try {
      const IgesCurves curves = make_curves();
      rails = {curves.rail(ruled.FirstCurve()), curves.rail(ruled.SecondCurve())};
    } catch (const Unreadable& error) {
      face.reason = error.what();
      return;
    }
    if (ruled.DirectionFlag() == 1) rails.d.reversed = !rails.d.reversed;
    face.strips.push_back({std::move(rails), std::nullopt, std::nullopt});
  }

  /// Whether the generatrix is a straight line, so that the axis and its two points are all there is.
  bool add_turned(const IGESGeom_SurfaceOfRevolution& turned, CadFace& face) const {
    const Handle(IGESGeom_Line) axis = turned.AxisOfRevolution();
    const auto line = as<IGESGeom_Line>(turned.Generatrix());
    if (axis.IsNull() || line.IsNull()) return false;
    face.type = "revolution";
    const CadRail ends = make_curves().rail(line);
    const CadRail on_axis = make_curves().rail(axis);
    CadPoint along{};
    for (std::size_t i = 0; i < 3; ++i) along[i] = on_axis.points[1][i] - on_axis.points[0][i];
    add_revolution({on_axis.points[0], along, {turned.StartAngle(), turned.EndAngle()}}, ends.points, face);
    return true;
  }

  void add_moved(const IGESGeom_TabulatedCylinder& moved, CadFace& face) const {
    face.type = "extrusion";
    CadRail rail;
    try {
      rail = make_curves().rail(moved.Directrix());
    } catch (const Unreadable& error) {
      face.reason = error.what();
      return;
    }
    const CadExtrusion extrusion{std::move(rail), {}, point_of(moved.EndPoint().XYZ())};
    face.strips.push_back({extrusion, std::nullopt, std::nullopt});
  }

  IgesCurves make_curves() const { return {model_, reader_.WS()->TransferReader()->TransientProcess()}; }

  IGESControl_Reader reader_;
  Handle(IGESData_IGESModel) model_;
  double millimetres_ = 1;
  double tolerance_ = 0;
};

}  // namespace

CadModel read_iges(const std::string& path) { return IgesFile(path).read(); }

CadCurves read_iges_curves(const std::string& path) { return IgesFile(path).read_curves(); }

}  // namespace torse::cad
