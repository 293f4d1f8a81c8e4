// torse check --repair on a face of a STEP file, whose numbers are doubles.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cad/step_text.hpp"
#include "support/program.hpp"

namespace torse::testing {
namespace {

using nlohmann::json;

TEST(StepRepair, ANetRoundedToDoublesIsMovedByItsRounding) {
  const Scratch scratch;
  StepText step;
  // FJ07.12 with Lam = -4/3, M = -2; 13/6 is not a double.
  const std::string hull = step.spline(
      "hull", 2, 1, {{"0.,0.,0.", "0.,0.,2."}, {"3.,3.,0.", "2.,2.,3."}, {"4.,3.,0.", "2.1666666666666665,1.5,4.5"}},
      "(3,3),(2,2),(0.,1.),(0.,1.)");
  const std::string other =
      step.spline("other", 1, 1, {{"0.,0.,0.", "0.,1.,0."}, {"1.,0.,0.", "1.,1.,0."}}, "(2,2),(2,2),(0.,1.),(0.,1.)");
  const std::string part = (scratch / "part.step").string();
  const std::string out = (scratch / "out.json").string();
  spill(part, step.file({hull, other}, false));

  EXPECT_EQ(run_program({"check", part, "--repair", out}).exit, 2);
  const ProgramResult result = run_program({"check", part, "--face", "hull", "--repair", out, "--json", "-"});
  EXPECT_EQ(result.exit, 1);
  const json repair = json::parse(result.out)["surfaces"][0]["repair"];
  EXPECT_EQ(repair["class"], "tangent");
  EXPECT_LE(repair["max_distance"], 4e-16);
  EXPECT_LE(repair["ulps"], 2);
  EXPECT_EQ(run_program({"check", out}).exit, 0);
}

}  // namespace
}  // namespace torse::testing
