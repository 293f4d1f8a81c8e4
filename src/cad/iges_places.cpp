#include "torse/cad/iges_places.hpp"

#include <IGESBasic_SingularSubfigure.hxx>
#include <IGESGeom_TransformationMatrix.hxx>
#include <IGESSolid_SolidAssembly.hxx>
#include <Interface_EntityIterator.hxx>
#include <algorithm>
#include <set>
#include <string>

#include "torse/cad/face.hpp"
#include "torse/cad/read.hpp"

namespace torse::cad {
namespace {

using Entity = Handle(IGESData_IGESEntity);
using Maps = std::vector<gp_GTrsf>;

constexpr int definition = 308;

/// Ways from a surface up through its instances, each step counted, and how many lie within each other.
constexpr std::size_t most_steps = 200'000;
constexpr std::size_t deepest = 1000;

/// Solids (186), their shells (514) and instances (430), assemblies of solids (184), definitions of subfigures (308)
/// and their instances.
bool holds(int type) {
  constexpr int types[] = {184, 186, definition, 408, 430, 514};
  return std::ranges::find(types, type) != std::end(types);
}

gp_GTrsf product(gp_GTrsf outer, const gp_GTrsf& inner) {
  outer.Multiply(inner);
  return outer;
}

/// x -> matrix (scale x) + translation: the translation is in the space where the instance is used, as OpenCASCADE has
/// it for curves.
gp_GTrsf map_of(const IGESBasic_SingularSubfigure& use) {
  gp_GTrsf scaled;
  const double scale = use.HasScaleFactor() ? use.ScaleFactor() : 1;
  for (int i = 1; i <= 3; ++i) scaled.SetValue(i, i, scale);
  gp_GTrsf map = product(use.Location(), scaled);
  map.SetTranslationPart(map.TranslationPart() + use.Translation());
  return map;
}

/// The maps by which one entity holds another; more than one in an assembly only.
Maps maps_between(const Handle(IGESData_IGESModel) & model, const Entity& outer, const Entity& inner) {
  if (const auto use = Handle(IGESBasic_SingularSubfigure)::DownCast(outer); !use.IsNull()) return {map_of(*use)};
  const gp_GTrsf own = outer->Location();
  const auto assembly = Handle(IGESSolid_SolidAssembly)::DownCast(outer);
  if (assembly.IsNull()) return {own};
  Maps maps;
  for (int i = 1; i <= assembly->NbItems(); ++i) {
    if (assembly->Item(i) != inner) continue;
    const Handle(IGESGeom_TransformationMatrix) matrix = assembly->TransfMatrix(i);
    if (!matrix.IsNull()) require_sound(model, matrix);
    maps.push_back(matrix.IsNull() ? own : product(own, matrix->Value()));
  }
  return maps;
}

/// Walks from an entity up to those that nothing holds.
class Walk {
 public:
  Walk(const Handle(IGESData_IGESModel) & model, const Interface_Graph& graph) : model_(model), graph_(graph) {}

  void go(const Entity& entity, const gp_GTrsf& map) {
    if (std::ranges::find(path_, entity) != path_.end()) {
      throw Unreadable("expected instances that are no parts of themselves");
    }
    if (path_.size() == deepest || ++steps_ > most_steps) {
      throw Unreadable("expected instances at most " + std::to_string(deepest) + " deep, and at most " +
                       std::to_string(most_steps) + " steps through those of a surface");
    }
    path_.push_back(entity);
    bool top = true;
    for (Interface_EntityIterator above = graph_.Sharings(entity); above.More(); above.Next()) {
      const Entity user = Entity::DownCast(above.Value());
      if (user.IsNull() || !holds(user->TypeNumber())) continue;
      top = false;
      if (user->HasTransf()) require_sound(model_, user->Transf());
      for (const gp_GTrsf& step : maps_between(model_, user, entity)) go(user, product(step, map));
    }
    // A definition is nowhere by itself.
    if (top && entity->TypeNumber() != definition) add(map);
    path_.pop_back();
  }

  Maps found() const { return maps_.empty() ? Maps{gp_GTrsf()} : maps_; }

 private:
  void add(const gp_GTrsf& map) {
    if (seen_.insert(placement_of(map)).second) maps_.push_back(map);
  }

  Handle(IGESData_IGESModel) model_;
  const Interface_Graph& graph_;
  std::vector<Entity> path_;
  std::size_t steps_ = 0;
  std::set<CadPlacement> seen_;
  Maps maps_;
};

}  // namespace

CadPlacement placement_of(const gp_GTrsf& map) {
  CadPlacement placement{};
  for (int row = 1; row <= 3; ++row) {
    for (int column = 1; column <= 4; ++column) {
      placement[static_cast<std::size_t>(row - 1)][static_cast<std::size_t>(column - 1)] = map.Value(row, column);
    }
  }
  return placement;
}

std::vector<gp_GTrsf> places_of(const Handle(IGESData_IGESModel) & model, const Interface_Graph& graph,
                                const Handle(IGESData_IGESEntity) & entity) {
  Walk walk(model, graph);
  walk.go(entity, gp_GTrsf());
  return walk.found();
}

}  // namespace torse::cad
