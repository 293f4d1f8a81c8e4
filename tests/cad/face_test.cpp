// Where a face stands, as an affine map of its numbers, and how finely its ends are told apart.
#include <gtest/gtest.h>

#include <cmath>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
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

/// A rectangle of 1000 by 1 over the unit square: a step of the tolerance is shorter in u.
TEST(Box, HasAResolutionForEachParameter) {
  TColgp_Array2OfPnt poles(1, 2, 1, 2);
  for (int i = 1; i <= 2; ++i) {
    for (int j = 1; j <= 2; ++j) poles.SetValue(i, j, gp_Pnt(1000 * (i - 1), j - 1, 0));
  }
  const BRepBuilderAPI_MakeFace face(new Geom_BezierSurface(poles), 1e-7);
  const std::optional<Box> box = box_of(face.Face(), 1e-3);
  ASSERT_TRUE(box);
  EXPECT_NEAR(box->u_resolution / box->v_resolution, 1e-3, 1e-9);
  EXPECT_LE(box->v_resolution, 1e-3);
  EXPECT_GT(box->v_resolution, 1e-4);
}

}  // namespace
}  // namespace torse::cad
