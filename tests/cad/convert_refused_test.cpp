// Faces that torse convert cannot take.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cad/step_text.hpp"
#include "support/program.hpp"

namespace torse::testing {
namespace {

using ::testing::HasSubstr;

/// One sphere, one chosen beside a plane, and two.
TEST(ConvertRefused, FacesThatAreNotRuledAreNamed) {
  const Scratch scratch;
  const std::string out = (scratch / "out.igs").string();
  const auto error = [&](bool plate, int spheres, const std::vector<std::string>& options) {
    StepText step("m");
    std::vector<std::string> items;
    if (plate) {
      items.push_back(step.spline("plate", 1, 1, {{"0.,0.,0.", "0.,4.,0."}, {"3.,0.,0.", "3.,4.,0."}},
                                  "(2,2),(2,2),(0.,1.),(0.,1.)"));
    }
    for (int i = 0; i < spheres; ++i) {
      items.push_back(step.add("SPHERICAL_SURFACE('ball'," + step.frame("0.,0.,0.", "0.,0.,1.", "1.,0.,0.") + ",1.)"));
    }
    spill(scratch / "part.step", step.file(items, false));
    std::vector<std::string> words{"convert", (scratch / "part.step").string(), "-o", out};
    words.insert(words.end(), options.begin(), options.end());
    const ProgramResult result = run_program(words);
    EXPECT_EQ(result.exit, 2);
    EXPECT_FALSE(std::filesystem::exists(out));
    return result.err;
  };
  EXPECT_THAT(error(false, 1, {}), HasSubstr("part.step: is not ruled: sphere"));
  EXPECT_THAT(error(true, 1, {"--face", "ball"}), HasSubstr("part.step: is not ruled: sphere"));
  EXPECT_THAT(error(false, 2, {}), HasSubstr("part.step: none of its 2 faces is ruled"));
}

}  // namespace
}  // namespace torse::testing
