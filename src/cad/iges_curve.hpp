// Curves of IGES entities as rails.
//   IgesCurves      lines and B-splines number for number, others through OpenCASCADE
#pragma once

#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <Transfer_TransientProcess.hxx>

#include "torse/io/cad.hpp"

namespace torse::cad {

/// Reads the curves of one model, whose unit of length OpenCASCADE must have taken as its own.
class IgesCurves {
 public:
  IgesCurves(Handle(IGESData_IGESModel) model, Handle(Transfer_TransientProcess) process)
      : model_(std::move(model)), process_(std::move(process)) {}

  /// Throws Unreadable for an entity that is no curve or one of more than one piece.
  CadRail rail(const Handle(IGESData_IGESEntity) & curve) const;

 private:
  CadRail through_occt(const Handle(IGESData_IGESEntity) & curve) const;

  Handle(IGESData_IGESModel) model_;
  Handle(Transfer_TransientProcess) process_;
};

}  // namespace torse::cad
