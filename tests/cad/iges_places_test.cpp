// IGES surfaces that instances of subfigures and solids place: one face for each place.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cad/iges_files.hpp"
#include "support/program.hpp"
#include "torse/cli/faces.hpp"
#include "torse/cli/rails.hpp"

namespace torse::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Place = std::vector<double>;

Place doubles(const Vec<Rational, 3>& x) { return {x[0].to_double(), x[1].to_double(), x[2].to_double()}; }

const std::string square =
    "1,1,1,1,0,0,1,0,0,0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,1.,1.,0.,0.,0.,1.,0.,0.,0.,1.,0.,1.,1.,0.,0.,1.,0.,1.";

/// (x, y, z) goes to (-y, x, z).
constexpr const char* quarter_turn = "0.,-1.,0.,0.,1.,0.,0.,0.,0.,0.,1.,0.";

class IgesPlaces : public IgesFiles {
 public:
  std::string file() const { return IgesFiles::file(iges); }
  int subfigure(int entity) { return iges.add(308, "0,3Hsub,1," + text(entity), {.dependent = true}); }
  /// Where all faces have the corner (1, 0, 0) of the square.
  std::vector<Place> corners() const {
    std::vector<Place> list;
    for (const cli::Face& face : cli::read_faces(file(), "")) {
      EXPECT_TRUE(face.surface);
      if (face.surface) list.push_back(doubles(face.surface->c.points.back()));
    }
    return list;
  }
  IgesText iges;
};

/// (1, 0, 0) is scaled to (2, 0, 0), turned to (0, 2, 0) by the matrix of the last instance, and moved.
TEST_F(IgesPlaces, ASubfigureStandsAtEachOfItsInstances) {
  const std::string sub = text(subfigure(iges.add(128, square, {.label = "SQ", .dependent = true})));
  const int turn = iges.add(124, quarter_turn);
  iges.add(408, sub + ",0.,0.,5.");
  iges.add(408, sub + ",10.,20.,30.,2.");
  iges.add(408, sub + ",10.,20.,30.,2.", {.matrix = turn});
  iges.add(128, square, {.label = "OTHER"});
  EXPECT_THAT(corners(), ElementsAre(Place{1, 0, 5}, Place{12, 20, 30}, Place{10, 22, 30}, Place{1, 0, 0}));
  const std::vector<cli::Face> read = cli::read_faces(file(), "");
  for (std::size_t i = 0; i < read.size(); ++i) EXPECT_EQ(read[i].number, i + 1);
  EXPECT_EQ(read[0].name, "SQ");
  EXPECT_EQ(read[2].name, "SQ");
  EXPECT_EQ(read[3].name, "OTHER");
}

/// Curves, which OpenCASCADE places, stand where surfaces do.
TEST_F(IgesPlaces, CurvesOfASubfigureStandThereToo) {
  const int sub = subfigure(iges.add(110, "0.,0.,0.,1.,0.,0.", {.label = "c", .dependent = true}));
  iges.add(408, text(sub) + ",10.,20.,30.,2.", {.matrix = iges.add(124, quarter_turn)});
  iges.add(110, "0.,5.,0.,1.,5.,0.", {.label = "d"});
  const cli::InputRails input = cli::read_input_rails({.file = file(), .c = "c", .d = "d"});
  EXPECT_EQ(doubles(input.rails.c.net.points.front()), (Place{10, 20, 30}));
  EXPECT_EQ(doubles(input.rails.c.net.points.back()), (Place{10, 22, 30}));
}

/// First the matrix of the surface, then that of its face, then the instances from within: (1, 0, 0) goes to (2, 0, 0),
/// (0, 2, 0), (0, 3, 0), and up, or by another turn to (-3, 0, 0) and up.
TEST_F(IgesPlaces, SubfiguresWithinSubfigures) {
  const int along = iges.add(124, "1.,0.,0.,1.,0.,1.,0.,0.,0.,0.,1.,0.");
  const int turn = iges.add(124, quarter_turn);
  const int surface = iges.add(128, square, {.matrix = along, .dependent = true});
  const int face = iges.add(144, text(surface) + ",0,0,0", {.matrix = turn, .dependent = true});
  const int inner = iges.add(408, text(subfigure(face)) + ",0.,1.,0.", {.dependent = true});
  const std::string outer = text(subfigure(inner));
  iges.add(408, outer + ",0.,0.,7.");
  iges.add(408, outer + ",0.,0.,8.", {.matrix = turn});
  EXPECT_THAT(corners(), ElementsAre(Place{0, 3, 7}, Place{-3, 0, 8}));
}

/// A definition is nowhere by itself, but what nothing places stands where it is.
TEST_F(IgesPlaces, ASubfigureWithoutInstances) {
  const int both = iges.add(128, square, {.dependent = true});
  const int sub = subfigure(both);
  subfigure(both);
  EXPECT_THAT(corners(), ElementsAre(Place{1, 0, 0}));
  iges.add(408, text(sub) + ",0.,0.,5.");
  EXPECT_THAT(corners(), ElementsAre(Place{1, 0, 5}));
}

/// A line that turns about z with radius 3 from z = 0 to 4: scaled and moved it begins at x = 10 + 6, and goes from z =
/// 30 to 38.
TEST_F(IgesPlaces, WhatOpenCascadeMakesIsPlacedToo) {
  const int axis = iges.line("0.,0.,0.", "0.,0.,1.");
  const int turned =
      iges.add(120, text(axis) + "," + text(iges.line("3.,0.,0.", "3.,0.,4.")) + ",0.,1.", {.dependent = true});
  const int face = iges.add(144, text(turned) + ",0,0,0", {.dependent = true});
  iges.add(408, text(subfigure(face)) + ",10.,20.,30.,2.");
  const std::vector<cli::Face> read = cli::read_faces(file(), "");
  ASSERT_EQ(read.size(), 1U);
  ASSERT_TRUE(read[0].surface);
  Place ends{doubles(read[0].surface->c.points.front())[2], doubles(read[0].surface->d.points.front())[2]};
  std::ranges::sort(ends);
  EXPECT_EQ(ends, (Place{30, 38}));
  EXPECT_NEAR(std::max(doubles(read[0].surface->c.points.front())[0], doubles(read[0].surface->c.points.back())[0]), 16,
              1e-12);
}

/// A solid is a shell of one face here, which lies in the matrix of the solid, at two places.
TEST_F(IgesPlaces, FacesOfSolidsMoveWithThem) {
  const std::string vertices = text(iges.add(502, "4,0.,0.,0.,1.,0.,0.,1.,1.,0.,0.,1.,0.", {.form = 1}));
  std::string edges = "4";
  const std::string corner[] = {"0.,0.,0.", "1.,0.,0.", "1.,1.,0.", "0.,1.,0."};
  for (int i = 0; i < 4; ++i) {
    edges += "," + text(iges.line(corner[i], corner[(i + 1) % 4])) + "," + vertices + "," + text(i + 1) + "," +
             vertices + "," + text((i + 1) % 4 + 1);
  }
  const std::string list = text(iges.add(504, edges, {.form = 1, .dependent = true}));
  std::string loop = "4";
  for (int i = 1; i <= 4; ++i) loop += ",0," + list + "," + text(i) + ",1,0";
  const int bound = iges.add(508, loop, {.form = 1, .dependent = true});
  const int surface = iges.add(128, square, {.dependent = true});
  const int face = iges.add(510, text(surface) + ",1,1," + text(bound), {.form = 1, .dependent = true});
  const int shell = iges.add(514, "1," + text(face) + ",1", {.form = 1, .dependent = true});
  const int turn = iges.add(124, quarter_turn);
  const int up = iges.add(124, "1.,0.,0.,0.,0.,1.,0.,0.,0.,0.,1.,6.");
  const std::string solid = text(iges.add(186, text(shell) + ",1,0", {.matrix = turn}));
  EXPECT_THAT(corners(), ElementsAre(Place{0, 1, 0}));
  iges.add(430, solid, {.form = 1, .matrix = up});
  EXPECT_THAT(corners(), ElementsAre(Place{0, 1, 6}));
  iges.add(184, "2," + solid + "," + solid + ",0," + text(turn), {.form = 1, .matrix = up});
  EXPECT_THAT(corners(), ElementsAre(Place{0, 1, 6}, Place{-1, 0, 6}));
}

TEST_F(IgesPlaces, InstancesThatAreUnsound) {
  const auto error = [&] { return run_program({"check", file()}).err; };
  const int sub = subfigure(iges.add(128, square, {.dependent = true}));
  iges.add(408, text(sub) + ",0.,0.,5.,x");
  EXPECT_THAT(error(), HasSubstr("part.igs: DE : 5 type : 408: "));
  iges = IgesText();
  const int face = iges.add(128, square, {.dependent = true});
  iges.add(308, "1,3Hsub,2," + text(face) + ",5", {.dependent = true});
  iges.add(408, "3,0.,0.,1.", {.dependent = true});
  EXPECT_THAT(error(), HasSubstr("part.igs: expected instances that are no parts of themselves"));
}

/// Each subfigure holds the one before so many times, at other heights.
TEST_F(IgesPlaces, InstancesHaveALimit) {
  const auto said = [&](int levels, int times) {
    iges = IgesText();
    int below = iges.add(128, square, {.dependent = true});
    for (int level = 0; level < levels; ++level) {
      const std::string sub = text(subfigure(below));
      std::string inner = text(times);
      for (int i = 0; i < times; ++i) {
        below = iges.add(408, sub + ",0.,0.," + text(i == 0 ? 0 : 1 << level) + ".", {.dependent = true});
        inner += "," + text(below);
      }
      if (times > 1) below = iges.add(308, "0,3Hall," + inner, {.dependent = true});
    }
    if (times > 1) iges.add(408, text(below) + ",0.,0.,0.");
    const ProgramResult result = run_program({"check", file()});
    return result.out + result.err;
  };
  const std::string limit = "part.igs: expected instances at most 1000 deep, and at most 200000 steps";
  EXPECT_THAT(said(499, 1), HasSubstr("developable"));
  EXPECT_THAT(said(500, 1), HasSubstr(limit));
  EXPECT_THAT(said(7, 2), HasSubstr("128 of 128 developable"));
  EXPECT_THAT(said(24, 2), HasSubstr(limit));
}

}  // namespace
}  // namespace torse::testing
