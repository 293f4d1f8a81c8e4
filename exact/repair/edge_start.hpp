// An edge of regression traced along a surface that is nearly developable, for constants to start from.
//   traced_constants
#pragma once

#include <optional>
#include <vector>

#include "torse/exact/repair/edge_map.hpp"
#include "torse/exact/repair/frame.hpp"

namespace torse::repair {

/// Constants of the family (edge_map.hpp) for which the net over u, which has one piece of positive length, nearly is
/// one of its nets. Nothing where the equations for them are dependent.
template <int D>
std::optional<std::vector<Real>> traced_constants(const KnotList<Rational>& u, const RealNet<D>& net,
                                                  const EdgeFamily& family);

}  // namespace torse::repair
