// Weights of IGES splines that OpenCASCADE takes for ones.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cad/iges_files.hpp"
#include "support/program.hpp"
#include "torse/cli/faces.hpp"

namespace torse::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

class IgesWeights : public IgesFiles {
 public:
  json check(const IgesText& iges) const {
    return json::parse(run_program({"check", file(iges), "--json", "-"}).out)["surfaces"];
  }
};

/// A parabola c and c + (0, 0, 4): a cylinder with the same weights up to a factor, else not. All weights of one rail
/// are tiny, or nearly equal: OpenCASCADE takes those for ones.
TEST_F(IgesWeights, TinyAndNearlyEqualWeightsAreNoOnes) {
  const char* const c = "0.,0.,0.,1.,2.,0.,4.,3.,0.";
  const char* const d = "0.,0.,4.,1.,2.,4.,4.,3.,4.";
  const auto tiny = [](const std::string& middle) { return "1.D-13," + middle + "D-13,2.D-13"; };
  const auto developable = [&](const std::string& of_c, const std::string& of_d) {
    IgesText iges;
    iges.ruled(iges.bezier(2, of_c, c), iges.bezier(2, of_d, d), 0, 0, {.form = 1});
    iges.add(128, "2,1,2,1,0,0,0,0,0, 0.,0.,0.,1.,1.,1., 0.,0.,1.,1.," + of_c + "," + of_d + "," + c + "," + d +
                      ",0.,1.,0.,1.");
    const json report = check(iges);
    EXPECT_EQ(report.size(), 2U);
    const bool answer = report[0]["developable"];
    EXPECT_EQ(report[1]["developable"], answer) << of_c << " " << of_d;
    return answer;
  };
  EXPECT_TRUE(developable(tiny("3."), tiny("3.")));
  EXPECT_FALSE(developable(tiny("3."), tiny("5.")));
  EXPECT_FALSE(developable(tiny("3."), "1.,1.,1."));
  EXPECT_FALSE(developable("1.,1.,1.", tiny("3.")));
  EXPECT_FALSE(developable("1.,1.,1.", "1.,1.00000000001,1."));
  EXPECT_TRUE(developable("1.,1.00000000001,1.", "1.,1.00000000001,1."));
  EXPECT_TRUE(developable("1.D-13,1.D-13,1.D-13", "1.,1.,1."));
}

/// An exponent counts whatever letter it has: 1e-12 is twice 5e-13, both as doubles and as numbers.
TEST_F(IgesWeights, ExponentsOfTinyWeightsAreRead) {
  const char* const c = "0.,0.,0.,1.,2.,0.,4.,3.,0.";
  const char* const d = "0.,0.,4.,1.,2.,4.,4.,3.,4.";
  for (const std::string letter : {"D", "d", "E", "e"}) {
    const std::string weights = "1." + letter + "-12,5." + letter + "-13,1." + letter + "-12";
    IgesText iges;
    iges.ruled(iges.bezier(2, weights, c), iges.bezier(2, "1.,1.,1.", d), 0, 0, {.form = 1});
    iges.add(128, "2,1,2,1,0,0,0,0,0, 0.,0.,0.,1.,1.,1., 0.,0.,1.,1.," + weights + "," + weights + "," + c + "," + d +
                      ",0.,1.,0.,1.");
    const std::vector<cli::Face> read = cli::read_faces(file(iges), "");
    ASSERT_EQ(read.size(), 2U) << letter;
    for (const cli::Face& face : read) {
      ASSERT_TRUE(face.surface) << letter;
      const std::vector<Rational>& w = face.surface->c.weights;
      EXPECT_EQ(w[1] / w[0], ratio<Rational>(1, 2)) << letter;
      EXPECT_EQ(w[2], w[0]) << letter;
    }
  }
}

/// A quarter of the unit circle, of which the part from (3/5, 4/5) to (0, 1) is used, and a cylinder over it from z =
/// 1/4 on: the ranges stay with tiny weights.
TEST_F(IgesWeights, RangesOfSplinesWithTinyWeightsStay) {
  const std::string w = "1.D-12,1.D-12,2.D-12,";
  const std::string knots = "0.,0.,0.,1.,1.,1.,";
  const std::string c = "1.,0.,0.,1.,1.,0.,0.,1.,0.,";
  const std::string d = "1.,0.,1.,1.,1.,1.,0.,1.,1.,";
  IgesText iges;
  const int part = iges.add(126, "2,2,0,0,0,0," + knots + w + c + "0.5,1.,0.,0.,0.", {.dependent = true});
  iges.ruled(part, iges.line("1.,0.,1.", "0.,1.,1."), 0, 0, {.form = 1});
  iges.add(128, "2,1,2,1,0,0,0,0,0," + knots + "0.,0.,1.,1.," + w + w + c + d + "0.5,1.,0.25,1.");
  const std::vector<cli::Face> read = cli::read_faces(file(iges), "");
  ASSERT_EQ(read.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    ASSERT_TRUE(read[i].surface) << i;
    const auto& from = read[i].surface->c.points.front();
    const auto& to = read[i].surface->c.points.back();
    EXPECT_NEAR(from[0].to_double(), 0.6, 1e-15) << i;
    EXPECT_NEAR(from[1].to_double(), 0.8, 1e-15) << i;
    EXPECT_EQ(to[0], Rational(0)) << i;
    EXPECT_EQ(to[1], Rational(1)) << i;
    EXPECT_EQ(from[2], i == 0 ? Rational(0) : ratio<Rational>(1, 4)) << i;
  }
}

/// What is written keeps its weights too: both rails have the same ones up to a power of two, one of them tiny.
TEST_F(IgesWeights, TinyWeightsAreWrittenAsWeights) {
  spill(scratch / "net.json", R"({"torse": 1, "type": "ruled", "degree": 2, "knots": [0, 0, 1, 1],
    "c": {"points": [[0, 0, 0], [1, 2, 0], [4, 3, 0]], "weights": ["0x1p-40", "0x3p-40", "0x1p-39"]},
    "d": {"points": [[0, 0, 4], [1, 2, 4], [4, 3, 4]], "weights": [1, 3, 2]}})");
  const std::string out = (scratch / "out.igs").string();
  const ProgramResult written = run_program({"convert", (scratch / "net.json").string(), "-o", out});
  EXPECT_EQ(written.exit, 0) << written.err;
  const ProgramResult read = run_program({"check", out});
  EXPECT_EQ(read.exit, 0) << read.out;
  EXPECT_THAT(read.out, HasSubstr("cylinder, direction (0, 0, 1)"));
}

/// The weight stays with its sign: a cylinder over a curve with a negative weight, and another one above it.
TEST_F(IgesWeights, ANegativeWeightOfASurfaceIsRead) {
  for (const bool same : {true, false}) {
    IgesText iges;
    iges.add(128, std::string("2,1,2,1,0,0,0,0,0, 0.,0.,0.,1.,1.,1., 0.,0.,1.,1., 1.,-.5,3., 1.,") +
                      (same ? "-.5" : ".5") +
                      ",3., 0.,0.,0.,1.,2.,0.,4.,3.,0., 0.,0.,4.,1.,2.,4.,4.,3.,4.,0.,1.,0.,1.");
    const std::vector<cli::Face> read = cli::read_faces(file(iges), "");
    ASSERT_TRUE(read[0].surface);
    EXPECT_EQ(read[0].surface->c.weights, (std::vector<Rational>{Rational(1), ratio<Rational>(-1, 2), Rational(3)}));
    EXPECT_EQ(check(iges)[0]["developable"], same);
  }
}

}  // namespace
}  // namespace torse::testing
