// What torse says of IGES entities that lack something, are none of the kind they should be, or cannot be used.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "cad/iges_text.hpp"
#include "support/program.hpp"

namespace torse::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// A square, as the parameters of entity 128.
const std::string square =
    "1,1,1,1,0,0,1,0,0,0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,1.,1.,0.,0.,0.,1.,0.,0.,0.,1.,0.,1.,1.,0.,0.,1.,0.,1.";

int point(IgesText& iges) { return iges.add(116, "1.,2.,3.,0", {.dependent = true}); }
int floor_line(IgesText& iges) { return iges.line("0.,0.,0.", "1.,0.,0."); }
int damaged_line(IgesText& iges) { return iges.add(110, "0.,x,0.,1.,0.", {.dependent = true}); }

struct Case {
  std::string what;
  std::function<void(IgesText&)> entities;
  std::string says;
};

ProgramResult run(const std::string& word, const std::string& text) {
  const Scratch scratch;
  const std::string file = (scratch / "part.igs").string();
  spill(file, text);
  return word == "fit" ? run_program({"fit", file, "--coefficients", "5", "-o", (scratch / "out.json").string()})
                       : run_program({word, file});
}

std::string text_of(const Case& one) {
  IgesText iges;
  one.entities(iges);
  return iges.file();
}

/// The file as a whole is refused.
void expect_refused(const std::string& word, const std::vector<Case>& cases) {
  for (const Case& one : cases) {
    SCOPED_TRACE(one.what);
    const ProgramResult result = run(word, text_of(one));
    EXPECT_EQ(result.exit, 2);
    EXPECT_THAT(result.err, HasSubstr("part.igs: " + one.says));
  }
}

TEST(IgesErrors, AFaceWithoutASurface) {
  expect_refused("check", {{"trimmed", [](IgesText& iges) { iges.add(144, "0,0,0,0"); },
                            "expected the surface of face 1: DE : 1 type : 144: "},
                           {"bounded", [](IgesText& iges) { iges.add(143, "0,0,0"); },
                            "expected the surface of face 1: DE : 1 type : 143: "},
                           {"of a solid", [](IgesText& iges) { iges.add(510, "0,1,1,0", {.form = 1}); },
                            "expected the surface of face 1: DE : 1 type : 510: "},
                           {"after a sound one",
                            [](IgesText& iges) {
                              iges.add(128, square);
                              iges.add(144, "0,0,0,0");
                            },
                            "expected the surface of face 2: DE : 3 type : 144: "}});
}

TEST(IgesErrors, ASurfaceThatLacksSomething) {
  expect_refused("check",
                 {{"ruled", [](IgesText& iges) { iges.add(118, "0,0,0,1", {.form = 1}); }, "DE : 1 type : 118: "},
                  {"tabulated", [](IgesText& iges) { iges.add(122, "0,0.3,0.1,4."); }, "DE : 1 type : 122: "},
                  {"turned, no generatrix", [](IgesText& iges) { iges.add(120, text(floor_line(iges)) + ",0,0.,1."); },
                   "DE : 3 type : 120: "},
                  {"turned, no axis", [](IgesText& iges) { iges.add(120, "0," + text(floor_line(iges)) + ",0.,1."); },
                   "DE : 3 type : 120: "},
                  {"offset", [](IgesText& iges) { iges.add(140, "0.,0.,1.,0.1,0"); }, "DE : 1 type : 140: "},
                  {"matrix",
                   [](IgesText& iges) {
                     const int c = floor_line(iges);
                     const int d = iges.line("0.,1.,0.", "1.,1.,0.");
                     iges.ruled(c, d, 0, 1, {.form = 1, .matrix = iges.add(124, "1.,0.,0.,x")});
                   },
                   "DE : 5 type : 124: "}});
}

/// A face that cannot be used is named with the reason; the others are not affected.
TEST(IgesErrors, CurvesThatAreNoRails) {
  const std::vector<Case> cases{
      {"ruled from a point",
       [](IgesText& iges) {
         const int c = point(iges);
         iges.ruled(c, floor_line(iges), 0, 1, {.form = 1});
       },
       "ruled surface: its curve is an IGES entity 116"},
      {"ruled from a chain",
       [](IgesText& iges) {
         const int line = floor_line(iges);
         const int chain = iges.add(102, "2," + text(line) + "," + text(line), {.dependent = true});
         iges.ruled(chain, line, 0, 1, {.form = 1});
       },
       "ruled surface: its curve is an IGES entity 102"},
      {"ruled to a damaged line",
       [](IgesText& iges) {
         const int c = floor_line(iges);
         iges.ruled(c, damaged_line(iges), 0, 1, {.form = 1});
       },
       "ruled surface: DE : 3 type : 110: "},
      {"tabulated along a point", [](IgesText& iges) { iges.add(122, text(point(iges)) + ",0.3,0.1,4."); },
       "extrusion: its curve is an IGES entity 116"},
      {"tabulated along a damaged line",
       [](IgesText& iges) { iges.add(122, text(damaged_line(iges)) + ",0.3,0.1,4."); },
       "extrusion: DE : 1 type : 110: "},
      {"turned about a line, a curve",
       [](IgesText& iges) {
         const int axis = iges.line("0.,0.,0.", "0.,0.,1.");
         iges.add(120, text(axis) + "," + text(iges.bezier(2, "1.,1.,1.", "1.,0.,0.,2.,0.,1.,1.,0.,2.")) + ",0.,1.");
       },
       "revolution: its meridian is curved"},
      {"a sphere", [](IgesText& iges) { iges.add(196, text(point(iges)) + ",2.,0,0"); },
       "entity 196: OpenCASCADE makes no single face of it"}};
  for (const Case& one : cases) {
    SCOPED_TRACE(one.what);
    IgesText iges;
    one.entities(iges);
    iges.add(128, square);
    const ProgramResult result = run("check", iges.file());
    EXPECT_THAT(result.out, HasSubstr(one.says));
    EXPECT_THAT(result.out, HasSubstr("plane"));  // the square
    EXPECT_EQ(result.err, "");
  }
}

/// A quarter of the unit circle, which OpenCASCADE makes a curve of, and a line below from under the one end of the arc
/// to under the other: all vertices are on either.
TEST(IgesErrors, OtherCurvesComeThroughOpenCascade) {
  IgesText iges;
  const int arc = iges.add(100, "0.,0.,0.,1.,0.,0.,1.", {.dependent = true});
  iges.ruled(arc, iges.line("1.,0.,-2.", "0.,1.,-2."), 0, 0, {.form = 1});
  const Scratch scratch;
  spill(scratch / "part.igs", iges.file());
  const ProgramResult result =
      run_program({"convert", (scratch / "part.igs").string(), "-o", (scratch / "part.obj").string()});
  ASSERT_EQ(result.exit, 0) << result.err;
  std::istringstream lines(slurp(scratch / "part.obj"));
  int on_arc = 0, on_line = 0;
  for (std::string line; std::getline(lines, line);) {
    double x = 0, y = 0, z = 0;
    if (std::sscanf(line.c_str(), "v %lf %lf %lf", &x, &y, &z) != 3 || (z != 0 && z != -2)) continue;
    EXPECT_TRUE(-1e-15 <= x && -1e-15 <= y) << line;
    EXPECT_NEAR(z == 0 ? x * x + y * y : x + y, 1, 1e-12) << line;
    ++(z == 0 ? on_arc : on_line);
  }
  EXPECT_GT(on_arc, 2);
  EXPECT_EQ(on_arc, on_line);
}

TEST(IgesErrors, BoundariesThatAreNotUsed) {
  const auto said = [](const std::function<void(IgesText&)>& entities) {
    return run("check", text_of({"", entities, ""})).out;
  };
  const auto ruled = [](IgesText& iges) {
    const int c = floor_line(iges);
    const int d = iges.line("0.,1.,0.", "1.,1.,0.");
    return iges.ruled(c, d, 0, 1, {.form = 1, .dependent = true});
  };
  const std::string not_used = "its boundary is not used: the whole ruled surface";
  EXPECT_THAT(said([&](IgesText& iges) {
                const int surface = ruled(iges);
                const int contour =
                    iges.add(142, "1," + text(surface) + ",0," + text(floor_line(iges)) + ",2", {.dependent = true});
                iges.add(144, text(surface) + ",1,0," + text(contour));
              }),
              HasSubstr(not_used));
  EXPECT_THAT(said([&](IgesText& iges) { iges.add(144, text(ruled(iges)) + ",0,0,0"); }), Not(HasSubstr(not_used)));
  // A hole in all of the surface.
  EXPECT_THAT(said([&](IgesText& iges) {
                const int surface = ruled(iges);
                const int hole =
                    iges.add(142, "1," + text(surface) + ",0," + text(floor_line(iges)) + ",2", {.dependent = true});
                iges.add(144, text(surface) + ",0,1,0," + text(hole));
              }),
              HasSubstr(not_used));
  // A trimmed surface whose contour is the surface: OpenCASCADE makes no face of it.
  EXPECT_THAT(said([](IgesText& iges) {
                const int surface = iges.add(128, square, {.dependent = true});
                iges.add(144, text(surface) + ",1,0," + text(surface));
              }),
              HasSubstr("its boundary cannot be used: the whole surface"));
}

TEST(IgesErrors, CurvesOfAFile) {
  const std::string d = "0.,2.,1.,2.,3.,1.";
  expect_refused("fit", {{"a damaged line",
                          [&](IgesText& iges) {
                            iges.add(110, "0.,y,1.,2.,3.", {.label = "c"});
                            iges.add(110, d, {.label = "d"});
                          },
                          "DE : 1 type : 110: "},
                         {"a chain of nothing",
                          [&](IgesText& iges) {
                            iges.add(102, "0", {.label = "c"});
                            iges.add(110, d, {.label = "d"});
                          },
                          "DE : 1 type : 102: "},
                         {"a chain with a gap",
                          [&](IgesText& iges) {
                            const int first = floor_line(iges);
                            const int second = iges.line("5.,0.,0.", "6.,0.,0.");
                            iges.add(102, "2," + text(first) + "," + text(second), {.label = "c"});
                            iges.add(110, d, {.label = "d"});
                          },
                          "expected two curves that bound no face, found one curve: 1 \"d\""}});
}

/// The first line alone is a file of the kind, and no more.
TEST(IgesErrors, AFileThatEndsAfterItsFirstLine) {
  for (const char* command : {"check", "fit"}) {
    const ProgramResult result = run(command, IgesText().file().substr(0, 81));
    EXPECT_EQ(result.exit, 2);
    EXPECT_THAT(result.err, HasSubstr("part.igs: expected an entity, found none\n"));
  }
}

}  // namespace
}  // namespace torse::testing
