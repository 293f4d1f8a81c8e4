// STEP files through the real program: what each kind of surface becomes, number for number.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "cad/step_text.hpp"
#include "support/program.hpp"
#include "torse/cli/cad_process.hpp"
#include "torse/cli/faces.hpp"

namespace torse::testing {
namespace {

using nlohmann::json;

const std::string unit_knots = "(2,2),(2,2),(0.,1.),(0.,1.)";

class Step : public ::testing::Test {
 public:
  std::string file(const std::string& text) const {
    spill(scratch / "part.step", text);
    return (scratch / "part.step").string();
  }
  std::vector<cli::Face> faces(const std::string& text) const { return cli::read_faces(file(text), ""); }
  /// The report of check on the surfaces of a file.
  json check(const std::string& text) const {
    const ProgramResult result = run_program({"check", file(text), "--json", "-"});
    EXPECT_EQ(result.err, "");
    return json::parse(result.out)["surfaces"];
  }
  Scratch scratch;
};

Rational q(const std::string& text) { return Rational::from_text(text); }

/// One surface in a set.
std::string alone(StepText step, const std::string& surface) { return step.file({surface}, false); }

TEST_F(Step, PolesKnotsAndWeightsAreTheDoublesOfTheText) {
  StepText step;
  const std::string surface = step.rational("hull", 2, 1,
                                            {{"0.1,0.2,0.30000000000000004", "1.E-7,-2.5E+3,3."},
                                             {"1.,2.,3.", "4.,5.,6.7"},
                                             {"7.,8.,9.", "1.,0.,0.3333333333333333"}},
                                            "(3,3),(2,2),(0.1,0.7),(-1.,2.)", "((1.,0.5),(0.3,1.),(2.,0.7))");
  const std::vector<cli::Face> read = faces(alone(step, surface));
  ASSERT_EQ(read.size(), 1U);
  ASSERT_TRUE(read[0].surface);
  EXPECT_EQ(read[0].name, "hull");
  const auto d = [](double x) { return Rational::from_double(x); };
  const RuledFile<Rational>& ruled = *read[0].surface;
  EXPECT_EQ(ruled.knots.list(), (std::vector<Rational>{d(0.1), d(0.1), d(0.7), d(0.7)}));
  EXPECT_EQ(ruled.c.weights, (std::vector<Rational>{d(1), d(0.3), d(2)}));
  EXPECT_EQ(ruled.d.weights, (std::vector<Rational>{d(0.5), d(1), d(0.7)}));
  EXPECT_EQ(ruled.c.points[0][2], d(0.30000000000000004));
  EXPECT_EQ(ruled.d.points[0][0], d(1e-7));
  EXPECT_EQ(ruled.d.points[0][1], d(-2500));
  EXPECT_EQ(ruled.d.points[2][2], d(0.3333333333333333));
}

TEST_F(Step, DegreeOneInTheOtherDirectionIsTheSameSurface) {
  StepText in_v;
  const std::string first =
      in_v.spline("", 2, 1, {{"0.,0.,0.", "0.,0.,1."}, {"1.,1.,0.", "1.,1.,2."}, {"2.,0.,0.", "2.,0.,5."}},
                  "(3,3),(2,2),(0.,1.),(0.,1.)");
  StepText in_u;
  const std::string second =
      in_u.spline("", 1, 2, {{"0.,0.,0.", "1.,1.,0.", "2.,0.,0."}, {"0.,0.,1.", "1.,1.,2.", "2.,0.,5."}},
                  "(2,2),(3,3),(0.,1.),(0.,1.)");
  const auto a = faces(alone(in_v, first));
  const auto b = faces(alone(in_u, second));
  ASSERT_EQ(a.size(), 1U);
  ASSERT_EQ(b.size(), 1U);
  EXPECT_EQ(write_ruled(*a[0].surface), write_ruled(*b[0].surface));
}

TEST_F(Step, SeveralSpansAreSeveralStripsWithTheirOwnVerdicts) {
  // The first strip is in the plane z = 0, the second is a hyperbolic paraboloid, the knot 0.5 is double: no strip.
  StepText step;
  const std::string surface =
      step.spline("two", 1, 1, {{"0.,0.,0.", "0.,1.,0.", "0.,2.,0."}, {"1.,0.,0.", "1.,1.,0.", "1.,2.,1."}},
                  "(2,2),(2,1,2),(0.,1.),(0.,0.5,1.)");
  const json report = check(alone(step, surface));
  ASSERT_EQ(report.size(), 2U);
  EXPECT_EQ(report[0]["name"], "two strip 1");
  EXPECT_EQ(report[0]["class"], "plane");
  EXPECT_EQ(report[1]["name"], "two strip 2");
  EXPECT_EQ(report[1]["developable"], false);
  EXPECT_EQ(report[0]["face"], report[1]["face"]);
}

TEST_F(Step, UnclampedKnotsAreKept) {
  StepText step;
  const std::string surface =
      step.spline("", 2, 1, {{"0.,0.,0.", "0.,0.,1."}, {"1.,1.,0.", "1.,1.,1."}, {"2.,0.,0.", "2.,0.,1."}},
                  "(1,1,1,1,1,1),(2,2),(-2.,-1.,0.,1.,2.,4.),(0.,1.)");
  const auto read = faces(alone(step, surface));
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0].surface->knots.list(), (std::vector<Rational>{q("-1"), q("0"), q("1"), q("2")}));
}

TEST_F(Step, ElementarySurfacesAreExactlyWhatTheyAre) {
  // Directions of irrational length, so that every coordinate that OpenCASCADE computes is rounded.
  StepText step;
  const std::string frame = step.frame("0.1,0.2,0.3", "1.,2.,4.", "1.,0.,0.3");
  const std::string circle = step.add("CIRCLE(''," + frame + ",0.7)");
  const std::vector<std::string> items{
      step.add("RECTANGULAR_TRIMMED_SURFACE('flat'," + step.add("PLANE(''," + frame + ")") +
               ",0.1,0.7,0.,0.3,.T.,.T.)"),
      step.add("RECTANGULAR_TRIMMED_SURFACE('tube'," + step.add("CYLINDRICAL_SURFACE(''," + frame + ",0.7)") +
               ",0.,3.,0.,0.3,.T.,.T.)"),
      step.add("RECTANGULAR_TRIMMED_SURFACE('funnel'," + step.add("CONICAL_SURFACE(''," + frame + ",0.7,0.4)") +
               ",0.,6.,0.,0.3,.T.,.T.)"),
      step.add("RECTANGULAR_TRIMMED_SURFACE('wall'," +
               step.add("SURFACE_OF_LINEAR_EXTRUSION(''," + circle + "," +
                        step.add("VECTOR(''," + step.direction("0.3,0.1,0.9") + ",2.)") + ")") +
               ",0.,3.,0.,0.3,.T.,.T.)"),
      step.add("SPHERICAL_SURFACE('ball'," + frame + ",0.7)")};
  std::map<std::string, json> report;
  for (const json& surface : check(step.file(items, false))) report[surface["name"]] = surface;
  ASSERT_EQ(report.size(), 5U);
  EXPECT_EQ(report["flat"]["class"], "plane");
  EXPECT_EQ(report["flat"]["type"], "plane");
  EXPECT_EQ(report["tube"]["class"], "cylinder");
  EXPECT_EQ(report["tube"]["direction"][0], "1");
  EXPECT_EQ(report["funnel"]["class"], "cone");
  EXPECT_EQ(report["wall"]["class"], "cylinder");
  EXPECT_EQ(report["wall"]["type"], "extrusion");
  EXPECT_EQ(report["ball"]["ruled"], false);
  EXPECT_EQ(report["ball"]["type"], "sphere");
}

}  // namespace
}  // namespace torse::testing
