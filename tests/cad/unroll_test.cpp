// torse unroll of STEP files: one face, in the unit of the file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cad/step_text.hpp"
#include "support/program.hpp"

namespace torse::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

class UnrollCad : public ::testing::Test {
 protected:
  /// A rectangle of 3 by 4, and if wanted a sphere, or another rectangle.
  std::string file(bool ball, bool second) const {
    StepText step("m");
    const auto flat = [&](const std::string& name) {
      return step.spline(name, 1, 1, {{"0.,0.,0.", "0.,4.,0."}, {"3.,0.,0.", "3.,4.,0."}},
                         "(2,2),(2,2),(0.,1.),(0.,1.)");
    };
    std::vector<std::string> items{flat("plate")};
    if (second) items.push_back(flat("other"));
    if (ball)
      items.push_back(step.add("SPHERICAL_SURFACE('ball'," + step.frame("0.,0.,0.", "0.,0.,1.", "1.,0.,0.") + ",1.)"));
    spill(scratch_ / "part.step", step.file(items, false));
    return (scratch_ / "part.step").string();
  }
  void expect_refused(const std::vector<std::string>& words, const std::string& message) const {
    std::vector<std::string> line{"unroll"};
    line.insert(line.end(), words.begin(), words.end());
    line.insert(line.end(), {"-o", output()});
    const ProgramResult result = run_program(line);
    EXPECT_EQ(result.exit, 2);
    EXPECT_THAT(result.err, HasSubstr(message));
    EXPECT_FALSE(std::filesystem::exists(output()));
  }
  std::string output() const { return (scratch_ / "plate.json").string(); }

 private:
  Scratch scratch_;
};

TEST_F(UnrollCad, TheUnitIsTheFilesOwn) {
  const ProgramResult result = run_program({"unroll", file(true, false), "-o", "-"});
  ASSERT_EQ(result.exit, 0) << result.err;
  const json plate = json::parse(result.out);
  EXPECT_EQ(plate["unit"], "m");
  EXPECT_EQ(plate["name"], "plate");
  EXPECT_NEAR(plate["width"].get<double>(), 3, 1e-6);
  EXPECT_NEAR(plate["height"].get<double>(), 4, 1e-6);
  expect_refused({file(false, false), "--unit", "cm"}, "--unit: the file states its own, m");
}

TEST_F(UnrollCad, OneRuledFaceIsChosen) {
  expect_refused({file(false, true)}, "expected one ruled face, found 2: choose one by --face");
  expect_refused({file(true, false), "--face", "ball"}, "not ruled: sphere");
  EXPECT_EQ(run_program({"unroll", file(true, true), "--face", "other", "-o", output()}).exit, 0);
}

TEST_F(UnrollCad, OneFileIsTaken) {
  const std::string path = file(false, false);
  expect_refused({path, path}, "expected one FILE, found 2");
}

}  // namespace
}  // namespace torse::testing
