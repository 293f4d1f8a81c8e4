// Weights that OpenCASCADE takes for ones.
//   restore_weights      those of the file        told_apart      by a factor that changes no point
#pragma once

#include <IGESData_IGESModel.hxx>
#include <string>
#include <vector>

namespace torse::cad {

/// OpenCASCADE takes an IGES spline for polynomial when none of its weights differs from the first one by more than
/// 1e-10, which is so for all that are tiny, and reads a surface with a weight that is not positive as one with weights
/// 1. Gives the splines of a model that are not marked as polynomial (PROP3) the weights of their file back,
/// `told_apart`. Throws Unreadable where the file cannot be read twice.
void restore_weights(const std::string& path, const Handle(IGESData_IGESModel) & model);

/// The weights times a power of two with which the largest one is at least 1 and the largest difference to the first one
/// more than 1e-10; themselves where that is so without, or where all are equal.
std::vector<double> told_apart(std::vector<double> weights);

}  // namespace torse::cad
