// What STEP and IGES share about faces and units.
//   placement_of     a location as an affine map
//   box_of           the parameters of a face on its surface
//   without_surface, require_sound   errors of entities
//   exact_metres, unit_name        of a unit of length
#pragma once

#include <Interface_InterfaceModel.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Trsf.hxx>
#include <optional>
#include <string>

#include "torse/cad/strips.hpp"

namespace torse::cad {

/// x -> map(scale x).
CadPlacement placement_of(const gp_Trsf& map, double scale);

/// The box of the boundary in the parameters of the face's surface, and the parameters within which a point moves by at
/// most `tolerance`; none for a face without a surface.
std::optional<Box> box_of(const TopoDS_Face& face, double tolerance);

/// The reason why a face that has lost its surface makes a file unreadable.
std::string without_surface(int face, const Handle(Interface_InterfaceModel) & model, int entity);

/// Throws Unreadable for an entity that did not fit its definition: OpenCASCADE has left parts of it empty.
void require_sound(const Handle(Interface_InterfaceModel) & model, const Handle(Standard_Transient) & entity);

/// The length of a unit without the roundings of whoever computed it.
double exact_metres(double metres);

/// The name of a unit of length, "other" for a rare one.
std::string unit_name(double metres);

}  // namespace torse::cad
