// torse fit --ends extended to STEP: the face ends where the rails of the file do.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>

#include "support/program.hpp"

namespace torse::testing {
namespace {

using nlohmann::json;
using Place = std::vector<double>;

/// What a STEP file's faces are bounded by.
struct Wire {
  std::vector<Place> vertices;
  std::vector<std::pair<Place, Place>> edges;
};

/// The points of all VERTEX_POINTs of a STEP file, and those that each EDGE_CURVE joins.
Wire wire_of(std::string step) {
  std::erase(step, '\n');
  std::map<std::string, Place> points;
  const std::regex point("#(\\d+) *= *CARTESIAN_POINT\\('[^']*',\\(([^,]+),([^,]+),([^)]+)\\)\\)");
  for (std::sregex_iterator at(step.begin(), step.end(), point), end; at != end; ++at) {
    points[at->str(1)] = {std::stod(at->str(2)), std::stod(at->str(3)), std::stod(at->str(4))};
  }
  Wire wire;
  std::map<std::string, Place> named;
  const std::regex vertex("#(\\d+) *= *VERTEX_POINT\\('[^']*',#(\\d+)\\)");
  for (std::sregex_iterator at(step.begin(), step.end(), vertex), end; at != end; ++at) {
    named[at->str(1)] = points.at(at->str(2));
    wire.vertices.push_back(points.at(at->str(2)));
  }
  const std::regex edge("EDGE_CURVE\\('[^']*',#(\\d+),#(\\d+),");
  for (std::sregex_iterator at(step.begin(), step.end(), edge), end; at != end; ++at) {
    wire.edges.emplace_back(named.at(at->str(1)), named.at(at->str(2)));
  }
  return wire;
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
  const auto [vertices, edges] = wire_of(slurp(step));
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
  // Its rulings join begin to begin and end to end.
  const auto joined = [&edges = edges](const Place& x, const Place& y) {
    return std::ranges::any_of(edges, [&](const auto& edge) {
      return distance(edge.first, x) + distance(edge.second, y) < 1e-9 ||
             distance(edge.first, y) + distance(edge.second, x) < 1e-9;
    });
  };
  const json& c = input.at("c").at("points");
  const json& d = input.at("d").at("points");
  EXPECT_EQ(edges.size(), 4U);
  EXPECT_TRUE(joined(c.front().get<Place>(), d.front().get<Place>()));
  EXPECT_TRUE(joined(c.back().get<Place>(), d.back().get<Place>()));
}

}  // namespace
}  // namespace torse::testing
