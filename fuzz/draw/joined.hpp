// Developable nets whose pieces are of different classes.
//   draft_joined       Bezier pieces, each from the last ruling of the one before
#pragma once

#include "torse/fuzz/draw/classes.hpp"

namespace torse::fuzz {

/// Two or more Bezier pieces over knots that are repeated as often as the degree. Each is planar, on one line, with
/// rulings through one point of the first ruling's line, or made by cell_row; where the first ruling is one point, all
/// rulings may have length zero.
Draft draft_joined(Choices& choices, const Scale& scale, Weights weights);

}  // namespace torse::fuzz
