// STEP files whose parts are in different units, units of odd lengths, and what counts as equal in a file's own unit.
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "cad/step_text.hpp"
#include "support/program.hpp"
#include "torse/cli/faces.hpp"

namespace torse::testing {
namespace {

Rational q(const std::string& text) { return Rational::from_text(text); }

/// One part in millimetres, another in metres: the model is in the unit of the first.
class StepInTwoUnits : public ::testing::Test {
 public:
  std::vector<cli::Face> faces() const {
    spill(scratch / "parts.step", step.whole());
    return cli::read_faces((scratch / "parts.step").string(), "");
  }
  std::string face(const std::string& name) {
    return step.face(name, spline(name), {"0.,0.,0.", "4.,0.,0.", "4.,4.,4.", "0.,4.,0."});
  }
  std::string spline(const std::string& name) {
    return step.spline(name, 1, 1, {{"0.,0.,0.", "0.,4.,0."}, {"4.,0.,0.", "4.,4.,4."}}, "(2,2),(2,2),(0.,1.),(0.,1.)");
  }
  void add_shell(const std::string& face, const std::string& context) {
    const std::string shell = step.add("OPEN_SHELL('',(" + face + "))");
    const std::string model = step.add("SHELL_BASED_SURFACE_MODEL('',(" + shell + "))");
    step.product(step.add("MANIFOLD_SURFACE_SHAPE_REPRESENTATION('',(" + model + ")," + context + ")"));
  }
  std::string metres() {
    const std::string length = step.add("(LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT($,.METRE.))");
    const std::string angle = step.add("(NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT($,.RADIAN.))");
    const std::string solid = step.add("(NAMED_UNIT(*) SI_UNIT($,.STERADIAN.) SOLID_ANGLE_UNIT())");
    return step.add("(GEOMETRIC_REPRESENTATION_CONTEXT(3) GLOBAL_UNIT_ASSIGNED_CONTEXT((" + length + "," + angle + "," +
                    solid + ")) REPRESENTATION_CONTEXT('',''))");
  }
  StepText step;
  Scratch scratch;
};

TEST_F(StepInTwoUnits, AllPartsAreInTheFirst) {
  add_shell(face("small"), step.context());
  add_shell(face("large"), metres());
  const auto read = faces();
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].cad->unit, "mm");
  EXPECT_EQ(read[0].surface->d.points[1][2], q("4"));
  EXPECT_EQ(read[1].cad->unit, "mm");
  EXPECT_EQ(read[1].surface->d.points[1][2], q("4000"));
}

/// Surfaces that bound no face, of a set, which OpenCASCADE makes faces of, and of none, which it makes nothing of.
TEST_F(StepInTwoUnits, SurfacesWithoutAFaceToo) {
  add_shell(face("small"), step.context());
  const std::string in_metres = metres();
  const std::string tube =
      step.add("CYLINDRICAL_SURFACE(''," + step.frame("1.,2.,3.", "0.,0.,1.", "1.,0.,0.") + ",2.)");
  const auto part_of_tube = [&](const std::string& name) {
    return step.add("RECTANGULAR_TRIMMED_SURFACE('" + name + "'," + tube + ",0.,1.,0.,0.5,.T.,.T.)");
  };
  const std::string set =
      step.add("GEOMETRIC_SET('',(" + spline("spline of a set") + "," + part_of_tube("tube of a set") + "))");
  step.product(step.add("GEOMETRICALLY_BOUNDED_SURFACE_SHAPE_REPRESENTATION('',(" + set + ")," + in_metres + ")"));
  step.product(
      step.add("SHAPE_REPRESENTATION('',(" + spline("spline") + "," + part_of_tube("tube") + ")," + in_metres + ")"));
  std::map<std::string, cli::Face> read;
  for (const cli::Face& face : faces()) read.emplace(face.name, face);
  ASSERT_EQ(read.size(), 5U);
  for (const char* name : {"spline", "spline of a set"}) {
    ASSERT_TRUE(read.at(name).surface) << name;
    EXPECT_EQ(read.at(name).surface->d.points[1][2], q("4000")) << name;
  }
  for (const char* name : {"tube", "tube of a set"}) {
    ASSERT_TRUE(read.at(name).surface) << name;
    EXPECT_EQ(read.at(name).surface->c.points[0], (Vec<Rational, 3>(q("3000"), q("2000"), q("3000")))) << name;
  }
}

/// One face of the surface z = x y / 4 over [0, `length`] x [0, 4], the surface reaching to x = 4.
std::string part(StepText step, const std::string& length) {
  const std::string surface =
      step.spline("", 1, 1, {{"0.,0.,0.", "0.,4.,0."}, {"4.,0.,0.", "4.,4.,4."}}, "(2,2),(2,2),(0.,1.),(0.,1.)");
  const std::string face =
      step.face("", surface, {"0.,0.,0.", length + ",0.,0.", length + ",4.," + length, "0.,4.,0."});
  return step.file({face}, true);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  EXPECT_NE(text.find(from), std::string::npos);
  return text.replace(text.find(from), from.size(), to);
}

std::vector<cli::Face> faces_of(const std::string& text) {
  const Scratch scratch;
  spill(scratch / "part.step", text);
  return cli::read_faces((scratch / "part.step").string(), "");
}

/// The US survey foot, 1200/3937 m, is longer than the foot by 2e-6 of it.
TEST(StepUnits, TheSurveyFootIsNotTheFoot) {
  const std::string text = part(StepText("inch"), "4.");
  const std::vector<cli::Face> foot = faces_of(replaced(text, "(25.4)", "(304.8)"));
  ASSERT_EQ(foot.size(), 1U);
  EXPECT_EQ(foot[0].cad->unit, "ft");
  EXPECT_EQ(foot[0].cad->metres, 0.3048);
  const std::vector<cli::Face> survey = faces_of(replaced(text, "(25.4)", "(304.8006096)"));
  ASSERT_EQ(survey.size(), 1U);
  EXPECT_EQ(survey[0].cad->unit, "other");
  EXPECT_NEAR(survey[0].cad->metres, 0.3048006096, 1e-15);
  EXPECT_EQ(survey[0].surface->d.points[1][2], q("4"));
}

/// A face that ends 0.0002 before its surface: nearer than the uncertainty of the file, or not.
TEST(StepUnits, AFaceEndsWithItsSurfaceUpToTheUncertainty) {
  for (const char* unit : {"mm", "m"}) {
    const std::string text = part(StepText(unit), "3.9998");
    const std::vector<cli::Face> whole = faces_of(replaced(text, "(1.E-06)", "(1.E-03)"));
    ASSERT_EQ(whole.size(), 1U);
    EXPECT_EQ(whole[0].cad->tolerance, 1e-3) << unit;
    EXPECT_FALSE(whole[0].cad->trimmed) << unit;
    EXPECT_EQ(whole[0].surface->d.points[1][2], q("4")) << unit;
    const std::vector<cli::Face> cut = faces_of(replaced(text, "(1.E-06)", "(1.E-04)"));
    ASSERT_EQ(cut.size(), 1U);
    EXPECT_TRUE(cut[0].cad->trimmed) << unit;
    EXPECT_NEAR(cut[0].surface->d.points[1][2].to_double(), 3.9998, 1e-6) << unit;
  }
}

}  // namespace
}  // namespace torse::testing
