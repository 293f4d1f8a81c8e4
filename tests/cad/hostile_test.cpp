// Files that are no use: one error with the file's name, exit code 2.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "cad/iges_text.hpp"
#include "cad/step_text.hpp"
#include "support/program.hpp"

namespace torse::testing {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;

class HostileCad : public ::testing::Test {
 public:
  ProgramResult check(const std::string& name, const std::string& text) const {
    spill(scratch / name, text);
    return run_program({"check", (scratch / name).string()});
  }
  void refused(const std::string& name, const std::string& text, const std::string& reason) const {
    const ProgramResult result = check(name, text);
    EXPECT_EQ(result.exit, 2) << text.substr(0, 200);
    EXPECT_THAT(result.err, HasSubstr(name + ": "));
    EXPECT_THAT(result.err, HasSubstr(reason));
    EXPECT_EQ(result.out, "");
  }
  Scratch scratch;
};

std::string patch(const std::string& corner) {
  StepText step;
  return step.file(
      {step.spline("p", 1, 1, {{"0.,0.,0.", "0.,1.,0."}, {"1.,0.,0.", corner}}, "(2,2),(2,2),(0.,1.),(0.,1.)")}, false);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  text.replace(text.find(from), from.size(), to);
  return text;
}

TEST_F(HostileCad, NotWhatTheNamePromises) {
  refused("a.step", "", "begins with ISO-10303-21");
  refused("a.stp", "solid cube", "begins with ISO-10303-21");
  refused("a.igs", "hello", "column 73");
  refused("a.step", "ISO-10303-21;", "STEP");
  refused("a.step", "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n", "STEP");
  refused("a.step",
          "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
          "FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n",
          "expected an entity, found none\n");
  IgesText iges;
  iges.line("0.,0.,0.", "1.,0.,0.");
  refused("a.igs", iges.file(), "found none");
  std::string compressed = iges.file();
  compressed[72] = 'C';
  refused("a.igs", compressed, "compressed");
  compressed[72] = 'B';
  refused("a.igs", compressed, "binary IGES");
  for (const char* name : {"a.STEP", "a.Stp", "a.P21"}) refused(name, "solid cube", "begins with ISO-10303-21");
  for (const char* name : {"a.IGS", "a.Iges"}) refused(name, "hello", "column 73");
  EXPECT_EQ(check("a.txt", "\xEF\xBB\xBF \r\n" + patch("1.,1.,0.")).exit, 0);
  IgesText plane;
  plane.ruled(plane.line("0.,0.,0.", "1.,0.,0."), plane.line("0.,1.,0.", "1.,1.,0."), 0, 1, {});
  EXPECT_EQ(check("a.txt", "\xEF\xBB\xBF" + plane.file()).exit, 0);
  IgesText ball;
  ball.add(196, std::to_string(ball.add(116, "1.,2.,3.,0", {.dependent = true})) + ",2.,0,0");
  EXPECT_EQ(check("a.igs", ball.file()).exit, 3) << "there is nothing to judge";
}

TEST_F(HostileCad, NumbersThatAreNone) {
  EXPECT_EQ(check("a.step", patch("1.,1.,0.")).exit, 0);
  refused("a.step", patch("1.,1.,1.E999"), "NaN or infinite");
  for (const char* corner : {"1.,1.,NaN", "1.,1.,'x'", "1.,1.,$", "1.,1.,#1"}) refused("a.step", patch(corner), "#");
  refused("a.step", patch("1.,1."), "three coordinates");
}

TEST_F(HostileCad, ListsThatDoNotFit) {
  const std::string good = patch("1.,1.,0.");
  refused("a.step", replaced(good, "(2,2),(2,2),", "(2,2),(2,2000000000),"), "multiplicities");
  for (const char* middle : {"0", "-1"}) {  // a knot that is none
    refused("a.step", replaced(good, "(2,2),(2,2),(0.,1.)", "(2," + std::string(middle) + ",2),(2,2),(0.,0.5,1.)"),
            "multiplicities of knots that are positive");
  }
  refused("a.step", replaced(good, "(2,2),(2,2),", "(2,2),(2,3),"), "knots");
  refused("a.step", replaced(good, "(0.,1.),(0.,1.)", "(0.,1.),(1.,0.)"), "knots");
  refused("a.step", replaced(good, "(0.,1.),(0.,1.)", "(0.,1.),(1.,1.)"), "knots");
  refused("a.step", replaced(good, "SPLINE_SURFACE_WITH_KNOTS('p',1,1", "SPLINE_SURFACE_WITH_KNOTS('p',1,-1"),
          "degree");
  EXPECT_EQ(
      check("a.step", replaced(good, "SPLINE_SURFACE_WITH_KNOTS('p',1,1", "SPLINE_SURFACE_WITH_KNOTS('p',1,2")).exit,
      2);
}

/// Neither for the rows that become rails nor from row to row.
TEST_F(HostileCad, KnotsThatDecrease) {
  for (const char* knots : {"(2,2),(2,1,2),(0.,1.),(0.,2.,1.)", "(2,2),(2,1,2),(0.,1.),(1.,0.,2.)"}) {
    StepText step;
    const std::string surface =
        step.spline("p", 1, 1, {{"0.,0.,0.", "0.,1.,0.", "0.,2.,0."}, {"1.,0.,0.", "1.,1.,0.", "1.,2.,0."}}, knots);
    refused("a.step", step.file({surface}, false), "knots");
  }
}

TEST_F(HostileCad, ReferencesThatLeadNowhereOrInCircles) {
  StepText step;
  const std::string frame = step.frame("0.,0.,0.", "0.,0.,1.", "1.,0.,0.");
  const std::string plane = step.add("PLANE(''," + frame + ")");
  const std::string trimmed = step.add("RECTANGULAR_TRIMMED_SURFACE(''," + plane + ",0.,1.,0.,1.,.T.,.T.)");
  const std::string good = step.file({trimmed}, false);
  EXPECT_EQ(check("a.step", good).exit, 0);
  refused("a.step", replaced(good, "SURFACE(''," + plane + ",", "SURFACE(''," + trimmed + ","), "");
  refused("a.step", replaced(good, "SURFACE(''," + plane + ",", "SURFACE('',#99999,"), "");
  refused("a.step", replaced(good, "PLANE(''," + frame, "PLANE(''," + plane), "");
}

/// Elevation and refinement of such rails would take hours.
TEST_F(HostileCad, RailsThatAreFarApartInDegree) {
  std::string weights;
  std::string points;
  for (int i = 0; i <= 90; ++i) {
    weights += (i == 0 ? "" : ",") + std::string("1.");
    points += (i == 0 ? "" : ",") + std::to_string(i) + ".,0.,0.";
  }
  IgesText iges;
  iges.ruled(iges.bezier(90, weights, points), iges.line("0.,1.,0.", "90.,1.,0."), 0, 1, {.form = 1});
  refused("a.igs", iges.file(), "2^23 steps at most, found some of degrees 1 and 90 with 93 control points");
}

TEST_F(HostileCad, CutAnywhereItIsReadOrRefused) {
  IgesText iges;
  iges.ruled(iges.line("0.,0.,0.", "1.,0.,0."), iges.line("0.,1.,0.", "1.,1.,0."), 0, 1, {.form = 1});
  const std::string files[] = {patch("1.,1.,0."), iges.file()};
  std::mt19937 random(1);
  for (int i = 0; i < 16; ++i) {
    std::string text = files[i % 2];
    const std::string name = i % 2 == 0 ? "a.step" : "a.igs";
    if (i % 4 < 2) text.resize(random() % text.size());
    for (int k = 0; i % 4 >= 2 && k < 5; ++k) text[random() % text.size()] = static_cast<char>(random() % 256);
    const ProgramResult result = check(name, text);
    EXPECT_THAT(result.exit, AnyOf(0, 1, 2, 3)) << i;
    if (result.exit == 2) {
      EXPECT_THAT(result.err, HasSubstr("torse: error: ")) << i;
    }
  }
}

TEST_F(HostileCad, WithoutThePluginTheProgramSaysHowToGetIt) {
  const std::filesystem::path lonely = scratch / "torse";
  std::filesystem::copy_file(TORSE_PROGRAM_PATH, lonely);
  spill(scratch / "a.step", patch("1.,1.,0."));
  const std::string errors = (scratch / "err").string();
  const std::string line = "'" + lonely.string() + "' check '" + (scratch / "a.step").string() + "' 2>'" + errors + "'";
  const int status = std::system(line.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 2);
  EXPECT_THAT(slurp(errors), HasSubstr("./x cad"));
}

}  // namespace
}  // namespace torse::testing
