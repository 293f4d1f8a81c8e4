// torse convert, the real program: formats, options, errors that leave no file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "support/program.hpp"

namespace torse::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

/// A cylinder over a parabola, 30 wide and 5 high.
const std::string plate = R"({"torse": 1, "type": "ruled", "degree": 2,
 "c": {"points": [[0,0,0],[10,"20/3",0],[30,0,0]]}, "d": {"points": [[0,0,5],[10,"20/3",5],[30,0,5]]}})";

class Convert : public ::testing::Test {
 public:
  std::string input(const std::string& text) const {
    spill(scratch / "plate.json", text);
    return (scratch / "plate.json").string();
  }
  std::string out(const std::string& name) const { return (scratch / name).string(); }
  ProgramResult convert(const std::string& name, const std::vector<std::string>& options = {}) const {
    std::vector<std::string> words{"convert", input(plate), "-o", out(name)};
    words.insert(words.end(), options.begin(), options.end());
    return run_program(words);
  }
  Scratch scratch;
};

TEST_F(Convert, EveryMeshFormat) {
  for (const char* name : {"a.obj", "a.stl", "a.gltf", "a.glb", "A.OBJ"}) {
    const ProgramResult result = convert(name);
    EXPECT_EQ(result.exit, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("plate: "));
    EXPECT_THAT(result.out, HasSubstr("triangles, at most "));
  }
  EXPECT_THAT(slurp(out("a.obj")), HasSubstr("o plate\n"));
  EXPECT_EQ(slurp(out("a.obj")), slurp(out("A.OBJ")));
  EXPECT_EQ(json::parse(slurp(out("a.gltf"))).at("nodes").at(0).at("name"), "plate");
}

TEST_F(Convert, JsonIsExact) {
  EXPECT_EQ(convert("b.json").exit, 0);
  const json surface = json::parse(slurp(out("b.json")));
  EXPECT_EQ(surface.at("c").at("points").at(1).at(1), "20/3");
  EXPECT_EQ(run_program({"convert", out("b.json"), "-o", out("c.json")}).exit, 0);
  EXPECT_EQ(slurp(out("b.json")), slurp(out("c.json")));
}

TEST_F(Convert, TheToleranceHoldsAndIsReported) {
  std::size_t triangles = 0;
  for (const char* tolerance : {"1", "1/10", "1e-4"}) {
    const ProgramResult result = convert("a.obj", {"--tolerance", tolerance, "--json", "-"});
    EXPECT_EQ(result.exit, 0) << result.err;
    EXPECT_TRUE(result.out.starts_with("{\n  \"torse\": 1,\n  \"output\"")) << result.out;
    const json face = json::parse(result.out).at("surfaces").at(0);
    EXPECT_EQ(face.at("name"), "plate");
    EXPECT_TRUE(face.at("ruled"));
    EXPECT_LE(face.at("mesh").at("deviation"), face.at("mesh").at("tolerance"));
    EXPECT_GT(face.at("mesh").at("triangles"), triangles);
    if (tolerance == std::string("1/10")) {
      EXPECT_LT(face.at("mesh").at("tolerance").get<double>(), 0.1);  // which is above 1/10
    }
    triangles = face.at("mesh").at("triangles");
  }
  EXPECT_LT(triangles, 1024U);
}

/// The largest x of the positions.
double reach(const std::string& text) {
  const json gltf = json::parse(text);
  return gltf.at("accessors").at(0).at("max").at(0);
}

TEST_F(Convert, GltfIsInMetres) {
  convert("mm.gltf");
  convert("in.gltf", {"--unit", "in"});
  EXPECT_FLOAT_EQ(static_cast<float>(reach(slurp(out("mm.gltf")))), 0.03F);
  EXPECT_FLOAT_EQ(static_cast<float>(reach(slurp(out("in.gltf")))), 0.762F);
}

TEST_F(Convert, UsageErrors) {
  EXPECT_THAT(convert("plate.txt").err, HasSubstr("expected an extension among .json"));
  EXPECT_THAT(convert("-").err, HasSubstr("expected an extension"));
  EXPECT_THAT(convert("a.obj", {"--tolerance", "0"}).err, HasSubstr("--tolerance: expected a length above 0"));
  EXPECT_THAT(convert("a.obj", {"--tolerance", "nan"}).err, HasSubstr("--tolerance: expected"));
  EXPECT_THAT(convert("a.json", {"--tolerance", "1"}).err, HasSubstr("--tolerance is for meshes"));
  EXPECT_THAT(convert("a.gltf", {"--unit", "cubit"}).err, HasSubstr("--unit: expected one of mm"));
  EXPECT_THAT(convert("a.json", {"--unit", "mm"}).err, HasSubstr("--unit"));
  EXPECT_EQ(convert("plate.txt").exit, 2);
}

/// The second piece is a segment, 7 long outside of the only triangle.
TEST_F(Convert, APieceThatSweepsNoSurfaceIsNamed) {
  const std::string degenerate = R"({"torse": 1, "type": "ruled", "degree": 1, "knots": [0, 2, 3],
    "c": {"points": [["8/5", "-1/6", -4], ["-3/2", -1, 2], [-9, -1, "4/5"]]},
    "d": {"points": [[0, "-9/4", 4], ["-3/2", -1, 2], [-9, -1, "4/5"]]}})";
  for (const char* name : {"a.obj", "a.stl", "a.glb"}) {
    const ProgramResult result =
        run_program({"convert", input(degenerate), "-o", out(name), "--unit", "m", "--tolerance", "1/2"});
    EXPECT_EQ(result.exit, 2);
    EXPECT_THAT(result.err, HasSubstr("points: sweep no surface in piece 2 farther than the tolerance from the rest"));
    EXPECT_FALSE(std::filesystem::exists(out(name)));
  }
}

/// A cone over (0, 0, 0), which is where its other rail begins: rulings there are short, but sweep a surface. The rail
/// (t, t^2, 0) bounds 1/6 with its chord.
TEST_F(Convert, ARailMayBeginAtTheVertex) {
  const std::string fan = R"({"torse": 1, "type": "ruled", "degree": 2,
    "c": {"points": [[0, 0, 0], ["1/2", 0, 0], [1, 1, 0]]}, "d": {"points": [[0, 0, 0], [0, 0, 0], [0, 0, 0]]}})";
  for (const char* name : {"a.obj", "a.stl", "a.glb"}) {
    EXPECT_EQ(run_program({"convert", input(fan), "-o", out(name), "--unit", "m", "--tolerance", "1/1000"}).exit, 0);
  }
  std::istringstream lines(slurp(scratch / "a.obj"));
  std::vector<std::array<double, 3>> points;
  double area = 0;
  for (std::string word; lines >> word;) {
    if (word == "v") {
      std::array<double, 3>& point = points.emplace_back();
      lines >> point[0] >> point[1] >> point[2];
    } else if (word == "f") {
      std::array<std::array<double, 3>, 3> corner;
      for (std::array<double, 3>& place : corner) {
        lines >> word;
        place = points.at(std::stoul(word) - 1);
      }
      const auto [a, b, c] = corner;
      area += ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
    }
  }
  EXPECT_NEAR(std::abs(area), 1.0 / 6.0, 1e-3);
}

TEST_F(Convert, ErrorsLeaveTheOldFile) {
  spill(scratch / "a.obj", "old");
  for (const char* tolerance : {"1e-40", "1e-4000"}) {
    const ProgramResult result = convert("a.obj", {"--tolerance", tolerance});
    EXPECT_EQ(result.exit, 2);
    EXPECT_THAT(result.err, HasSubstr("face \"plate\": tolerance: is below"));
    EXPECT_THAT(result.err, HasSubstr("replay: torse convert --tolerance 1e-40"));
  }
  EXPECT_EQ(run_program({"convert", input("{"), "-o", out("a.obj")}).exit, 2);
  const std::string far = R"({"torse": 1, "type": "ruled", "degree": 1, "c": {"points": [[0,0,0],[1e39,0,0]]},
    "d": {"points": [[0,1e39,0],[1e39,1e39,0]]}})";
  EXPECT_THAT(run_program({"convert", input(far), "-o", out("a.stl")}).err, HasSubstr("single precision"));
  EXPECT_EQ(run_program({"convert", input(far), "-o", out("far.obj")}).exit, 0);
  const std::string point = R"({"torse": 1, "type": "ruled", "degree": 1, "c": {"points": [[7,0,0],[7,0,0]]},
    "d": {"points": [[7,0,0],[7,0,0]]}})";
  EXPECT_THAT(run_program({"convert", input(point), "-o", out("a.obj")}).err, HasSubstr("there is no surface"));
  EXPECT_EQ(slurp(out("a.obj")), "old");
}

}  // namespace
}  // namespace torse::testing
