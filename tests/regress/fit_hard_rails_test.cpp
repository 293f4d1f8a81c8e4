// torse fit on rails that are hard in one way each, large, small or no rails at all.
#include <gmock/gmock.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "regress/fit_rails.hpp"
#include "torse/quasi/mapping.hpp"

namespace torse::testing {
namespace {

using ::testing::HasSubstr;

/// Rails that are hard in one way each, and whether they can be fitted.
const std::string smooth = R"("degree": 3, "points": [["0.2",1.5,0.1],[1,1.9,0.6],[2,1.3,-0.1],[4.1,1.4,0.4]]})";
const std::vector<std::pair<const char*, std::string>> hard{
    {"cusp", R"({"degree": 3, "points": [[0,0,0],[3,2,0],[-1,2,0],[2,0,0.3]]})"},
    {"stationary", R"({"degree": 3, "points": [[0,0,0],[0,0,0],[0,0,0],[3,1,0]]})"},
    {"straight, slow", R"({"degree": 3, "points": [[0,0,0],[0.001,0,0],[0.002,0,0],[3,0,0]]})"},
    {"same ends", R"({"degree": 3, "points": [[0.2,1.5,0.1],[1,0,0],[2,0,0],[4.1,1.4,0.4]]})"},
    {"kinks", R"({"degree": 1, "knots": [0,1,2,2.5], "points": [[0,0,0],[1,0,0.5],[2,0,0],[2,-1,0]]})"},
    {"far away", R"({"degree": 3, "points": [["1e9",0,0],["1e9",0.4,0.2],["1e9",-0.2,0.5],["1e9",0.3,0.1]]})"},
    {"beyond doubles", R"({"degree": 1, "points": [["-1e400",0,0],["1e400",1,0]]})"},
    {"weights of both signs",
     R"({"degree": 3, "points": [[0,0,0],[1,0.4,0.2],[2,-0.2,0.5],[3,0.3,0.1]], "weights": [1,-1,2,1]})"},
    {"knots nearer than doubles tell",
     R"({"degree": 2, "knots": [0,0,"1e-30",1,1], "points": [[0,0,0],[1,0.4,0.2],[2,-0.2,0.5],[3,0.3,0.1]]})"},
};

TEST_F(Fit, HardRailsGiveACertifiedSurfaceNoWorseThanTheSameParameter) {
  bool first = false;
  for (const auto& [name, curve] : hard) {
    SCOPED_TRACE(name);
    first = !first;
    const std::string other = "{" + smooth;
    const std::string rails = R"({"torse": 1, "type": "rails", "c": )" + (first ? curve : other) + R"(, "d": )" +
                              (first ? other : curve) + "}";
    const json report = this->report(rails, {"--coefficients", "8"});
    const double before = report.at("before").at("mean_deg");
    const double after = report.at("after").at("mean_deg");
    EXPECT_LE(after, before * 1.001 + 1e-9);
    EXPECT_LE(report.at("max_warp_deg").at("lo"), report.at("max_warp_deg").at("hi"));
    EXPECT_LE(report.at("max_warp_deg").at("hi"), 90);
    EXPECT_EQ(run_program({"check", file("out.json"), "--json", file("check.json")}).exit, 1);
  }
}

/// Two thirds of a circle, whose weights 1, -1/2, 1 become 1, 0, 0, 1 for degree 3, and an ellipse that is cut at a
/// knot of the other rail where its weights become 1, 0, 1/2.
TEST_F(Fit, FinitePiecesWithControlPointsAtInfinityAreCut) {
  const std::string arc = R"({"degree": 2, "points": [[0,0,0],["1/2",-1,0],[1,0,0]], "weights": [1, "-1/2", 1]})";
  const std::string oval = R"({"degree": 2, "points": [[1,0,0],[0,3,0],[-1,0,0]], "weights": [1, "-1/3", 1]})";
  const std::string bent = R"({"degree": 2, "knots": [0,0,"3/4",1,1], "points": [[0,0,3],[1,2,4],[2,2,3],[4,0,3]]})";
  for (const auto& [rail, other] : {std::pair{arc, "{" + smooth}, {"{" + smooth, arc}, {oval, bent}, {bent, oval}}) {
    const std::string rails = R"({"torse": 1, "type": "rails", "c": )" + rail + R"(, "d": )" + other + "}";
    this->report(rails, {"--method", "same"});
    const RuledFile<Q> surface = written();
    const bool first = rail == arc || rail == oval;
    EXPECT_EQ(surface.knots.proper_pieces().size(), rail == arc || other == arc ? 2U : 3U);
    const WeightedPoints<Q, 3>& net = first ? surface.c : surface.d;
    const Document document("rails", rails);
    const CurveFile<Q> given = first ? read_rails<Q>(document).c : read_rails<Q>(document).d;
    const Spline<Q, Vec<Q, 4>> old(given.knots, homogeneous(given.net));
    const Spline<Q, Vec<Q, 4>> now(surface.knots, homogeneous(net));
    for (const Q& t : {ratio<Q>(1, 7), ratio<Q>(2, 5), ratio<Q>(9, 10)}) {
      const auto at = [&](const Spline<Q, Vec<Q, 4>>& curve) {
        return dehomogenize<Q, 4>({curve_point(curve.knots, curve.points(), piece_at(curve.knots, t), t)}).points[0];
      };
      EXPECT_EQ(at(now), at(old));
    }
  }
}

/// A first piece so short that no rulings lay it flat within the tolerance: the surface is there without its plate.
TEST_F(Fit, ASurfaceWithoutAPlateIsWrittenAllTheSame) {
  const std::string rails = R"({"torse": 1, "type": "rails",
    "c": {"degree": 2, "knots": [0,0,1,"1e200","1e200"], "points": [[0,0,0],[1,2,0],[2,0,1],[3,0,0]]},
    "d": {"degree": 1, "points": [[0,-2,3],[0,-2,3]]}})";
  const ProgramResult result =
      run(rails, {"--method", "same", "--unroll", file("plate.svg"), "--json", file("report.json")});
  EXPECT_EQ(result.exit, 2);
  EXPECT_THAT(result.out,
              HasSubstr("no plate: tolerance: rulings however near do not reach it in the piece from 0 to 1\n"));
  EXPECT_EQ(written().c.points.back(), (Vec<Q, 3>(Q(3), Q(0), Q(0))));
  const json plate = json::parse(slurp(file("report.json"))).at("surfaces").at(0).at("plate");
  EXPECT_EQ(plate.at("unrolled"), false);
}

/// The warp is free of scale, so sizes of a millionth and a million give the same surface but for its size.
TEST_F(Fit, SizesDoNotMatter) {
  const auto scaled = [](const std::string& factor) {
    json rails = json::parse(plain);
    for (const char* rail : {"c", "d"}) {
      for (json& xyz : rails[rail]["points"]) {
        for (json& x : xyz) x = x.dump() + factor;
      }
    }
    return rails.dump();
  };
  const json usual = this->report(scaled(""), {"--coefficients", "10"});
  for (const char* factor : {"e-6", "e6", "e-200"}) {
    SCOPED_TRACE(factor);
    const json other = this->report(scaled(factor), {"--coefficients", "10"});
    EXPECT_EQ(other.at("mapping").at("coefficients"), usual.at("mapping").at("coefficients"));
    EXPECT_NEAR(other.at("max_warp_deg").at("hi"), usual.at("max_warp_deg").at("hi"), 1e-9);
  }
}

/// A rail of one point makes a cone, equal rails no strip at all, and rails that nearly touch are rails as others.
TEST_F(Fit, UnusualRailsAreNamed) {
  const std::string curve = R"({"degree": 3, "points": [[0,0,0],[1,0.4,0.2],[2,-0.2,0.5],[3,0.3,0.1]]})";
  const std::string near =
      R"({"degree": 3, "points": [[0,1e-6,0],[1,0.4,0.200001],[2,-0.199999,0.5],[3,0.3,0.100001]]})";
  const std::string spot = R"({"degree": 1, "points": [[1,5,2],[1,5,2]]})";
  const auto rails = [](const std::string& c, const std::string& d) {
    return R"({"torse": 1, "type": "rails", "c": )" + c + R"(, "d": )" + d + "}";
  };
  for (const bool second : {false, true}) {
    const std::string text = second ? rails(curve, spot) : rails(spot, curve);
    const json cone = this->report(text, {"--coefficients", "6"});
    EXPECT_EQ(cone.at("developable"), true);
    EXPECT_TRUE(cone.at("self_intersection").at("crosses").is_null());
    EXPECT_THAT(cone.at("notes").at(0).get<std::string>(),
                HasSubstr(second ? "second rail is one" : "first rail is one"));
    EXPECT_THAT(run_program({"check", file("out.json")}).out, HasSubstr("cone"));
  }
  const json same = this->report(rails(curve, curve), {"--coefficients", "6"});
  EXPECT_THAT(same.at("notes").at(0).get<std::string>(), HasSubstr("the same curve: there is no strip"));
  const json close = this->report(rails(curve, near), {"--coefficients", "6"});
  EXPECT_FALSE(close.contains("notes"));
  EXPECT_LE(close.at("after").at("mean_deg"), close.at("before").at("mean_deg"));
  EXPECT_LE(close.at("max_warp_deg").at("lo"), close.at("max_warp_deg").at("hi"));
}

}  // namespace
}  // namespace torse::testing
