// STEP files through the real program: what each kind of surface becomes, number for number.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cad/step_text.hpp"
#include "support/program.hpp"
#include "torse/cli/cad_process.hpp"
#include "torse/cli/faces.hpp"

namespace torse::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

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
  // The first strip is in the plane z = 0, the second is a hyperbolic paraboloid.
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

TEST_F(Step, NoStripLiesBetweenEqualKnots) {
  // Where the knot 0.5 is double, the surface jumps from the row y = 1 to the row y = 5.
  StepText step;
  const std::string surface = step.spline(
      "", 1, 1, {{"0.,0.,0.", "0.,1.,0.", "0.,5.,0.", "0.,6.,0."}, {"1.,0.,0.", "1.,1.,0.", "1.,5.,0.", "1.,6.,0."}},
      "(2,2),(2,2,2),(0.,1.),(0.,0.5,1.)");
  const auto read = faces(alone(step, surface));
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].surface->c.points[0][1], q("0"));
  EXPECT_EQ(read[0].surface->d.points[0][1], q("1"));
  EXPECT_EQ(read[1].surface->c.points[0][1], q("5"));
  EXPECT_EQ(read[1].surface->d.points[0][1], q("6"));
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

TEST_F(Step, KnotsThatTheKindImplies) {
  const auto knots = [&](const std::string& kind) {
    StepText step;
    std::vector<std::vector<std::string>> rows;
    for (const char* x : {"0.", "1.", "2.", "3.", "4."})
      rows.push_back({x + std::string(",0.,0."), x + std::string(",0.,1.")});
    const std::string surface = step.add(kind + "('',2,1," + step.net(rows) + ",.UNSPECIFIED.,.F.,.F.,.F.)");
    const auto read = faces(alone(step, surface));
    std::string text;
    for (const Rational& t : read.at(0).surface->knots.list()) text += t.text() + " ";
    return text;
  };
  EXPECT_EQ(knots("BEZIER_SURFACE"), "0 0 1 1 2 2 ");
  EXPECT_EQ(knots("QUASI_UNIFORM_SURFACE"), "0 0 1 2 3 3 ");
  EXPECT_EQ(knots("UNIFORM_SURFACE"), "1 2 3 4 5 6 ");
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

TEST_F(Step, AFaceThatCoversAPartOfItsSurfaceIsThatPart) {
  // z = x y / 4 on [0, 4] x [0, 4], whose lines x = 1, x = 3.5, y = 0.5, y = 3 bound the face.
  StepText step;
  const std::string surface = step.spline("", 1, 1, {{"0.,0.,0.", "0.,4.,0."}, {"4.,0.,0.", "4.,4.,4."}}, unit_knots);
  const auto part = faces(
      step.file({step.face("part", surface, {"1.,0.5,0.125", "3.5,0.5,0.4375", "3.5,3.,2.625", "1.,3.,0.75"})}, true));
  ASSERT_EQ(part.size(), 1U);
  EXPECT_EQ(part[0].name, "part");
  EXPECT_TRUE(part[0].cad->trimmed);
  ASSERT_TRUE(part[0].surface);
  const RuledFile<Rational>& ruled = *part[0].surface;
  EXPECT_NEAR(ruled.c.points[0][0].to_double(), 1, 1e-6);
  EXPECT_NEAR(ruled.c.points[1][0].to_double(), 3.5, 1e-6);
  EXPECT_NEAR(ruled.c.points[0][1].to_double(), 0.5, 1e-6);
  EXPECT_NEAR(ruled.d.points[0][1].to_double(), 3, 1e-6);
  EXPECT_NEAR(ruled.d.points[1][2].to_double(), 2.625, 1e-6);
  // On the surface exactly, whatever the parameters are.
  for (const Vec<Rational, 3>& x : ruled.d.points) EXPECT_EQ(x[2], x[0] * x[1] / Rational(4));
}

/// A circle moved along its axis, of which a face takes the angles from 3 to 7: they pass the circle's first point.
TEST_F(Step, AFaceOverTheSeamOfAnExtrusion) {
  StepText step;
  const auto circle = [&](const std::string& z) {
    return step.add("CIRCLE(''," + step.frame("0.,0.," + z, "0.,0.,1.", "1.,0.,0.") + ",2.)");
  };
  const auto at = [](double angle, double z) {
    return std::to_string(2 * std::cos(angle)) + "," + std::to_string(2 * std::sin(angle)) + "," + std::to_string(z);
  };
  const auto vertex = [&](double angle, double z) {
    return step.add("VERTEX_POINT(''," + step.point(at(angle, z)) + ")");
  };
  const std::string low = vertex(3, 0), high = vertex(3, 1), end = vertex(7, 0), top = vertex(7, 1);
  const auto edge = [&](const std::string& from, const std::string& to, const std::string& curve, const char* sense) {
    const std::string whole = step.add("EDGE_CURVE(''," + from + "," + to + "," + curve + ",.T.)");
    return step.add("ORIENTED_EDGE('',*,*," + whole + "," + sense + ")");
  };
  const auto upright = [&](double angle) {
    const std::string vector = step.add("VECTOR(''," + step.direction("0.,0.,1.") + ",1.)");
    return step.add("LINE(''," + step.point(at(angle, 0)) + "," + vector + ")");
  };
  const std::string loop = edge(low, end, circle("0."), ".T.") + "," + edge(end, top, upright(7), ".T.") + "," +
                           edge(high, top, circle("1."), ".F.") + "," + edge(low, high, upright(3), ".F.");
  const std::string bound = step.add("FACE_OUTER_BOUND(''," + step.add("EDGE_LOOP('',(" + loop + "))") + ",.T.)");
  const std::string wall = step.add("SURFACE_OF_LINEAR_EXTRUSION(''," + circle("0.") + "," +
                                    step.add("VECTOR(''," + step.direction("0.,0.,1.") + ",1.)") + ")");
  const auto read = faces(step.file({step.add("ADVANCED_FACE('wall',(" + bound + ")," + wall + ",.T.)")}, true));
  ASSERT_EQ(read.size(), 1U);
  ASSERT_TRUE(read[0].surface);
  const auto& rail = read[0].surface->c.points;
  EXPECT_NEAR(rail.front()[0].to_double(), 2 * std::cos(3), 1e-5);
  EXPECT_NEAR(rail.front()[1].to_double(), 2 * std::sin(3), 1e-5);
  EXPECT_NEAR(rail.back()[0].to_double(), 2 * std::cos(7), 1e-5);
  EXPECT_NEAR(rail.back()[1].to_double(), 2 * std::sin(7), 1e-5);
}

/// A shape that no product claims is no root of the file, and its face is cut all the same.
TEST_F(Step, AFaceWithoutAProductIsCutToo) {
  StepText step;
  const std::string surface = step.spline("", 1, 1, {{"0.,0.,0.", "0.,4.,0."}, {"4.,0.,0.", "4.,4.,4."}}, unit_knots);
  std::string text =
      step.file({step.face("part", surface, {"1.,0.5,0.125", "3.5,0.5,0.4375", "3.5,3.,2.625", "1.,3.,0.75"})}, true);
  const std::size_t at = text.rfind('#', text.find("=SHAPE_DEFINITION_REPRESENTATION"));
  text.erase(at, text.find('\n', at) + 1 - at);
  ASSERT_EQ(text.find("SHAPE_DEFINITION"), std::string::npos);
  const auto part = faces(text);
  ASSERT_EQ(part.size(), 1U);
  EXPECT_TRUE(part[0].cad->trimmed);
  ASSERT_TRUE(part[0].surface);
  EXPECT_NEAR(part[0].surface->c.points[0][0].to_double(), 1, 1e-6);
  EXPECT_NEAR(part[0].surface->d.points[1][2].to_double(), 2.625, 1e-6);
}

TEST_F(Step, AFaceThatCoversItsSurfaceIsTheWholeOfIt) {
  StepText step;
  const std::string surface = step.spline("", 1, 1, {{"0.,0.,0.", "0.,4.,0."}, {"4.,0.,0.", "4.,4.,4."}}, unit_knots);
  const auto whole = faces(step.file({step.face("", surface, {"0.,0.,0.", "4.,0.,0.", "4.,4.,4.", "0.,4.,0."})}, true));
  ASSERT_EQ(whole.size(), 1U);
  EXPECT_EQ(whole[0].name, "face 1");
  EXPECT_FALSE(whole[0].cad->trimmed);
  EXPECT_EQ(whole[0].surface->d.points[1][2], q("4"));
  EXPECT_EQ(whole[0].surface->c.points[0][0], q("0"));
}

TEST_F(Step, AFaceOfAnAssemblyCountsAtEachPlace) {
  StepText step;
  const std::string surface = step.spline("", 1, 1, {{"0.,0.,0.", "0.,4.,0."}, {"4.,0.,0.", "4.,4.,4."}}, unit_knots);
  const std::string face = step.face("hyp", surface, {"0.,0.,0.", "4.,0.,0.", "4.,4.,4.", "0.,4.,0."});
  const std::string here = step.frame("10.,0.,0.", "0.,0.,1.", "1.,0.,0.");
  const std::string there = step.frame("0.,20.,0.", "1.,0.,0.", "0.,1.,0.");
  const auto read = faces(step.assembly({face}, {here, there}));
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].number, 1U);
  EXPECT_EQ(read[1].number, 2U);
  const auto corner = [&](std::size_t i) {  // of the surface point (4, 4, 4)
    const Vec<Rational, 3>& x = read[i].surface->d.points[1];
    return std::vector<double>{x[0].to_double(), x[1].to_double(), x[2].to_double()};
  };
  EXPECT_EQ(corner(0), (std::vector<double>{14, 4, 4}));
  EXPECT_EQ(corner(1), (std::vector<double>{4, 24, 4}));  // x goes to y, y to z, z to x
}

TEST_F(Step, UnitsAreTheFilesOwn) {
  for (const auto& [unit, metres] : {std::make_pair("mm", 0.001), {"m", 1.0}, {"inch", 0.0254}}) {
    StepText step(unit);
    const std::string surface =
        step.spline("", 1, 1, {{"0.1,0.,0.", "0.,1.,0."}, {"1.,0.,0.", "1.,1.,0."}}, unit_knots);
    const auto read = faces(step.file({surface}, false));
    ASSERT_EQ(read.size(), 1U);
    EXPECT_EQ(read[0].cad->unit, unit);
    EXPECT_EQ(read[0].cad->metres, metres);
    EXPECT_EQ(read[0].cad->tolerance, 1e-6);
    EXPECT_EQ(read[0].surface->c.points[0][0], Rational::from_double(0.1));
  }
}

TEST_F(Step, WithoutUnitsLengthsAreMillimetres) {
  StepText step("");
  const std::string surface = step.spline("", 1, 1, {{"0.1,0.,0.", "0.,1.,0."}, {"1.,0.,0.", "1.,1.,0."}}, unit_knots);
  const auto read = faces(step.file({surface}, false));
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0].cad->unit, "mm");
  EXPECT_EQ(read[0].cad->tolerance, 0);
  EXPECT_EQ(read[0].surface->c.points[0][0], Rational::from_double(0.1));
}

TEST_F(Step, ElementaryFacesAreInTheFilesUnitToo) {
  for (const char* unit : {"mm", "m", "inch"}) {
    StepText step(unit);
    const std::string plane = step.add("PLANE(''," + step.frame("1.,2.,3.", "0.,0.,1.", "1.,0.,0.") + ")");
    const auto read =
        faces(step.file({step.face("", plane, {"1.,2.,3.", "1.5,2.,3.", "1.5,4.,3.", "1.,4.,3."})}, true));
    ASSERT_EQ(read.size(), 1U);
    const RuledFile<Rational>& ruled = *read[0].surface;
    EXPECT_EQ(ruled.c.points[0][2], q("3"));
    EXPECT_NEAR(ruled.c.points[1][0].to_double(), 1.5, 1e-9);
    EXPECT_NEAR(ruled.d.points[1][1].to_double(), 4, 1e-9);
  }
}

/// A cone of half a right angle and radius 1 at z = 0, its angle in degrees.
TEST_F(Step, AnglesAreInTheFilesUnit) {
  StepText step;
  const std::string cone =
      step.add("CONICAL_SURFACE('funnel'," + step.frame("0.,0.,0.", "0.,0.,1.", "1.,0.,0.") + ",1.,45.)");
  std::string text = step.file({cone}, false);
  const std::string radian = "=(NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT($,.RADIAN.));";
  ASSERT_NE(text.find(radian), std::string::npos);
  text.replace(text.find(radian), radian.size(),
               "=(CONVERSION_BASED_UNIT('DEGREE',#9001) NAMED_UNIT(#9003) PLANE_ANGLE_UNIT());\n"
               "#9001=PLANE_ANGLE_MEASURE_WITH_UNIT(PLANE_ANGLE_MEASURE(0.017453292519943295),#9002);\n"
               "#9002" +
                   radian + "\n#9003=DIMENSIONAL_EXPONENTS(0.,0.,0.,0.,0.,0.,0.);");
  const json report = check(text);
  ASSERT_EQ(report.size(), 1U);
  ASSERT_EQ(report[0]["class"], "cone");
  EXPECT_NEAR(q(report[0]["vertex"][2].get<std::string>().c_str()).to_double(), -1, 1e-12);
}

/// The commands that a report tells to show its faces again.
std::vector<std::string> replays(const std::string& out) {
  std::vector<std::string> list;
  std::istringstream lines(out);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find("replay: ");
    if (at != std::string::npos) list.push_back(line.substr(at + 8));
  }
  return list;
}

TEST_F(Step, AStripHasItsTitleAndItsCommand) {
  StepText step;
  const std::string surface =
      step.spline("two", 1, 1, {{"0.,0.,0.", "0.,1.,0.", "0.,2.,0."}, {"1.,0.,0.", "1.,1.,0.", "1.,2.,1."}},
                  "(2,2),(2,1,2),(0.,1.),(0.,0.5,1.)");
  const std::string path = file(alone(step, surface));
  const ProgramResult both = run_program({"check", path});
  EXPECT_THAT(both.out, HasSubstr(path + ": two strip 1  developable"));
  EXPECT_THAT(both.out, HasSubstr(path + ": two strip 2  not developable"));
  EXPECT_EQ(replays(both.out), (std::vector<std::string>{"torse check --face 'two strip 2' " + path}));
  EXPECT_EQ(run_program({"check", "--face", "two strip 1", path}).exit, 0);
  EXPECT_EQ(run_program({"check", "--face", "two strip 2", path}).exit, 1);
}

/// The name of the first face is the number of the second.
TEST_F(Step, ACommandShowsTheFaceItIsAbout) {
  StepText step;
  const std::string flat = step.spline("2", 1, 1, {{"0.,0.,0.", "0.,1.,0."}, {"1.,0.,0.", "1.,1.,0."}}, unit_knots);
  const std::string twisted = step.spline("x", 1, 1, {{"0.,0.,0.", "0.,1.,0."}, {"1.,0.,0.", "1.,1.,1."}}, unit_knots);
  const std::string path = file(step.file({flat, twisted}, false));
  EXPECT_EQ(replays(run_program({"check", path}).out), (std::vector<std::string>{"torse check --face x " + path}));
  EXPECT_EQ(run_program({"check", "--face", "x", path}).exit, 1);
  EXPECT_EQ(run_program({"check", "--face", "2", path}).exit, 0) << "a name comes first";
}

TEST_F(Step, FacesAreChosenByNameAndNumber) {
  StepText step;
  const std::string flat = step.spline("flat", 1, 1, {{"0.,0.,0.", "0.,1.,0."}, {"1.,0.,0.", "1.,1.,0."}}, unit_knots);
  const std::string twisted =
      step.spline("twisted", 1, 1, {{"0.,0.,0.", "0.,1.,0."}, {"1.,0.,0.", "1.,1.,1."}}, unit_knots);
  const std::string path = file(step.file({flat, twisted}, false));
  EXPECT_EQ(run_program({"check", path}).exit, 1);
  EXPECT_EQ(run_program({"check", "--face", "flat", path}).exit, 0);
  EXPECT_EQ(run_program({"check", "--face", "2", path}).exit, 1);
  EXPECT_EQ(run_program({"check", "--face", "twisted", "--max-warp", "46deg", path}).exit, 0);  // atan(1) at a corner
  EXPECT_EQ(run_program({"recover", "--face", "1", path}).exit, 0);
  const ProgramResult none = run_program({"check", "--face", "third", path});
  EXPECT_EQ(none.exit, 2);
  EXPECT_THAT(none.err, HasSubstr("twisted"));
}

}  // namespace
}  // namespace torse::testing
