// torse fit --ends extended to STEP: the face ends where the rails of the file do.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>

#include "support/program.hpp"

namespace torse::testing {
namespace {

using nlohmann::json;
using Place = std::vector<double>;

/// The points of all VERTEX_POINTs of a STEP file.
std::vector<Place> vertices_of(std::string step) {
  std::erase(step, '\n');
  std::map<std::string, Place> points;
  const std::regex point("#(\\d+) *= *CARTESIAN_POINT\\('[^']*',\\(([^,]+),([^,]+),([^)]+)\\)\\)");
  for (std::sregex_iterator at(step.begin(), step.end(), point), end; at != end; ++at) {
    points[at->str(1)] = {std::stod(at->str(2)), std::stod(at->str(3)), std::stod(at->str(4))};
  }
  std::vector<Place> vertices;
  const std::regex vertex("VERTEX_POINT\\('[^']*',#(\\d+)\\)");
  for (std::sregex_iterator at(step.begin(), step.end(), vertex), end; at != end; ++at) {
    vertices.push_back(points.at(at->str(1)));
  }
  return vertices;
}

double distance(const Place& x, const Place& y) { return std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]); }

TEST(Trim, AFaceBetweenExtendedRailsHasTheOldEndsForCorners) {
  const Scratch scratch;
  const std::string rails = std::string(TORSE_SOURCE_PATH) + "/examples/hull-bottom.json";
  const std::string step = (scratch / "strip.step").string();
  const std::string report = (scratch / "report.json").string();
  const ProgramResult result = run_program({"fit", rails, "--ends", "extended", "-o", step, "--json", report});
  ASSERT_EQ(result.exit, 0) << result.err;
  const json trim = json::parse(slurp(report)).at("surfaces").at(0).at("trim");
  ASSERT_NE(trim.at("begin").at("c"), trim.at("begin").at("d")) << "nothing is cut off";
  const std::vector<Place> vertices = vertices_of(slurp(step));
  EXPECT_EQ(vertices.size(), 4U);
  const json input = json::parse(slurp(rails));
  for (const char* rail : {"c", "d"}) {
    const json& points = input.at(rail).at("points");
    for (const json& end : {points.front(), points.back()}) {
      double nearest = 1e300;
      for (const Place& vertex : vertices) nearest = std::min(nearest, distance(vertex, end.get<Place>()));
      EXPECT_LT(nearest, 1e-9) << rail << " " << end;
    }
  }
}

}  // namespace
}  // namespace torse::testing
