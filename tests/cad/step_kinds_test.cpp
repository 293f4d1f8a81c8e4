// STEP surfaces with weights whose kind implies their knots.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cad/step_text.hpp"
#include "support/program.hpp"
#include "torse/cli/faces.hpp"

namespace torse::testing {
namespace {

class StepKinds : public ::testing::Test {
 public:
  std::vector<cli::Face> faces(const std::string& text) const {
    spill(scratch / "part.step", text);
    return cli::read_faces((scratch / "part.step").string(), "");
  }
  Scratch scratch;
};

/// Faces of the same kinds with weights, in the order of their names, as complex entities are. The spline without
/// repeated knots begins and ends between its points.
TEST_F(StepKinds, WeightsOfSurfacesWhoseKindImpliesTheirKnots) {
  const std::vector<std::string> ends{"0.,0.,0.", "2.,0.,0.", "2.,0.,1.", "0.,0.,1."};
  const std::vector<std::string> between{"0.75,0.,0.", "1.625,0.,0.", "1.6,0.,1.", "0.66666666666666663,0.,1."};
  for (const std::string kind : {"BEZIER_SURFACE", "QUASI_UNIFORM_SURFACE", "UNIFORM_SURFACE"}) {
    StepText step;
    std::vector<std::vector<std::string>> rows;
    for (const char* x : {"0.", "1.", "2."}) rows.push_back({x + std::string(",0.,0."), x + std::string(",0.,1.")});
    std::vector<std::string> parts{"BOUNDED_SURFACE()",
                                   "B_SPLINE_SURFACE(2,1," + step.net(rows) + ",.UNSPECIFIED.,.F.,.F.,.F.)",
                                   "GEOMETRIC_REPRESENTATION_ITEM()",
                                   kind + "()",
                                   "RATIONAL_B_SPLINE_SURFACE(((1.,2.),(3.,4.),(5.,6.)))",
                                   "REPRESENTATION_ITEM('')",
                                   "SURFACE()"};
    std::sort(parts.begin(), parts.end());
    std::string entity;
    for (const std::string& part : parts) entity += (entity.empty() ? "(" : " ") + part;
    const std::string face = step.face("", step.add(entity + ")"), kind == "UNIFORM_SURFACE" ? between : ends);
    const auto read = faces(step.file({face}, true));
    ASSERT_EQ(read.size(), 1U) << kind;
    ASSERT_TRUE(read[0].surface) << kind;
    EXPECT_EQ(read[0].surface->c.weights, (std::vector<Rational>{Rational(1), Rational(3), Rational(5)})) << kind;
    EXPECT_EQ(read[0].surface->d.weights, (std::vector<Rational>{Rational(2), Rational(4), Rational(6)})) << kind;
  }
}

/// Of 4 points with weights and degree 2: between the ends, which are clamped, is one knot.
TEST_F(StepKinds, QuasiUniformKnotsBetweenTheEnds) {
  StepText step;
  std::vector<std::vector<std::string>> rows;
  for (const char* x : {"0.", "1.", "2.", "4."}) rows.push_back({x + std::string(",0.,0."), x + std::string(",0.,1.")});
  const std::string entity =
      step.add("(BOUNDED_SURFACE() B_SPLINE_SURFACE(2,1," + step.net(rows) +
               ",.UNSPECIFIED.,.F.,.F.,.F.) GEOMETRIC_REPRESENTATION_ITEM() "
               "QUASI_UNIFORM_SURFACE() RATIONAL_B_SPLINE_SURFACE(((1.,2.),(3.,4.),(5.,6.),(1.,1.)))"
               " REPRESENTATION_ITEM('') SURFACE())");
  const std::vector<std::string> ends{"0.,0.,0.", "4.,0.,0.", "4.,0.,1.", "0.,0.,1."};
  const auto read = faces(step.file({step.face("", entity, ends)}, true));
  ASSERT_EQ(read.size(), 1U);
  ASSERT_TRUE(read[0].surface);
  const std::vector<Rational>& knots = read[0].surface->knots.list();
  ASSERT_EQ(knots.size(), 5U);
  EXPECT_EQ(knots[0], knots[1]);
  EXPECT_EQ(knots[2] - knots[1], knots[3] - knots[2]);
  EXPECT_EQ(knots[3], knots[4]);
  EXPECT_EQ(read[0].surface->c.points[1][0], Rational(1));
}

}  // namespace
}  // namespace torse::testing
