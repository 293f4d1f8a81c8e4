// IGES files in every unit, also where OpenCASCADE makes the geometry; matrices of curves that it makes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

#include "cad/iges_files.hpp"
#include "support/program.hpp"
#include "torse/cli/faces.hpp"
#include "torse/cli/rails.hpp"

namespace torse::testing {
namespace {

using Place = std::vector<double>;

class IgesUnits : public IgesFiles {};

Place doubles(const Vec<Rational, 3>& x) { return {x[0].to_double(), x[1].to_double(), x[2].to_double()}; }

void expect_near(const Vec<Rational, 3>& x, const Place& expected) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(doubles(x)[i], expected[i], 1e-12) << i;
}

/// All that the format has a number for: 1 inch, 2 mm, 4 foot, 5 mile, 6 m, 7 km, 8 mil, 9 um, 10 cm, 11 microinch.
TEST_F(IgesUnits, EachHasItsLength) {
  for (const auto& [flag, name, metres] : {std::tuple{1, "inch", 0.0254},
                                           {2, "mm", 0.001},
                                           {4, "ft", 0.3048},
                                           {5, "mile", 1609.344},
                                           {6, "m", 1.0},
                                           {7, "km", 1000.0},
                                           {8, "mil", 2.54e-5},
                                           {9, "um", 1e-6},
                                           {10, "cm", 0.01},
                                           {11, "uin", 2.54e-8}}) {
    IgesText iges(flag);
    iges.ruled(iges.line("0.,0.,0.", "0.1,0.,0."), iges.line("0.,1.,0.", "0.1,1.,0."), 0, 0, {.form = 1});
    const std::vector<cli::Face> read = cli::read_faces(file(iges), "");
    ASSERT_EQ(read.size(), 1U) << flag;
    EXPECT_EQ(read[0].cad->unit, name);
    EXPECT_EQ(read[0].cad->metres, metres);
    EXPECT_EQ(doubles(read[0].surface->c.points[1])[0], 0.1) << flag;
  }
}

/// A quarter of a circle about (0, 0, 0) in the plane x = 5, from (5, 2, 0) to (5, 0, 2): its matrix takes (x, y, z) to
/// (z + 5, x, y).
TEST_F(IgesUnits, ArcsAreInTheUnitOfTheFileAndInTheirMatrix) {
  for (const int flag : {1, 2, 6}) {
    IgesText iges(flag);
    const int turn = iges.add(124, "0.,0.,1.,5.,1.,0.,0.,0.,0.,1.,0.,0.");
    const int arc = iges.add(100, "0.,0.,0.,2.,0.,0.,2.", {.matrix = turn, .dependent = true});
    iges.ruled(arc, iges.line("7.,2.,0.", "7.,0.,2."), 0, 0, {.form = 1});
    const std::vector<cli::Face> read = cli::read_faces(file(iges), "");
    ASSERT_EQ(read.size(), 1U);
    ASSERT_TRUE(read[0].surface) << flag;
    expect_near(read[0].surface->c.points.front(), {5, 2, 0});
    expect_near(read[0].surface->c.points.back(), {5, 0, 2});
    expect_near(read[0].surface->d.points.back(), {7, 0, 2});
  }
}

/// The same arc and a chain, as rails.
TEST_F(IgesUnits, RailsThatOpenCascadeMakesAreInTheUnitOfTheFile) {
  for (const int flag : {1, 2, 6}) {
    IgesText iges(flag);
    const int turn = iges.add(124, "0.,0.,1.,5.,1.,0.,0.,0.,0.,1.,0.,0.");
    iges.add(100, "0.,0.,0.,2.,0.,0.,2.", {.label = "arc", .matrix = turn});
    const int first = iges.line("0.,0.,0.", "1.,0.,0.");
    const int second = iges.line("1.,0.,0.", "3.,4.,0.");
    iges.add(102, "2," + text(first) + "," + text(second), {.label = "chain", .matrix = turn});
    const cli::InputRails input = cli::read_input_rails({.file = file(iges), .c = "arc", .d = "chain"});
    expect_near(input.rails.c.net.points.front(), {5, 2, 0});
    expect_near(input.rails.c.net.points.back(), {5, 0, 2});
    expect_near(input.rails.d.net.points.front(), {5, 0, 0});
    expect_near(input.rails.d.net.points.back(), {5, 3, 4});
  }
}

/// An upright line at x = 4 that turns half about an axis, whose matrix takes it to x = 1; a line that its matrix moves
/// as far, from (1, 0, 0), and the vector from there to (1, 0, 4). Both surfaces have a matrix too.
TEST_F(IgesUnits, MatricesOfAxesAndDirectrices) {
  IgesText iges;
  const int right = iges.add(124, "1.,0.,0.,1.,0.,1.,0.,0.,0.,0.,1.,0.");
  const int axis = iges.add(110, "0.,0.,0.,0.,0.,1.", {.matrix = right, .dependent = true});
  const int up = iges.add(124, "1.,0.,0.,0.,0.,1.,0.,0.,0.,0.,1.,10.");
  iges.add(120, text(axis) + "," + text(iges.line("4.,0.,0.", "4.,0.,6.")) + ",0.,3.141592653589793", {.matrix = up});
  const int directrix = iges.add(110, "0.,0.,0.,0.,2.,0.", {.matrix = right, .dependent = true});
  iges.add(122, text(directrix) + ",1.,0.,4.", {.matrix = up});
  const std::vector<cli::Face> read = cli::read_faces(file(iges), "");
  ASSERT_EQ(read.size(), 2U);
  expect_near(read[0].surface->c.points.front(), {4, 0, 10});
  expect_near(read[0].surface->d.points.front(), {4, 0, 16});
  expect_near(read[0].surface->c.points.back(), {-2, 0, 10});
  expect_near(read[1].surface->c.points.back(), {1, 2, 10});
  expect_near(read[1].surface->d.points.back(), {1, 2, 14});
}

}  // namespace
}  // namespace torse::testing
