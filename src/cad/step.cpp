// STEP: the faces of a file and the surfaces that belong to none; its curves.
#include <BRep_Tool.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Interface_Protocol.hxx>
#include <Interface_Static.hxx>
#include <Precision.hxx>
#include <STEPConstruct_UnitContext.hxx>
#include <STEPControl_Reader.hxx>
#include <StepData_GlobalFactors.hxx>
#include <StepData_StepModel.hxx>
#include <StepGeom_Curve.hxx>
#include <StepGeom_GeomRepContextAndGlobUnitAssCtxAndGlobUncertaintyAssCtx.hxx>
#include <StepGeom_GeometricRepresentationContextAndGlobalUnitAssignedContext.hxx>
#include <StepGeom_Surface.hxx>
#include <StepRepr_GlobalUncertaintyAssignedContext.hxx>
#include <StepRepr_GlobalUnitAssignedContext.hxx>
#include <StepRepr_Representation.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepShape_Face.hxx>
#include <StepShape_FaceSurface.hxx>
#include <StepToGeom.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <map>
#include <set>

#include "torse/cad/curves.hpp"
#include "torse/cad/face.hpp"
#include "torse/cad/read.hpp"
#include "torse/cad/step_net.hpp"

namespace torse::cad {
namespace {

using Entity = Handle(Standard_Transient);

template <class T>
Handle(T) as(const Entity& object) {
  return Handle(T)::DownCast(object);
}

/// Lengths in metres and angles in radians, and the uncertainty in the same unit of length; 0 where a file says
/// nothing.
struct Units {
  double metres = 0;
  double radians = 1;
  double tolerance = 0;
};

Units units_of(const Handle(StepRepr_RepresentationContext) & context) {
  Handle(StepRepr_GlobalUnitAssignedContext) units = as<StepRepr_GlobalUnitAssignedContext>(context);
  Handle(StepRepr_GlobalUncertaintyAssignedContext) uncertainty;
  if (const auto both = as<StepGeom_GeomRepContextAndGlobUnitAssCtxAndGlobUncertaintyAssCtx>(context); !both.IsNull()) {
    units = both->GlobalUnitAssignedContext();
    uncertainty = both->GlobalUncertaintyAssignedContext();
  } else if (const auto one = as<StepGeom_GeometricRepresentationContextAndGlobalUnitAssignedContext>(context);
             !one.IsNull()) {
    units = one->GlobalUnitAssignedContext();
  }
  Units result;
  if (units.IsNull()) return result;
  STEPConstruct_UnitContext factors;
  factors.ComputeFactors(units);
  if (factors.LengthDone()) result.metres = exact_metres(factors.LengthFactor() / 1000);  // its unit is the millimetre
  if (factors.PlaneAngleDone()) result.radians = factors.PlaneAngleFactor();
  if (!uncertainty.IsNull()) {
    factors.ComputeTolerance(uncertainty);
    if (factors.HasUncertainty()) result.tolerance = factors.Uncertainty();
  }
  return result;
}

/// A face or a surface of the file, with where it stands.
struct Item {
  Entity entity{};
  Handle(StepGeom_Surface) surface{};
  std::string name{};
  Units units{};
};

std::string text_of(const Handle(TCollection_HAsciiString) & name) { return name.IsNull() ? "" : name->ToCString(); }

class StepFile {
 public:
  explicit StepFile(const std::string& path) {
    Interface_Static::SetCVal("read.step.sequence", "none");
    if (reader_.ReadFile(path.c_str()) != IFSelect_RetDone || reader_.StepModel().IsNull()) {
      throw Unreadable("expected a STEP file, found what OpenCASCADE cannot read");
    }
    model_ = reader_.StepModel();
    if (model_->NbEntities() == 0) throw Unreadable("expected an entity, found none");
  }

  CadModel read() {
    const Interface_Graph graph(model_, reader_.WS()->Protocol());
    const std::vector<Item> items = find_items(graph);
    const Units units = main_units(items);
    for (const Item& item : items) {
      if (!item.surface.IsNull()) require_sound_below(graph, item.surface);
    }
    transfer(units);
    CadModel model{.unit = unit_name(units.metres), .metres = units.metres, .tolerance = units.tolerance};
    for (const Item& item : items) add(item, units, model);
    return model;
  }

  CadCurves read_curves() {
    const Interface_Graph graph(model_, reader_.WS()->Protocol());
    Units units;
    for (int i = 1; i <= model_->NbEntities(); ++i) {
      const Entity entity = model_->Value(i);
      if (entity->IsKind(STANDARD_TYPE(StepGeom_Curve))) require_sound_below(graph, entity);
      const auto representation = as<StepRepr_Representation>(entity);
      if (!representation.IsNull() && !(units.metres > 0)) units = units_of(representation->ContextOfItems());
    }
    if (!(units.metres > 0)) units.metres = 1e-3;
    transfer(units);
    CadCurves curves{.unit = unit_name(units.metres), .metres = units.metres, .tolerance = units.tolerance};
    const CurveNames names = names_of_shapes();
    for (int i = 1; i <= reader_.NbShapes(); ++i) add_curves(reader_.Shape(i), names, curves);
    return curves;
  }

 private:
  CurveNames names_of_shapes() const {
    const Handle(Transfer_TransientProcess) process = reader_.WS()->TransferReader()->TransientProcess();
    CurveNames names;
    for (int i = 1; i <= model_->NbEntities(); ++i) {
      const auto item = as<StepRepr_RepresentationItem>(model_->Value(i));
      if (item.IsNull() || text_of(item->Name()).empty()) continue;
      const TopoDS_Shape shape = TransferBRep::ShapeResult(process, item);
      if (!shape.IsNull()) names[shape.TShape().get()] = text_of(item->Name());
    }
    return names;
  }

  /// In the order of the file.
  std::vector<Item> find_items(const Interface_Graph& graph) const {
    std::vector<Item> items;
    for (int i = 1; i <= model_->NbEntities(); ++i) {
      const Entity entity = model_->Value(i);
      if (const auto face = as<StepShape_FaceSurface>(entity); !face.IsNull()) {
        items.push_back({entity, face->FaceGeometry(), text_of(face->Name()), context_above(graph, entity)});
      } else if (const auto surface = as<StepGeom_Surface>(entity); !surface.IsNull() && alone(graph, entity)) {
        items.push_back({entity, surface, text_of(surface->Name()), context_above(graph, entity)});
      }
    }
    return items;
  }

  /// OpenCASCADE reads what is no number as 0: a surface of which any part does not fit its definition is refused.
  void require_sound_below(const Interface_Graph& graph, const Entity& top) {
    std::vector<Entity> rest{top};
    while (!rest.empty()) {
      const Entity entity = rest.back();
      rest.pop_back();
      if (!sound_.insert(entity.get()).second) continue;
      require_sound(model_, entity);
      for (Interface_EntityIterator below = graph.Shareds(entity); below.More(); below.Next())
        rest.push_back(below.Value());
    }
  }

  /// Whether a surface is neither that of a face nor a part of other geometry.
  static bool alone(const Interface_Graph& graph, const Entity& surface) {
    for (Interface_EntityIterator above = graph.Sharings(surface); above.More(); above.Next()) {
      const Entity& user = above.Value();
      if (user->IsKind(STANDARD_TYPE(StepShape_Face)) || user->IsKind(STANDARD_TYPE(StepGeom_Surface)) ||
          user->IsKind(STANDARD_TYPE(StepGeom_Curve))) {
        return false;
      }
    }
    return true;
  }

  /// The units of the representation that an entity belongs to, directly or through others.
  static Units context_above(const Interface_Graph& graph, const Entity& entity) {
    std::set<int> seen;
    std::vector<Entity> level{entity};
    while (!level.empty()) {
      std::vector<Entity> next;
      for (const Entity& below : level) {
        for (Interface_EntityIterator above = graph.Sharings(below); above.More(); above.Next()) {
          if (!seen.insert(graph.EntityNumber(above.Value())).second) continue;
          if (const auto representation = as<StepRepr_Representation>(above.Value()); !representation.IsNull()) {
            if (const Units units = units_of(representation->ContextOfItems()); units.metres > 0) return units;
          }
          next.push_back(above.Value());
        }
      }
      level = std::move(next);
    }
    return {};
  }

  /// Those of the first face that has some, millimetres where none has.
  static Units main_units(const std::vector<Item>& items) {
    for (const Item& item : items) {
      if (item.units.metres > 0) return item.units;
    }
    return {.metres = 1e-3};
  }

  /// All shapes in the main unit, so that OpenCASCADE scales by 1.
  void transfer(const Units& units) {
    reader_.SetSystemLengthUnit(units.metres * 1000);
    reader_.TransferRoots();
    for (int i = 1; i <= reader_.NbShapes(); ++i) {
      for (TopExp_Explorer faces(reader_.Shape(i), TopAbs_FACE); faces.More(); faces.Next()) {
        instances_[faces.Current().TShape().get()].push_back(TopoDS::Face(faces.Current()));
      }
    }
  }

  /// The faces that an entity has become, at all places where it stands.
  std::vector<TopoDS_Face> faces_of(const Item& item) {
    const Handle(Transfer_TransientProcess) process = reader_.WS()->TransferReader()->TransientProcess();
    TopoDS_Shape shape = TransferBRep::ShapeResult(process, item.entity);
    if (shape.IsNull() && reader_.TransferEntity(item.entity)) shape = TransferBRep::ShapeResult(process, item.entity);
    if (shape.IsNull() || shape.ShapeType() != TopAbs_FACE) return {};
    const auto found = instances_.find(shape.TShape().get());
    if (found == instances_.end()) return {TopoDS::Face(shape.Located(TopLoc_Location()))};
    return found->second;
  }

  void add(const Item& item, const Units& main, CadModel& model) {
    const double scale = item.units.metres > 0 ? item.units.metres / main.metres : 1;
    const std::vector<TopoDS_Face> faces = faces_of(item);
    for (std::size_t i = 0; i < std::max<std::size_t>(faces.size(), 1); ++i) {
      CadFace face{.number = static_cast<int>(model.faces.size()) + 1, .name = item.name};
      if (item.surface.IsNull()) throw Unreadable(without_surface(face.number, model_, model_->Number(item.entity)));
      if (faces.empty()) {
        fill(item, nullptr, main, face);
        face.placement = placement_of(gp_Trsf(), scale);
        if (item.entity != Entity(item.surface)) face.remark = "its boundary cannot be used: the whole surface";
      } else {
        fill(item, &faces[i], main, face);
        const bool net = item.surface->IsKind(STANDARD_TYPE(StepGeom_BSplineSurface));
        face.placement = placement_of(faces[i].Location().Transformation(), net ? scale : 1);
      }
      model.faces.push_back(std::move(face));
    }
  }

  /// B-spline surfaces come from the entity, number for number; others from the face, in the main unit, or from the
  /// entity where there is none.
  void fill(const Item& item, const TopoDS_Face* shape, const Units& main, CadFace& face) const {
    std::optional<Box> box;
    if (shape != nullptr)
      box = box_of(TopoDS::Face(shape->Located(TopLoc_Location())), std::max(main.tolerance, Precision::Confusion()));
    if (const auto spline = as<StepGeom_BSplineSurface>(item.surface); !spline.IsNull()) {
      return add_net(net_of_step(spline), box, face);
    }
    if (shape != nullptr) {
      TopLoc_Location location;
      return add_surface(BRep_Tool::Surface(*shape, location), box, face);
    }
    StepData_GlobalFactors::Intance().InitializeFactors(1, item.units.radians, 1);
    add_surface(StepToGeom::MakeSurface(item.surface), std::nullopt, face);
  }

  STEPControl_Reader reader_;
  Handle(StepData_StepModel) model_;
  std::map<const Standard_Transient*, std::vector<TopoDS_Face>> instances_;
  std::set<const Standard_Transient*> sound_;
};

}  // namespace

CadModel read_step(const std::string& path) { return StepFile(path).read(); }

CadCurves read_step_curves(const std::string& path) { return StepFile(path).read_curves(); }

}  // namespace torse::cad
