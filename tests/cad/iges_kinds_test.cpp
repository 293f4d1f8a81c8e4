// IGES files with every kind of surface and curve: none is left out, each has its name.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "cad/iges_files.hpp"
#include "support/program.hpp"
#include "torse/cli/faces.hpp"
#include "torse/cli/rails.hpp"

namespace torse::testing {
namespace {

using Place = std::vector<double>;

class IgesKinds : public IgesFiles {};

Place doubles(const Vec<Rational, 3>& x) { return {x[0].to_double(), x[1].to_double(), x[2].to_double()}; }

const std::string square =
    "1,1,1,1,0,0,1,0,0,0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,1.,1.,0.,0.,0.,1.,0.,0.,0.,1.,0.,1.,1.,0.,0.,1.,0.,1.";

/// The parameters of entity 114 with one linear patch: (2u, 3v, 4uv) on [0, 1] x [0, 1]. A patch has the coefficients
/// of 1, u, u^2, u^3, v, uv, ... for x, y and z; those behind the last patches count for nothing.
std::string parametric_patch() {
  const std::string zeros4 = "0.,0.,0.,0.,";
  const std::string zeros8 = zeros4 + zeros4;
  const std::string x = "0.,2.,0.,0.," + zeros4 + zeros8;
  const std::string y = zeros4 + "3.,0.,0.,0.," + zeros8;
  const std::string z = zeros4 + "0.,4.,0.,0.," + zeros8;
  std::string patches = x + y + z;
  for (int behind = 0; behind < 9; ++behind) patches += zeros8 + zeros8;
  return "1,1,1,1,0.,1.,0.,1.," + patches.substr(0, patches.size() - 1);
}

TEST_F(IgesKinds, AParametricSplineSurfaceIsAFace) {
  IgesText iges;
  iges.add(128, square, {.label = "SQUARE"});
  iges.add(114, parametric_patch(), {.label = "PATCH"});
  const std::vector<cli::Face> read = faces(iges);
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].name, "SQUARE");
  EXPECT_EQ(read[1].name, "PATCH");
  ASSERT_TRUE(read[1].surface);
  EXPECT_EQ(doubles(read[1].surface->c.points.front()), (Place{0, 0, 0}));
  EXPECT_EQ(doubles(read[1].surface->c.points.back()), (Place{2, 0, 0}));
  EXPECT_EQ(doubles(read[1].surface->d.points.front()), (Place{0, 3, 0}));
  EXPECT_EQ(doubles(read[1].surface->d.points.back()), (Place{2, 3, 4}));
}

/// One of each kind that stands alone, in the order of the file.
TEST_F(IgesKinds, NoSurfaceIsLeftOut) {
  IgesText iges;
  const int c = iges.line("0.,0.,0.", "1.,0.,0.");
  const int d = iges.line("0.,1.,0.", "1.,1.,0.");
  const std::string at = text(iges.add(116, "1.,2.,3.,0", {.dependent = true}));
  const std::string axis = text(iges.add(123, "0.,0.,1.", {.dependent = true}));
  const std::string below = text(iges.add(128, square, {.dependent = true}));
  iges.add(108, "0.,0.,1.,2.,0,0.,0.,2.,1.", {.label = "S108"});
  iges.add(114, parametric_patch(), {.label = "S114"});
  iges.ruled(c, d, 0, 1, {.form = 1, .label = "S118"});
  iges.add(120, text(c) + "," + text(d) + ",0.,1.", {.label = "S120"});
  iges.add(122, text(c) + ",0.,0.,4.", {.label = "S122"});
  iges.add(128, square, {.label = "S128"});
  iges.add(140, "0.,0.,1.,0.5," + below, {.label = "S140"});
  iges.add(190, at + "," + axis, {.label = "S190"});
  iges.add(192, at + "," + axis + ",2.", {.label = "S192"});
  iges.add(194, at + "," + axis + ",2.,30.", {.label = "S194"});
  iges.add(196, at + ",2.", {.label = "S196"});
  iges.add(198, at + "," + axis + ",5.,2.", {.label = "S198"});
  std::vector<std::string> names;
  for (const cli::Face& face : faces(iges)) names.push_back(face.name);
  EXPECT_THAT(names, ::testing::ElementsAre("S108", "S114", "S118", "S120", "S122", "S128", "S140", "S190", "S192",
                                            "S194", "S196", "S198"));
}

/// The levels on which an entity stands (form 1) are a property too, and no name.
TEST_F(IgesKinds, ANameBehindAnotherPropertyIsFound) {
  IgesText iges;
  const int levels = iges.add(406, "2,3,5", {.form = 1, .dependent = true});
  const int name = iges.add(406, "1,4Hkeel", {.form = 15, .dependent = true});
  for (const auto& [first, second] : {std::pair{levels, name}, {name, levels}}) {
    iges.add(128, square + ",0,2," + text(first) + "," + text(second), {.label = "LABEL"});
  }
  const std::vector<cli::Face> read = faces(iges);
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].name, "keel");
  EXPECT_EQ(read[1].name, "keel");
}

/// A quarter of the ellipse x^2 / 16 + y^2 / 4 = 1, in a plane of constant z.
constexpr const char* quarter = "0.0625,0.,0.25,0.,0.,-1.,1.5,4.,0.,0.,2.";

TEST_F(IgesKinds, AConicArcIsARail) {
  IgesText iges;
  iges.add(110, "4.,0.,5.,0.,2.,5.", {.label = "line"});
  iges.add(104, quarter, {.form = 1, .label = "conic"});
  const cli::InputRails input = cli::read_input_rails({.file = file(iges), .c = "conic", .d = "line"});
  const CurveFile<Rational>& conic = input.rails.c;
  const Place from = doubles(conic.net.points.front());
  const Place to = doubles(conic.net.points.back());
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(from[i], (Place{4, 0, 1.5})[i], 1e-12);
    EXPECT_NEAR(to[i], (Place{0, 2, 1.5})[i], 1e-12);
  }
}

/// All that stand alone are found by their names.
TEST_F(IgesKinds, EveryCurveHasItsName) {
  IgesText iges;
  const std::vector<std::string> names{"C100", "C102", "C104", "C106", "C110", "C112", "C126"};
  const int line = iges.line("0.,0.,0.", "1.,0.,0.");
  const int next = iges.line("1.,0.,0.", "1.,2.,0.");
  iges.add(100, "0.,0.,0.,1.,0.,0.,1.", {.label = names[0]});
  iges.add(102, "2," + text(line) + "," + text(next), {.label = names[1]});
  iges.add(104, quarter, {.form = 1, .label = names[2]});
  iges.add(106, "2,3,0.,0.,0.,1.,0.,0.,1.,1.,0.", {.form = 12, .label = names[3]});
  iges.add(110, "0.,0.,0.,2.,1.,0.", {.label = names[4]});
  // (t, t^2, t^3) on [0, 1]; at its end values and derivatives, divided by factorials.
  iges.add(112, "3,1,3,1,0.,1.,0.,1.,0.,0.,0.,0.,1.,0.,0.,0.,0.,1.,1.,1.,0.,0.,1.,2.,1.,0.,1.,3.,3.,1.",
           {.label = names[5]});
  iges.add(126, "1,1,0,0,1,0,0.,0.,1.,1.,1.,1.,0.,0.,0.,2.,1.,0.,0.,1.,0.,0.,0.", {.label = names[6]});
  const std::string path = file(iges);
  for (const std::string& name : names) {
    EXPECT_NO_THROW(cli::read_input_rails({.file = path, .c = name, .d = "C110"})) << name;
  }
}

}  // namespace
}  // namespace torse::testing
