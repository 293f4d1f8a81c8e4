// Surfaces as they come out of a CAD system: nearly developable, or not at all.
//   roughen      the coordinates of one row are moved
#pragma once

#include "torse/fuzz/draw/net.hpp"

namespace torse::fuzz {

/// Moves every coordinate of d by up to 1, 2^-3, 2^-10 or 2^-30. What is known of the net is whether it is developable,
/// by the determinant at parameters.
template <int D>
void roughen(Choices& choices, Net<D>& net);

}  // namespace torse::fuzz
