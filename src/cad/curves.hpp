// Curves of shapes: the edges and wires that bound no face.
//   CurveNames       what they are called
//   add_curves       those of a shape, in order
#pragma once

#include <TopoDS_Shape.hxx>
#include <map>
#include <string>

#include "torse/io/cad.hpp"

namespace torse::cad {

/// By the shape that an entity has become, wherever it stands.
using CurveNames = std::map<const Standard_Transient*, std::string>;

/// Adds the edges and wires of a shape, the edges of a wire joined to one curve. What OpenCASCADE cannot use is added
/// with the reason.
void add_curves(const TopoDS_Shape& shape, const CurveNames& names, CadCurves& found);

}  // namespace torse::cad
