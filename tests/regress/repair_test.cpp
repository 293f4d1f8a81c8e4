// torse check --repair, the real program: what it writes, what it reports, what it refuses.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "support/program.hpp"

namespace torse::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

/// A cone with vertex (1, 1, 8), d = V + 1/2 (c - V), one coordinate moved by 1/1000.
const std::string nearly_cone = R"({"torse": 1, "type": "ruled", "degree": 3,
 "c": {"points": [[0,0,0],[2,3,0],[4,-1,0],[6,2,2]]},
 "d": {"points": [["1/2","1/2",4],["3/2",2,4],["5/2",0,"4.001"],["7/2","3/2",5]]}})";
const std::string flat = R"({"torse": 1, "type": "ruled", "degree": 1,
 "c": {"points": [[0,0,0],[1,0,0]]}, "d": {"points": [[0,1,0],[1,1,0]]}})";

class Repair : public ::testing::Test {
 public:
  std::string path(const std::string& name) const { return (scratch / name).string(); }
  std::string file(const std::string& name, const std::string& text) const {
    spill(scratch / name, text);
    return path(name);
  }
  Scratch scratch;
};

TEST_F(Repair, WritesADevelopableSurfaceAndSaysHowFarItIs) {
  const ProgramResult result =
      run_program({"check", file("cone.json", nearly_cone), "--repair", path("out.json"), "--json", "-"});
  EXPECT_EQ(result.exit, 1);  // the verdict on the input
  const json repair = json::parse(result.out)["surfaces"][0]["repair"];
  EXPECT_EQ(repair["file"], path("out.json"));
  EXPECT_EQ(repair["class"], "cone");
  EXPECT_EQ(repair["family"], "cone");
  EXPECT_EQ(repair["Lambda"], nullptr);
  EXPECT_LE(repair["max_distance"], 1e-3);
  EXPECT_LE(repair["rms_distance"], 1.01e-3 / std::sqrt(8));
  EXPECT_GE(repair["rms_distance"], 1e-5);
  EXPECT_EQ(repair["surface_distance"], repair["max_distance"]);
  EXPECT_EQ(repair["max_weight_change"], 0);
  EXPECT_GT(repair["ulps"], 1e8);
  EXPECT_GE(repair["families"].size(), 4U);

  const ProgramResult again = run_program({"check", path("out.json"), "--json", "-"});
  EXPECT_EQ(again.exit, 0);
  const json surface = json::parse(again.out)["surfaces"][0];
  EXPECT_EQ(surface["class"], "cone");
  EXPECT_EQ(surface["vertex"], repair["vertex"]);
}

TEST_F(Repair, SaysSoInWords) {
  const ProgramResult result = run_program({"check", file("cone.json", nearly_cone), "--repair", path("out.json")});
  EXPECT_THAT(result.out, HasSubstr("not developable"));
  EXPECT_THAT(result.out, HasSubstr("out.json: cone, vertex ("));
  EXPECT_THAT(result.out, HasSubstr("control points move by at most"));
}

TEST_F(Repair, StandardOutputTakesTheSurfaceAlone) {
  const ProgramResult result = run_program({"check", file("cone.json", nearly_cone), "--repair", "-"});
  EXPECT_EQ(result.exit, 1);
  EXPECT_EQ(json::parse(result.out)["type"], "ruled");
  EXPECT_EQ(run_program({"check", path("cone.json"), "--repair", "-", "--json", "-"}).exit, 2);
}

TEST_F(Repair, ADevelopableSurfaceStaysAsItIs) {
  const ProgramResult result =
      run_program({"check", file("flat.json", flat), "--repair", path("out.json"), "--json", "-"});
  EXPECT_EQ(result.exit, 0);
  const json repair = json::parse(result.out)["surfaces"][0]["repair"];
  EXPECT_EQ(repair["family"], "unchanged");
  EXPECT_EQ(repair["max_distance"], 0);
  EXPECT_EQ(repair["ulps"], 0);
  const json surface = json::parse(slurp(path("out.json")));
  EXPECT_EQ(surface["d"]["points"], json::parse(R"([["0","1","0"],["1","1","0"]])"));
}

TEST_F(Repair, NeedsOneSurface) {
  const ProgramResult two =
      run_program({"check", file("cone.json", nearly_cone), file("flat.json", flat), "--repair", path("out.json")});
  EXPECT_EQ(two.exit, 2);
  EXPECT_THAT(two.err, HasSubstr("expected one ruled surface, found 2"));
  EXPECT_EQ(run_program({"check", file("broken.json", "{"), "--repair", path("out.json")}).exit, 2);
  EXPECT_FALSE(std::filesystem::exists(path("out.json")));
  EXPECT_EQ(run_program({"check", path("cone.json"), "--repair", path("no/such/folder")}).exit, 2);
}

}  // namespace
}  // namespace torse::testing
