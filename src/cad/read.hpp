// Reading in the plugin: what the formats share.
//   Unreadable       why a file cannot be used
//   complaint_of     what OpenCASCADE found wrong with an entity         first_complaint     of a file
//   read_model       by format      read_step, read_iges      in the file's own unit
//   read_step_curves, read_iges_curves                        the same of curves that bound no face
#pragma once

#include <Interface_InterfaceModel.hxx>
#include <stdexcept>
#include <string>

#include "torse/io/cad.hpp"

namespace torse::cad {

/// A file that is no use; `what()` completes "FILE: ...".
class Unreadable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// "#57: Parameter n0.2 (position) : Entity has illegal type" of an entity that did not fit its definition when it was
/// read, else empty.
std::string complaint_of(const Handle(Interface_InterfaceModel) & model, int number);

/// The first such entity of a file that is only read, or empty.
std::string first_complaint(CadFormat format, const std::string& path);

/// Each throws Unreadable, and what OpenCASCADE throws.
CadModel read_model(CadFormat format, const std::string& path);
CadModel read_step(const std::string& path);
CadModel read_iges(const std::string& path);
CadCurves read_step_curves(const std::string& path);
CadCurves read_iges_curves(const std::string& path);

}  // namespace torse::cad
