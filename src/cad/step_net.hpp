// B-spline surfaces of STEP entities, number for number.
#pragma once

#include <StepGeom_BSplineSurface.hxx>

#include "torse/cad/strips.hpp"

namespace torse::cad {

/// The net as the file has it, with the knots that its kind implies where it states none. Throws Unreadable where
/// references are missing or lists do not fit.
Net net_of_step(const Handle(StepGeom_BSplineSurface) & surface);

}  // namespace torse::cad
