// Where a face stands, as an affine map of its numbers.
#include <gtest/gtest.h>

#include <cmath>

#include <gp_Ax1.hxx>
#include <gp_Trsf.hxx>
#include <gp_Vec.hxx>

#include "torse/cad/face.hpp"

namespace torse::cad {
namespace {

/// A face in inches in a file in millimetres: its numbers are scaled, the place where it stands is in the file's unit.
TEST(Placement, ScalesTheFaceAndNotItsPlace) {
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(), std::acos(0.0));
  gp_Trsf move;
  move.SetTranslation(gp_Vec(1, 2, 3));
  const CadPlacement placement = placement_of(move * turn, 25.4);
  const CadPlacement expected{{{0, -25.4, 0, 1}, {25.4, 0, 0, 2}, {0, 0, 25.4, 3}}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) EXPECT_NEAR(placement[i][j], expected[i][j], 1e-14) << i << j;
  }
}

}  // namespace
}  // namespace torse::cad
