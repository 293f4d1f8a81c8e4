// IGES files through the real program: splines number for number, ruled surfaces and their developable flag.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <tuple>

#include "cad/iges_files.hpp"
#include "support/program.hpp"
#include "torse/cli/faces.hpp"

namespace torse::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

class Iges : public IgesFiles {
 public:
  json check(const IgesText& iges) const {
    const ProgramResult result = run_program({"check", file(iges), "--json", "-"});
    EXPECT_EQ(result.err, "");
    return json::parse(result.out)["surfaces"];
  }
};

Rational d(double x) { return Rational::from_double(x); }

/// As doubles again, which a failure can show.
std::vector<double> doubles(const std::vector<Rational>& list) {
  std::vector<double> result;
  for (const Rational& x : list) result.push_back(x.to_double());
  return result;
}
std::vector<double> doubles(const Vec<Rational, 3>& x) {
  return {x[0].to_double(), x[1].to_double(), x[2].to_double()};
}

TEST_F(Iges, PolesKnotsAndWeightsAreTheDoublesOfTheText) {
  IgesText iges;
  iges.add(128,
           "2,1,2,1,0,0,0,0,0, 0.1,0.1,0.1,0.7,0.7,0.7, -1.,-1.,2.,2., 1.,0.3,2., 0.5,1.,0.7,"
           "0.1,0.2,0.30000000000000004, 1.,2.,3., 7.,8.,9., 1.D-7,-2500.,3., 4.,5.,6.7, 1.,0.,0.3333333333333333,"
           "0.1,0.7,-1.,2.",
           {.label = "HULL"});
  const std::vector<cli::Face> read = faces(iges);
  ASSERT_EQ(read.size(), 1U);
  ASSERT_TRUE(read[0].surface);
  EXPECT_EQ(read[0].name, "HULL");
  const RuledFile<Rational>& ruled = *read[0].surface;
  EXPECT_EQ(doubles(ruled.knots.list()), (std::vector<double>{0.1, 0.1, 0.7, 0.7}));
  EXPECT_EQ(doubles(ruled.c.weights), (std::vector<double>{1, 0.3, 2}));
  EXPECT_EQ(doubles(ruled.d.weights), (std::vector<double>{0.5, 1, 0.7}));
  EXPECT_EQ(doubles(ruled.c.points[0]), (std::vector<double>{0.1, 0.2, 0.30000000000000004}));
  EXPECT_EQ(doubles(ruled.d.points[0]), (std::vector<double>{1e-7, -2500, 3}));
  EXPECT_EQ(doubles(ruled.d.points[2]), (std::vector<double>{1, 0, 0.3333333333333333}));
  EXPECT_EQ(ruled.c.points[0][0], d(0.1));  // the double itself, no decimal
}

/// A name property comes before the label; blanks around it are not of the name.
TEST_F(Iges, NamesArePropertiesWithoutTheirBlanks) {
  IgesText iges;
  const int name = iges.add(406, "1,11H  bow two  ", {.form = 15, .dependent = true});
  const int c = iges.line("0.,0.,0.", "1.,0.,0.");
  const int d = iges.line("0.,1.,0.", "1.,1.,0.");
  iges.add(118, std::to_string(c) + "," + std::to_string(d) + ",0,1,0,1," + std::to_string(name),
           {.form = 1, .label = "LABEL"});
  const std::vector<cli::Face> read = faces(iges);
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0].name, "bow two");
}

TEST_F(Iges, TheDevelopableFlagIsAudited) {
  IgesText iges;
  const int flat = iges.line("0.,0.,0.", "1.,0.,0.");
  const int beside = iges.line("0.,1.,0.", "1.,1.,0.");
  const int skew = iges.line("0.,1.,0.", "1.,1.,1.");
  iges.ruled(flat, beside, 0, 1, {.form = 1, .label = "TRUE"});
  iges.ruled(flat, skew, 0, 1, {.form = 1, .label = "LIE"});
  iges.ruled(flat, beside, 0, 0, {.form = 1, .label = "MODEST"});
  iges.ruled(flat, skew, 0, 0, {.form = 1, .label = "TWISTED"});
  const json report = check(iges);
  ASSERT_EQ(report.size(), 4U);
  const auto row = [&](std::size_t i) {
    return std::make_tuple(report[i]["name"], report[i]["claimed_developable"], report[i]["claim"]);
  };
  EXPECT_EQ(row(0), std::make_tuple(json("TRUE"), json(true), json("true")));
  EXPECT_EQ(row(1), std::make_tuple(json("LIE"), json(true), json("false")));
  EXPECT_EQ(row(2), std::make_tuple(json("MODEST"), json(false), json("unclaimed")));
  EXPECT_EQ(row(3), std::make_tuple(json("TWISTED"), json(false), json("none")));
}

TEST_F(Iges, RailsOfDifferentDegreesAreMadeCompatibleExactly) {
  // The cone with vertex (0, 0, 1) over a parabola, its upper rail given with degree 3 and thirds that are no doubles
  // elsewhere: c = (0,0,0), (3,3,0), (6,0,0); d is the same arc halfway up, elevated.
  IgesText iges;
  const int c = iges.bezier(2, "1.,1.,1.", "0.,0.,0.,3.,3.,0.,6.,0.,0.");
  const int up = iges.bezier(3, "1.,1.,1.,1.", "0.,0.,0.5,1.,1.,0.5,2.,1.,0.5,3.,0.,0.5");
  iges.ruled(c, up, 0, 1, {.form = 1});
  const json report = check(iges);
  ASSERT_EQ(report.size(), 1U);
  EXPECT_EQ(report[0]["class"], "cone");
  EXPECT_EQ(report[0]["vertex"], json({"0", "0", "1"}));
}

TEST_F(Iges, TheDirectionFlagTurnsTheSecondRail) {
  // A parabola and its mirror image, which runs the other way: turned round it is the first one moved up.
  IgesText iges;
  const int c = iges.bezier(2, "1.,1.,1.", "0.,0.,0.,1.,2.,0.,3.,0.,0.");
  const int back = iges.bezier(2, "1.,1.,1.", "3.,0.,1.,1.,2.,1.,0.,0.,1.");
  iges.ruled(c, back, 1, 0, {.form = 1});
  iges.ruled(c, back, 0, 0, {.form = 1});
  const json report = check(iges);
  ASSERT_EQ(report.size(), 2U);
  EXPECT_EQ(report[0]["class"], "cylinder");
  EXPECT_EQ(report[0]["direction"], json({"0", "0", "1"}));
  EXPECT_EQ(report[1]["developable"], false);
}

TEST_F(Iges, RulingsByArcLengthAreDecidedWhereTheyAreRulingsByParameter) {
  IgesText iges;
  const int line = iges.line("0.,0.,0.", "1.,0.,0.");
  const int longer = iges.line("0.,1.,0.", "3.,1.,0.");
  const int curve = iges.bezier(2, "1.,1.,1.", "0.,0.,0.,1.,2.,0.,3.,0.,0.");
  const int twice = iges.bezier(2, "1.,1.,1.", "0.,0.,1.,2.,4.,1.,6.,0.,1.");
  const int other = iges.bezier(2, "1.,1.,1.", "0.,0.,1.,1.,3.,1.,3.,0.,1.");
  iges.ruled(line, longer, 0, 1, {.form = 0});  // lines run at constant speed
  iges.ruled(curve, twice, 0, 1, {.form = 0});  // a homothety keeps relative arc length
  iges.ruled(curve, other, 0, 1, {.form = 0});  // nothing of the kind
  const json report = check(iges);
  ASSERT_EQ(report.size(), 3U);
  EXPECT_EQ(report[0]["class"], "plane");
  EXPECT_EQ(report[1]["class"], "cone");
  EXPECT_EQ(report[2]["ruled"], false);
  EXPECT_THAT(report[2]["remark"].get<std::string>(), HasSubstr("arc length"));
}

TEST_F(Iges, LinesThatTurnAndTabulatedCylinders) {
  IgesText iges;
  const int axis = iges.line("1.,2.,0.", "1.,2.,5.");
  iges.add(120,
           std::to_string(axis) + "," + std::to_string(iges.line("4.,2.,0.", "4.,2.,7.")) + ",0.,6.283185307179586",
           {.label = "TUBE"});
  iges.add(120, std::to_string(axis) + "," + std::to_string(iges.line("4.,2.,0.", "2.,2.,2.")) + ",0.,2.",
           {.label = "CONE"});
  iges.add(120, std::to_string(axis) + "," + std::to_string(iges.line("4.,2.,0.", "9.,2.,0.")) + ",0.,1.",
           {.label = "DISK"});
  iges.add(120, std::to_string(axis) + "," + std::to_string(iges.line("4.,2.,0.", "4.,3.,5.")) + ",0.,1.",
           {.label = "WAIST"});
  iges.add(122, std::to_string(iges.bezier(2, "1.,0.3,2.", "0.1,0.,0.,1.,2.,0.7,3.,0.,0.1")) + ",0.3,0.1,4.",
           {.label = "WALL"});
  const json report = check(iges);
  ASSERT_EQ(report.size(), 5U);
  EXPECT_EQ(report[0]["class"], "cylinder");
  EXPECT_EQ(report[0]["direction"], json({"0", "0", "1"}));
  EXPECT_EQ(report[1]["class"], "cone");
  EXPECT_EQ(report[1]["vertex"], json({"1", "2", "3"}));
  EXPECT_EQ(report[2]["class"], "plane");
  EXPECT_EQ(report[3]["developable"], false);
  EXPECT_EQ(report[3]["type"], "revolution");
  EXPECT_EQ(report[4]["class"], "cylinder");
  EXPECT_EQ(report[4]["type"], "extrusion");
}

TEST_F(Iges, UnitsAreTheFilesOwn) {
  for (const auto& [flag, name, metres] : {std::make_tuple(1, "inch", 0.0254), {2, "mm", 0.001}, {6, "m", 1.0}}) {
    IgesText iges(flag);
    iges.ruled(iges.line("0.,0.,0.", "0.1,0.,0."), iges.line("0.,1.,0.", "0.1,1.,0."), 0, 0, {.form = 1});
    const std::vector<cli::Face> read = faces(iges);
    ASSERT_EQ(read.size(), 1U);
    EXPECT_EQ(read[0].cad->unit, name);
    EXPECT_EQ(read[0].cad->metres, metres);
    EXPECT_EQ(read[0].cad->tolerance, 1e-5);
    EXPECT_EQ(read[0].surface->c.points[1][0], d(0.1));
  }
}

TEST_F(Iges, AMatrixMovesTheSurfaceExactly) {
  // A shear is no rigid motion, but an affine map keeps a cone a cone.
  IgesText iges;
  const int matrix = iges.add(124, "1.,0.,0.,10., 0.,0.,-1.,0., 0.,1.,0.,0.5");
  const int c = iges.bezier(2, "1.,1.,1.", "0.,0.,0.,3.,3.,0.,6.,0.,0.");
  const int up = iges.bezier(2, "1.,1.,1.", "0.,0.,0.5,1.5,1.5,0.5,3.,0.,0.5");
  iges.ruled(c, up, 0, 1, {.form = 1, .matrix = matrix});
  const json report = check(iges);
  ASSERT_EQ(report.size(), 1U);
  EXPECT_EQ(report[0]["vertex"], json({"10", "-1", "1/2"}));  // (x, y, z) goes to (x + 10, -z, y + 1/2)
}

TEST_F(Iges, AMatrixMovesPointsWhateverTheirWeights) {
  IgesText iges;
  const int matrix = iges.add(124, "1.,0.,0.,10., 0.,1.,0.,20., 0.,0.,1.,30.");
  const int c = iges.bezier(2, "1.,3.,0.5", "0.,0.,0.,3.,3.,0.,6.,0.,0.");
  const int up = iges.bezier(2, "1.,0.25,2.", "0.,0.,1.,3.,3.,1.,6.,0.,1.");
  iges.ruled(c, up, 0, 0, {.form = 1, .matrix = matrix});
  const std::vector<cli::Face> read = faces(iges);
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(doubles(read[0].surface->c.points[1]), (std::vector<double>{13, 23, 30}));
  EXPECT_EQ(doubles(read[0].surface->d.points[2]), (std::vector<double>{16, 20, 31}));
  EXPECT_EQ(doubles(read[0].surface->d.weights), (std::vector<double>{1, 0.25, 2}));
}

TEST_F(Iges, AMatrixMovesACurveAlone) {
  IgesText iges;
  const int matrix = iges.add(124, "1.,0.,0.,0., 0.,1.,0.,3., 0.,0.,1.,0.5");
  const int c = iges.line("0.,0.,0.", "1.,0.,0.");
  const int moved = iges.add(110, "0.,0.,0.,1.,0.,0.", {.matrix = matrix, .dependent = true});
  iges.ruled(c, moved, 0, 1, {.form = 1});
  const std::vector<cli::Face> read = faces(iges);
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(doubles(read[0].surface->c.points[1]), (std::vector<double>{1, 0, 0}));
  EXPECT_EQ(doubles(read[0].surface->d.points[1]), (std::vector<double>{1, 3, 0.5}));
}

TEST_F(Iges, ACurveEndsWhereItsRangeEnds) {
  // (8t, 8t^2, 0) on [0, 1], of which [1/4, 3/4] is used: from (2, 1/2, 0) to (6, 9/2, 0).
  IgesText iges;
  const std::string points = "0.,0.,0.,4.,0.,0.,8.,8.,0.";
  const int part =
      iges.add(126, "2,2,0,0,0,0,0.,0.,0.,1.,1.,1.,1.,1.,1.," + points + ",0.25,0.75,0.,0.,0.", {.dependent = true});
  iges.ruled(part, iges.bezier(2, "1.,1.,1.", "0.,0.,1.,4.,0.,1.,8.,8.,1."), 0, 0, {.form = 1});
  const std::vector<cli::Face> read = faces(iges);
  ASSERT_EQ(read.size(), 1U);
  ASSERT_TRUE(read[0].surface);
  EXPECT_EQ(doubles(read[0].surface->c.points.front()), (std::vector<double>{2, 0.5, 0}));
  EXPECT_EQ(doubles(read[0].surface->c.points.back()), (std::vector<double>{6, 4.5, 0}));
  EXPECT_EQ(doubles(read[0].surface->d.points.back()), (std::vector<double>{8, 8, 1}));
}

/// The same curve from its begin, or to its end.
TEST_F(Iges, ACurveWithOneEndMoved) {
  const std::string points = "0.,0.,0.,4.,0.,0.,8.,8.,0.";
  for (const auto& [range, from, to] :
       {std::tuple{"0.,0.75", 0.0, 6.0}, std::tuple{"0.25,1.", 2.0, 8.0}, std::tuple{"0.,1.", 0.0, 8.0}}) {
    IgesText iges;
    const int part = iges.add(126, "2,2,0,0,0,0,0.,0.,0.,1.,1.,1.,1.,1.,1.," + points + "," + range + ",0.,0.,0.",
                              {.dependent = true});
    iges.ruled(part, iges.bezier(2, "1.,1.,1.", "0.,0.,1.,4.,0.,1.,8.,8.,1."), 0, 0, {.form = 1});
    const std::vector<cli::Face> read = faces(iges);
    ASSERT_EQ(read.size(), 1U);
    EXPECT_EQ(doubles(read[0].surface->c.points.front())[0], from) << range;
    EXPECT_EQ(doubles(read[0].surface->c.points.back())[0], to) << range;
  }
}

TEST_F(Iges, TheMatrixOfASurfaceComesBeforeThatOfItsFace) {
  // (x, y, z) goes to (x + 10, y, z), and that to (-y, x, z).
  IgesText iges;
  const int shift = iges.add(124, "1.,0.,0.,10., 0.,1.,0.,0., 0.,0.,1.,0.");
  const int turn = iges.add(124, "0.,-1.,0.,0., 1.,0.,0.,0., 0.,0.,1.,0.");
  const int ruled = iges.add(118,
                             std::to_string(iges.line("0.,0.,0.", "1.,0.,0.")) + "," +
                                 std::to_string(iges.line("0.,0.,1.", "1.,0.,1.")) + ",0,1",
                             {.form = 1, .matrix = shift, .dependent = true});
  iges.add(144, std::to_string(ruled) + ",0,0,0", {.matrix = turn});
  const std::vector<cli::Face> read = faces(iges);
  ASSERT_EQ(read.size(), 1U);
  ASSERT_TRUE(read[0].surface);
  EXPECT_EQ(doubles(read[0].surface->c.points[0]), (std::vector<double>{0, 10, 0}));
  EXPECT_EQ(doubles(read[0].surface->d.points[1]), (std::vector<double>{0, 11, 1}));
}

/// The surface that is offset is no face of the part, though the file does not say that it depends on anything.
TEST_F(Iges, AnOffsetSurfaceIsOneFace) {
  IgesText iges;
  const int below = iges.add(128,
                             "1,1,1,1,0,0,1,0,0, 0.,0.,1.,1., 0.,0.,1.,1., 1.,1.,1.,1., 0.,0.,0., 4.,0.,0., 0.,2.,0., "
                             "4.,2.,0., 0.,1.,0.,1.");
  iges.add(140, "0.,0.,1.,0.5," + std::to_string(below));
  EXPECT_EQ(faces(iges).size(), 1U);
}

TEST_F(Iges, ASurfaceEndsWhereItsRangesEnd) {
  // z = x y on [0, 4] x [0, 2] by x = 4u, y = v; used for u in [1/4, 1/2] and v in [0, 1].
  IgesText iges;
  iges.add(128,
           "1,1,1,1,0,0,1,0,0, 0.,0.,1.,1., 0.,0.,2.,2., 1.,1.,1.,1., 0.,0.,0., 4.,0.,0., 0.,2.,0., 4.,2.,8.,"
           "0.25,0.5,0.,1.");
  const std::vector<cli::Face> read = faces(iges);
  ASSERT_EQ(read.size(), 1U);
  EXPECT_TRUE(read[0].cad->trimmed);
  ASSERT_TRUE(read[0].surface);
  EXPECT_EQ(doubles(read[0].surface->c.points[0]), (std::vector<double>{1, 0, 0}));
  EXPECT_EQ(doubles(read[0].surface->d.points[1]), (std::vector<double>{2, 1, 2}));
}

/// Two planes that meet at v = 1, of which one is used, up to where the other begins.
TEST_F(Iges, ASurfaceThatEndsAtAKnotAcrossIsOneStrip) {
  IgesText iges;
  iges.add(128,
           "1,2,1,1,0,0,1,0,0, 0.,0.,1.,1., 0.,0.,1.,2.,2., 1.,1.,1.,1.,1.,1., 0.,0.,0., 4.,0.,0., 0.,2.,0., 4.,2.,0.,"
           "0.,2.,3., 4.,2.,3., 0.,1.,0.,1.");
  const std::vector<cli::Face> read = faces(iges);
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(doubles(read[0].surface->d.points[1]), (std::vector<double>{4, 2, 0}));
}

/// An unclamped curve begins between its control points, here at (1, 1, 0): the vector is that from there to the point.
TEST_F(Iges, ATabulatedCylinderOverAnUnclampedCurve) {
  IgesText iges;
  const int curve = iges.add(
      126, "2,2,0,0,1,0, 0.,1.,2.,3.,4.,5., 1.,1.,1., 0.,0.,0.,2.,2.,0.,5.,0.,0., 2.,3.,0.,0.,1.", {.dependent = true});
  iges.add(122, std::to_string(curve) + ",1.5,1.25,4.");
  const std::vector<cli::Face> read = faces(iges);
  ASSERT_EQ(read.size(), 1U);
  const RuledFile<Rational>& strip = *read[0].surface;
  for (std::size_t i = 0; i < strip.c.points.size(); ++i) {
    EXPECT_EQ(doubles(Vec<Rational, 3>(strip.d.points[i] - strip.c.points[i])), (std::vector<double>{0.5, 0.25, 4}));
  }
}

/// A resolution of 1/64 mm is 1/64000 m.
TEST_F(Iges, TheResolutionIsWrittenInTheUnitOfTheOutput) {
  IgesText iges;
  iges.add(128,
           "1,1,1,1,0,0,1,0,0, 0.,0.,1.,1., 0.,0.,1.,1., 1.,1.,1.,1., 0.,0.,0., 4.,0.,0., 0.,2.,0., 4.,2.,0.,"
           "0.,1.,0.,1.");
  const std::string out = (scratch / "out.igs").string();
  const double before = check(iges)[0]["tolerance"];
  ASSERT_EQ(run_program({"convert", file(iges), "--unit", "m", "-o", out}).exit, 0);
  const double after = json::parse(run_program({"check", out, "--json", "-"}).out)["surfaces"][0]["tolerance"];
  EXPECT_GT(before, 0);
  EXPECT_NEAR(after * 1000 / before, 1, 1e-12);
}

TEST_F(Iges, RulingsByArcLengthNeedOneRatioOfSpeedsForAllPieces) {
  // Polygons of two legs each, 1 and 1 long, 1 and 3 long: at equal parameters the relative lengths differ.
  IgesText iges;
  const auto polygon = [&](const std::string& points) {
    return iges.add(126, "2,1,0,0,1,0,0.,0.,1.,2.,2.,1.,1.,1.," + points + ",0.,2.,0.,0.,0.", {.dependent = true});
  };
  const int even = polygon("0.,0.,0.,1.,0.,0.,2.,0.,0.");
  const int uneven = polygon("0.,1.,0.,1.,1.,0.,4.,1.,0.");
  iges.ruled(even, uneven, 0, 1, {.form = 0});
  const std::vector<cli::Face> read = faces(iges);
  ASSERT_EQ(read.size(), 1U);
  EXPECT_FALSE(read[0].surface);
  EXPECT_THAT(read[0].remark, HasSubstr("arc length"));
}

/// The global section, field by field: two separators that are the usual ones, who wrote it, 32 bits, 38 and 6, 308 and
/// 15 for numbers, no receiver, scale 1, millimetres (2), line weights, when it was written (2-digit year), the
/// tolerance and the largest coordinate of the whole, no author, version 5.3 (11), no drafting standard, when it was
/// changed (4-digit year).
TEST_F(Iges, TheHeaderOfWhatIsWritten) {
  const std::string source = (scratch / "square.json").string();
  spill(source, R"({"torse": 1, "type": "ruled", "degree": 1, "knots": ["0", "1"],
                    "c": {"points": [["0", "0", "0"], ["3", "0", "0"]]},
                    "d": {"points": [["0", "1", "0"], ["-1", "1", "0"]]}})");
  const std::string written = (scratch / "square.igs").string();
  ASSERT_EQ(run_program({"convert", source, "-o", written}).exit, 0);
  std::string global;
  std::istringstream lines(slurp(written));
  for (std::string line; std::getline(lines, line);) {
    if (line.size() >= 73 && line[72] == 'G') global += line.substr(0, 72);
  }
  const std::regex expected(
      R"(,,5Htorse,9Htorse\.igs,5Htorse,5Htorse,32,38,6,308,15,,1\.,2,2HMM,1,0\.01, *13H\d{6}\.\d{6},1E-07,3\.,,,11,0,)"
      R"(15H20\d{6}\.\d{6}; *)");
  EXPECT_TRUE(std::regex_match(global, expected)) << global;
}

}  // namespace
}  // namespace torse::testing
