// Where the entities of an IGES file stand.
//   places_of      the maps of the instances that an entity belongs to       placement_of      such a map
#pragma once

#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Graph.hxx>
#include <gp_GTrsf.hxx>
#include <vector>

#include "torse/io/cad.hpp"

namespace torse::cad {

/// The rows (A | b) of a map x -> A x + b.
CadPlacement placement_of(const gp_GTrsf& map);

/// The maps by which instances of subfigures (408) and of solids (430, 184) place an entity, through any number of them
/// and each map once; the identity where there is none. The entity's own matrix is not among them. Throws
/// Unreadable for a matrix that did not fit its definition, for an instance that is a part of itself, and for more than
/// 1000 instances within each other or 200000 steps through them.
std::vector<gp_GTrsf> places_of(const Handle(IGESData_IGESModel) & model, const Interface_Graph& graph,
                                const Handle(IGESData_IGESEntity) & entity);

}  // namespace torse::cad
