// torse fit between closed rails that begin at places which do not belong together.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/program.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/io/spline_file.hpp"
#include "torse/spline/closed.hpp"

namespace torse::testing {
namespace {

using nlohmann::json;
using Q = Rational;

constexpr const char* brim = TORSE_SOURCE_PATH "/examples/hat-brim.json";

/// The rails of a hat's brim, the rim from another point on.
std::string turned_brim(const Q& begin) {
  RailsFile<Q> rails = read_rails<Q>(Document(brim, slurp(brim)));
  const Spline<Q, Vec<Q, 4>> moved = rotated(Spline<Q, Vec<Q, 4>>(rails.d.knots, homogeneous(rails.d.net)), begin);
  rails.d = {moved.knots, dehomogenize<Q, 4>(moved.control)};
  return write_rails(rails);
}

/// An ellipse at height z, its first arc longer than half of it, by a negative weight.
CurveFile<Q> ellipse(int z) {
  CurveFile<Q> curve{KnotList<Q>(2, {Q(0), Q(0), Q(1), Q(1), Q(2), Q(2)}), {}};
  for (const auto& [x, y] : {std::pair{1, 0}, {0, 3}, {-1, 0}, {0, 3}, {1, 0}}) {
    curve.net.points.push_back({Q(x), Q(y), Q(z)});
  }
  const Q third = ratio<Q>(1, 3);
  curve.net.weights = {Q(1), -third, Q(1), third, Q(1)};
  return curve;
}

json report_on(const std::string& rails, const Scratch& scratch) {
  const std::string report = (scratch / "report.json").string();
  const ProgramResult result =
      run_program({"fit", rails, "--coefficients", "12", "-o", (scratch / "out.json").string(), "--json", report});
  EXPECT_EQ(result.exit, 0) << result.err;
  return json::parse(slurp(report)).at("surfaces").at(0);
}

TEST(FitSeam, IsFoundWhereTheRailsOfAFileBeginApart) {
  const Scratch scratch;
  const json right = report_on(brim, scratch);
  EXPECT_FALSE(right.contains("seam")) << "the brim's own seam is the best";
  const std::string file = (scratch / "turned.json").string();
  spill(file, turned_brim(ratio<Q>(3, 8)));
  const json turned = report_on(file, scratch);
  EXPECT_LT(turned.at("after").at("mean_deg"), 2 * right.at("after").at("mean_deg").get<double>());
  // From 3/8 on, the old begin is the parameter 1.
  EXPECT_NEAR(Q::from_text(turned.at("seam").get<std::string>()).to_double(), 1, 0.03);
  const RuledFile<Q> surface = read_ruled<Q>(Document("out.json", slurp(scratch / "out.json")));
  EXPECT_EQ(surface.c.points.front(), surface.c.points.back());
  EXPECT_EQ(surface.d.points.front(), surface.d.points.back());
}

/// From 1/4 on, and up to 3/4, the first arc has a control point with weight (1 - t) - t/3 or t - (1 - t)/3: at
/// infinity.
TEST(FitSeam, PlacesWhereAControlPointLiesAtInfinityAreLeftOut) {
  const Scratch scratch;
  RailsFile<Q> rails{ellipse(5), ellipse(0)};
  const std::string file = (scratch / "ellipses.json").string();
  spill(file, write_rails(rails));
  EXPECT_FALSE(report_on(file, scratch).contains("seam"));
  const Spline<Q, Vec<Q, 4>> moved =
      rotated(Spline<Q, Vec<Q, 4>>(rails.d.knots, homogeneous(rails.d.net)), ratio<Q>(1, 8));
  rails.d = {moved.knots, dehomogenize<Q, 4>(moved.control)};
  spill(file, write_rails(rails));
  EXPECT_EQ(report_on(file, scratch).at("seam"), "2") << "the old begin, after all 15 even places from 1/8 on";
}

}  // namespace
}  // namespace torse::testing
