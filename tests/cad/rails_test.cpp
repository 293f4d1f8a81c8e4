// The rails of torse fit from the curves of STEP and IGES files: number for number, by name, number and order.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cad/iges_text.hpp"
#include "cad/step_text.hpp"
#include "support/program.hpp"
#include "torse/algebra/determinant.hpp"
#include "torse/cli/rails.hpp"
#include "torse/io/document.hpp"
#include "torse/quasi/mapping.hpp"

namespace torse::testing {
namespace {

using cli::InputRails;
using nlohmann::json;
using ::testing::HasSubstr;
using Q = Rational;
using Point = Vec<Q, 3>;

Q exact(double x) { return Q::from_double(x); }

class CadRails : public ::testing::Test {
 public:
  std::string file(const std::string& name, const std::string& text) const {
    spill(scratch / name, text);
    return (scratch / name).string();
  }
  Scratch scratch;
};

/// B_SPLINE_CURVE_WITH_KNOTS; `knots` is "(multiplicities),(knots)".
std::string spline(StepText& step, const std::string& name, int degree, const std::vector<std::string>& points,
                   const std::string& knots) {
  const std::string row = step.net({points});  // a list of one row
  return step.add("B_SPLINE_CURVE_WITH_KNOTS('" + name + "'," + std::to_string(degree) + "," +
                  row.substr(1, row.size() - 2) + ",.UNSPECIFIED.,.F.,.F.," + knots + ",.UNSPECIFIED.)");
}

std::string chine(StepText& step) {
  return spline(step, "chine", 3, {"0.,0.,0.", "1.,0.4,0.2", "2.,-0.2,0.5", "3.,0.3,0.1", "4.,0.,0."},
                "(4,1,4),(0.,0.4,1.)");
}

std::string sheer(StepText& step) {
  return spline(step, "sheer", 2, {"0.1,1.5,0.1", "2.,1.9,0.6", "4.1,1.4,0.4"}, "(3,3),(-1.,2.)");
}

/// An arc of 60 degrees about (2, 9, 0) with radius 8.
std::string arc(StepText& step) {
  const std::string circle = step.add("CIRCLE(''," + step.frame("2.,9.,0.", "0.,0.,1.", "1.,0.,0.") + ",8.)");
  return step.add("TRIMMED_CURVE('keel'," + circle +
                  ",(PARAMETER_VALUE(4.1887902047863905)),(PARAMETER_VALUE(5.2359877559829888)),.T.,.PARAMETER.)");
}

Point at(const CurveFile<Q>& curve, const Q& t) {
  const std::vector<Vec<Q, 4>> rows = homogeneous(curve.net);
  return dehomogenize<Q, 4>({curve_point<Q, Vec<Q, 4>>(curve.knots, rows, piece_at(curve.knots, t), t)}).points.front();
}

TEST_F(CadRails, StepSplinesNumberForNumber) {
  StepText step("m");
  const std::string c = chine(step);
  const std::string d = sheer(step);
  const InputRails input = cli::read_input_rails({.file = file("rails.step", step.file({c, d}, false))});
  EXPECT_EQ(input.unit.name, "m");
  EXPECT_EQ(input.tolerance, 1e-6);
  const CurveFile<Q>& first = input.rails.c;
  EXPECT_EQ(first.knots.degree(), 3);
  EXPECT_EQ(first.knots.list(), (std::vector<Q>{Q(0), Q(0), Q(0), exact(0.4), Q(1), Q(1), Q(1)}));
  EXPECT_EQ(first.net.points[1], Point(Q(1), exact(0.4), exact(0.2)));
  EXPECT_EQ(first.net.weights, std::vector<Q>(5, Q(1)));
  const CurveFile<Q>& second = input.rails.d;
  EXPECT_EQ(second.knots.list(), (std::vector<Q>{Q(-1), Q(-1), Q(2), Q(2)}));
  EXPECT_EQ(second.net.points.back(), Point(exact(4.1), exact(1.4), exact(0.4)));
}

TEST_F(CadRails, AreChosenByNameAndNumber) {
  StepText step;
  const std::vector<std::string> curves{chine(step), arc(step), sheer(step)};
  const std::string path = file("rails.step", step.file(curves, false));
  try {
    cli::read_input_rails({.file = path});
    FAIL() << "three curves are two";
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("expected two curves that bound no face, found 3 curves: 1 \"chine\", 2 "
                                        "\"keel\", 3 \"sheer\"; choose them by --c and --d"));
  }
  const InputRails named = cli::read_input_rails({.file = path, .c = "sheer", .d = "chine"});
  EXPECT_EQ(named.rails.c.knots.degree(), 2);
  EXPECT_EQ(named.rails.d.knots.degree(), 3);
  const InputRails numbered = cli::read_input_rails({.file = path, .c = "1", .d = "3", .reverse = true});
  EXPECT_EQ(numbered.rails.c.knots.degree(), 3);
  EXPECT_EQ(numbered.rails.d.net.points.front(), Point(exact(4.1), exact(1.4), exact(0.4)));
  try {
    cli::read_input_rails({.file = path, .c = "1", .d = "deck"});
    FAIL() << "there is no such curve";
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("expected a curve \"deck\", found 3 curves: 1 \"chine\""));
  }
}

TEST_F(CadRails, ANameCountsBeforeANumber) {
  StepText step;
  const std::string knots = "(2,2),(0.,1.)";
  const std::string first = spline(step, "2", 1, {"0.,0.,0.", "1.,0.,0."}, knots);
  const std::string second = spline(step, "1", 1, {"0.,1.,0.", "1.,1.,0."}, knots);
  const InputRails input =
      cli::read_input_rails({.file = file("rails.step", step.file({first, second}, false)), .c = "2", .d = "1"});
  EXPECT_EQ(input.rails.c.net.points[0], Point(Q(0), Q(0), Q(0)));
  EXPECT_EQ(input.rails.d.net.points[0], Point(Q(0), Q(1), Q(0)));
}

TEST_F(CadRails, NamedCAndDThoughThereAreOthers) {
  StepText step;
  const auto line = [&](const std::string& name, const std::string& x) {
    return spline(step, name, 1, {x + ",0.,0.", x + ",1.,0."}, "(2,2),(0.,1.)");
  };
  const std::vector<std::string> curves{line("d", "1."), line("twice", "2."), line("c", "3."), line("twice", "4.")};
  const std::string path = file("rails.step", step.file(curves, false));
  const InputRails named = cli::read_input_rails({.file = path});
  EXPECT_EQ(named.rails.c.net.points.front()[0], Q(3));
  EXPECT_EQ(named.rails.d.net.points.front()[0], Q(1));
  EXPECT_FALSE(cli::opposite(named.rails));
  EXPECT_TRUE(cli::opposite(cli::read_input_rails({.file = path, .reverse = true}).rails));
  const auto refused = [&](const cli::RailsInput& input) {
    try {
      cli::read_input_rails(input);
    } catch (const std::exception& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(refused({.file = path, .c = "twice", .d = "d"}),
              HasSubstr("2 curves are called \"twice\": choose by number"));
  EXPECT_EQ(refused({.file = path, .c = "c"}), "--c, --d: expected both or none");
  EXPECT_EQ(refused({.file = path, .d = "d"}), "--c, --d: expected both or none");
}

TEST_F(CadRails, AnErrorListsTwelveCurves) {
  for (const int count : {12, 13}) {
    StepText step;
    std::vector<std::string> curves;
    for (int i = 0; i < count; ++i)
      curves.push_back(spline(step, "", 1, {std::to_string(i) + ".,0.,0.", "0.,1.,0."}, "(2,2),(0.,1.)"));
    try {
      cli::read_input_rails({.file = file("rails.step", step.file(curves, false))});
      FAIL() << count;
    } catch (const FileError& error) {
      EXPECT_THAT(error.what(), HasSubstr("found " + std::to_string(count) + " curves: 1 \"curve 1\", 2 "));
      EXPECT_THAT(error.what(), HasSubstr(count == 12 ? "12 \"curve 12\"; choose" : "12 \"curve 12\", ...; choose"));
    }
  }
}

TEST_F(CadRails, ArcsBecomeRationalCurvesOnTheCircle) {
  StepText step;
  const std::string c = arc(step);
  const std::string d = chine(step);
  const InputRails input = cli::read_input_rails({.file = file("rails.step", step.file({c, d}, false))});
  const KnotList<Q>& u = input.rails.c.knots;
  for (int i = 0; i <= 20; ++i) {
    const Point x = at(input.rails.c, u.domain_begin() + ratio<Q>(i, 20) * (u.domain_end() - u.domain_begin()));
    const Point from_centre = difference(x, Point(Q(2), Q(9), Q(0)));
    EXPECT_NEAR(dot(from_centre, from_centre).to_double(), 64, 1e-12);
  }
  EXPECT_NEAR(input.rails.c.net.points.front()[0].to_double(), -2, 1e-14);
  EXPECT_NEAR(input.rails.c.net.points.back()[0].to_double(), 6, 1e-14);
}

/// (8t, 8t^2, 0) on [0, 1], of which [1/4, 3/4] is used: from (2, 1/2, 0) to (6, 9/2, 0).
TEST_F(CadRails, SplinesEndWhereTheirTrimEnds) {
  StepText step;
  const std::string whole = spline(step, "", 2, {"0.,0.,0.", "4.,0.,0.", "8.,8.,0."}, "(3,3),(0.,1.)");
  const std::string part =
      step.add("TRIMMED_CURVE('part'," + whole + ",(PARAMETER_VALUE(0.25)),(PARAMETER_VALUE(0.75)),.T.,.PARAMETER.)");
  const std::string other = chine(step);
  const InputRails input = cli::read_input_rails({.file = file("rails.step", step.file({part, other}, false))});
  const CurveFile<Q>& c = input.rails.c;
  EXPECT_EQ(at(c, c.knots.domain_begin()), Point(Q(2), exact(0.5), Q(0)));
  EXPECT_EQ(at(c, c.knots.domain_end()), Point(Q(6), exact(4.5), Q(0)));
}

TEST_F(CadRails, IgesCurvesWithTheirMatrix) {
  IgesText iges(6);
  const int moved = iges.add(124, "1.,0.,0.,0.,0.,1.,0.,0.,0.,0.,1.,2.5");
  iges.add(126, "2,2,0,0,0,0,0.,0.,0.,1.,1.,1.,1.,0.5,1.,0.,0.,0.,1.,0.75,0.,2.,0.,0.25,0.,1.,0.,0.,0.",
           {.label = "d", .matrix = moved});
  iges.add(110, "0.,0.,0.,2.,0.1,0.", {.label = "c"});
  const InputRails input = cli::read_input_rails({.file = file("rails.igs", iges.file())});
  EXPECT_EQ(input.unit.name, "m");
  EXPECT_EQ(input.rails.c.knots.degree(), 1);
  EXPECT_EQ(input.rails.c.net.points.back(), Point(Q(2), exact(0.1), Q(0)));
  EXPECT_EQ(input.rails.d.knots.degree(), 2);
  EXPECT_EQ(input.rails.d.net.points[1], Point(Q(1), exact(0.75), exact(2.5)));
  EXPECT_EQ(input.rails.d.net.weights, (std::vector<Q>{Q(1), ratio<Q>(1, 2), Q(1)}));
}

/// A line and a spline make one rail, whose parts follow each other.
TEST_F(CadRails, CompositeCurvesAreJoined) {
  IgesText iges;
  const int first = iges.add(110, "0.,0.,0.,1.,0.,0.", {.dependent = true});
  const int second = iges.bezier(2, "1.,1.,1.", "1.,0.,0.,1.5,0.,0.,2.,1.,0.");
  iges.add(102, "2," + std::to_string(first) + "," + std::to_string(second), {.label = "c"});
  iges.add(110, "0.,2.,1.,2.,3.,1.", {.label = "d"});
  const InputRails input = cli::read_input_rails({.file = file("rails.igs", iges.file())});
  const KnotList<Q>& u = input.rails.c.knots;
  EXPECT_EQ(u.degree(), 2);
  EXPECT_EQ(at(input.rails.c, u.domain_begin()), Point(Q(0), Q(0), Q(0)));
  EXPECT_EQ(at(input.rails.c, u.domain_end()), Point(Q(2), Q(1), Q(0)));
  ASSERT_EQ(u.proper_pieces().size(), 2U);
  EXPECT_EQ(at(input.rails.c, u.piece_end(u.proper_pieces().front())), Point(Q(1), Q(0), Q(0)));
}

/// A wire whose second edge begins where the first one does not end.
TEST_F(CadRails, ACurveWithAGapIsNamed) {
  StepText step("m");
  const auto line = [&](const std::string& from, const std::string& to) {
    return step.add("POLYLINE('',(" + step.point(from) + "," + step.point(to) + "))");
  };
  const auto segment = [&](const std::string& curve) {
    return step.add("COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.," + curve + ")");
  };
  const std::string first = segment(line("0.,0.,0.", "1.,0.,0."));
  const std::string second = segment(line("1.5,0.,0.", "2.,0.,0."));
  const std::string gap = step.add("COMPOSITE_CURVE('gap',(" + first + "," + second + "),.F.)");
  const std::string d = sheer(step);
  const std::string rails = file("rails.step", step.file({gap, d}, false));
  const ProgramResult result = run_program({"fit", rails, "--c", "gap", "--d", "sheer", "-o", "-"});
  EXPECT_EQ(result.exit, 2);
  EXPECT_THAT(result.err, HasSubstr("cannot be a rail: its parts do not follow each other"));
}

/// The quarter of a circle whose weights are tiny, which OpenCASCADE takes for ones, and a line.
TEST_F(CadRails, TinyWeightsWithinACompositeCurve) {
  for (const char* weights : {"1.,1.,2.", "1.D-12,1.D-12,2.D-12"}) {
    IgesText iges;
    const int quarter = iges.bezier(2, weights, "1.,0.,0.,1.,1.,0.,0.,1.,0.");
    const int line = iges.line("0.,1.,0.", "-1.,1.,0.");
    iges.add(102, "2," + std::to_string(quarter) + "," + std::to_string(line), {.label = "c"});
    iges.add(110, "1.,0.,1.,-1.,1.,1.", {.label = "d"});
    const InputRails input = cli::read_input_rails({.file = file("rails.igs", iges.file())});
    const KnotList<Q>& u = input.rails.c.knots;
    const int piece = u.proper_pieces().front();
    for (const Q& share : {ratio<Q>(1, 3), ratio<Q>(1, 2), ratio<Q>(3, 4)}) {
      const Q t = u.piece_begin(piece) + share * (u.piece_end(piece) - u.piece_begin(piece));
      const Point x = at(input.rails.c, t);
      EXPECT_NEAR((x[0] * x[0] + x[1] * x[1]).to_double(), 1, 1e-14) << weights << " " << x[0].to_double();
    }
  }
}

TEST_F(CadRails, WithoutUnitsLengthsAreMillimetres) {
  StepText step("");
  const std::string c = chine(step);
  const std::string d = sheer(step);
  const InputRails input = cli::read_input_rails({.file = file("rails.step", step.file({c, d}, false))});
  EXPECT_EQ(input.unit.name, "mm");
  EXPECT_EQ(input.rails.c.net.points[1], Point(Q(1), exact(0.4), exact(0.2)));
}

TEST_F(CadRails, AreFittedInTheirUnit) {
  StepText step("m");
  const std::string c = chine(step);
  const std::string d = sheer(step);
  const std::string rails = file("rails.step", step.file({c, d}, false));
  const std::string out = (scratch / "out.step").string();
  const std::string mesh = (scratch / "out.obj").string();
  const ProgramResult result = run_program({"fit", rails, "-o", out, "-o", mesh, "--coefficients", "8"});
  EXPECT_EQ(result.exit, 0) << result.err;
  EXPECT_THAT(slurp(out), HasSubstr("SI_UNIT($,.METRE.)"));
  const ProgramResult check = run_program({"check", out, "--json", "-"});
  const json surface = json::parse(check.out).at("surfaces").at(0);
  EXPECT_EQ(surface.at("unit"), "m");
  EXPECT_EQ(surface.at("ruled"), true);
}

/// In units of 30 mm, which have no name: coordinates and the tolerance of 1e-6 are written in millimetres.
TEST_F(CadRails, AreFittedInMillimetresWhereTheirUnitHasNoName) {
  StepText step("inch");
  const std::string c = chine(step);
  const std::string d = sheer(step);
  std::string text = step.file({c, d}, false);
  text.replace(text.find("25.4"), 4, "30.");
  const std::string out = (scratch / "out.step").string();
  const ProgramResult result = run_program({"fit", file("rails.step", text), "-o", out, "--coefficients", "8"});
  EXPECT_EQ(result.exit, 0) << result.err;
  const ProgramResult check = run_program({"check", out, "--json", "-"});
  const json surface = json::parse(check.out).at("surfaces").at(0);
  EXPECT_EQ(surface.at("unit"), "mm");
  EXPECT_NEAR(surface.at("tolerance").get<double>(), 3e-5, 1e-12);
}

TEST_F(CadRails, WhatHasNoCurvesIsRefused) {
  StepText step;
  const std::string plate =
      step.spline("plate", 1, 1, {{"0.,0.,0.", "0.,1.,0."}, {"1.,0.,0.", "1.,1.,0."}}, "(2,2),(2,2),(0.,1.),(0.,1.)");
  const std::string path = file("plate.step", step.file({plate}, false));
  const ProgramResult none = run_program({"fit", path, "-o", (scratch / "out.json").string()});
  EXPECT_EQ(none.exit, 2);
  EXPECT_THAT(none.err, HasSubstr("expected two curves that bound no face, found none"));
  const std::string text = R"({"torse": 1, "type": "rails", "c": {"degree": 1, "points": [[0,0,0],[1,0,0]]},
                               "d": {"degree": 1, "points": [[0,1,0],[1,1,0]]}})";
  const ProgramResult mixed =
      run_program({"fit", file("rails.json", text), "--c", "1", "--d", "2", "-o", (scratch / "out.json").string()});
  EXPECT_EQ(mixed.exit, 2);
  EXPECT_THAT(mixed.err, HasSubstr("--c, --d: choose curves of STEP and IGES files"));
  EXPECT_FALSE(std::filesystem::exists(scratch / "out.json"));
}

}  // namespace
}  // namespace torse::testing
