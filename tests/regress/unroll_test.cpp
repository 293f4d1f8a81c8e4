// torse unroll, the real program: the three files agree with each other, exit codes, refusals that write nothing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/program.hpp"

namespace torse::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

/// A quarter of a cone with its tip at C, of slant height sqrt(2).
const std::string cone = R"({"torse": 1, "type": "ruled", "degree": 2,
  "c": {"points": [[0,0,1],[0,0,1],[0,0,1]], "weights": [1,1,2]},
  "d": {"points": [[1,0,0],[1,1,0],[0,1,0]], "weights": [1,1,2]}})";

/// Two planes at an angle.
const std::string crease = R"({"torse": 1, "type": "ruled", "degree": 1, "knots": [0, 1, 2],
  "c": {"points": [[0,0,0],[100,0,0],[180,0,60]]}, "d": {"points": [[0,80,0],[100,80,0],[180,80,60]]}})";

/// A planar band with a loop.
const std::string loop = R"({"torse": 1, "type": "ruled", "degree": 3,
  "c": {"points": [[0,0,0],[300,200,0],[-200,200,0],[100,0,0]]},
  "d": {"points": [[0,-20,0],[330,220,0],[-230,220,0],[100,-20,0]]}})";

const std::string saddle = R"({"torse": 1, "type": "ruled", "degree": 1,
  "c": {"points": [[0,0,0],[2,0,0]]}, "d": {"points": [[0,1,0],[2,1,"0.02"]]}})";

const std::string bow_tie = R"({"torse": 1, "type": "ruled", "degree": 1,
  "c": {"points": [[0,0,0],[1,1,0]]}, "d": {"points": [[0,1,0],[1,0,0]]}})";

/// A zigzag strip of so many planes.
std::string long_cylinder(int pieces) {
  json net{{"torse", 1}, {"type", "ruled"}, {"degree", 1}, {"knots", json::array()}};
  for (const char* row : {"c", "d"}) {
    json points = json::array();
    for (int i = 0; i <= pieces; ++i) points.push_back({i, i % 2, row[0] - 'c'});
    net[row] = {{"points", points}};
  }
  for (int i = 0; i <= pieces; ++i) net["knots"].push_back(i);
  return net.dump();
}

class Unroll : public ::testing::Test {
 public:
  std::string file(const std::string& name, const std::string& text = "") const {
    if (!text.empty()) spill(scratch / name, text);
    return (scratch / name).string();
  }

  /// Runs with the options before -o - and gives the JSON.
  json plate(const std::string& text, std::vector<std::string> options = {}, int exit = 0) const {
    std::vector<std::string> words{"unroll", file("net.json", text), "-o", "-"};
    words.insert(words.end(), options.begin(), options.end());
    const ProgramResult result = run_program(words);
    EXPECT_EQ(result.exit, exit) << result.err;
    return json::parse(result.out);
  }

  /// Expects a refusal that writes nothing, and gives its message.
  std::string refusal(const std::string& text, std::vector<std::string> options, int exit) const {
    std::vector<std::string> words{"unroll", file("net.json", text), "-o", file("no.svg")};
    words.insert(words.end(), options.begin(), options.end());
    const ProgramResult result = run_program(words);
    EXPECT_EQ(result.exit, exit);
    EXPECT_EQ(result.out, "");
    EXPECT_FALSE(std::filesystem::exists(scratch / "no.svg"));
    return result.err;
  }

  Scratch scratch;
};

TEST_F(Unroll, AConeInJson) {
  const json sheet = plate(cone, {"--tolerance", "1e-6", "--unit", "in"});
  EXPECT_EQ(sheet["type"], "plate");
  EXPECT_EQ(sheet["class"], "cone");
  EXPECT_EQ(sheet["developable"], true);
  EXPECT_EQ(sheet["unit"], "in");
  EXPECT_EQ(sheet["overlap"], json::parse(R"({"verdict": false, "meetings": []})"));
  EXPECT_EQ(sheet["parameters"].front(), "0");
  EXPECT_EQ(sheet["parameters"].back(), "1");
  const double arc = std::acos(-1.0) / 2;
  const auto holds = [](const json& range, double x) {
    EXPECT_LE(range["lo"].get<double>(), x * (1 + 1e-15));
    EXPECT_GE(range["hi"].get<double>(), x * (1 - 1e-15));
  };
  holds(sheet["d"]["length"]["before"], arc);
  holds(sheet["area"]["before"], arc * std::sqrt(2.0) / 2);
  EXPECT_EQ(sheet["c"]["length"]["before"], json::parse(R"({"lo": 0.0, "hi": 0.0})"));
  // An arc of a circle about the tip.
  const auto tip = sheet["c"]["points"][0];
  for (const auto& point : sheet["d"]["points"]) {
    const double x = point[0].get<double>() - tip[0].get<double>();
    const double y = point[1].get<double>() - tip[1].get<double>();
    EXPECT_NEAR(std::hypot(x, y), std::sqrt(2.0), 1e-8);
  }
  EXPECT_LE(sheet["error"]["boundary"], 1e-6);
  ASSERT_EQ(sheet["rulings"].size(), 11U);
  EXPECT_EQ(sheet["rulings"][3]["t"], "3/10");
  holds(sheet["rulings"][3]["length"], std::sqrt(2.0));
}

/// Pairs of group codes and values.
std::vector<std::pair<int, std::string>> dxf_groups(const std::string& text) {
  std::vector<std::pair<int, std::string>> groups;
  std::istringstream lines(text);
  for (std::string code, value; std::getline(lines, code) && std::getline(lines, value);) {
    groups.emplace_back(std::stoi(code), value);
  }
  return groups;
}

using Points = std::vector<std::pair<std::string, std::string>>;

/// The coordinates 10, 20 of all entities of a type on a layer.
Points dxf_points(const std::vector<std::pair<int, std::string>>& groups, const std::string& type,
                  const std::string& layer) {
  Points points;
  std::string at;
  std::string on;
  for (const auto& [code, value] : groups) {
    if (code == 0) at = value;
    if (code == 8) on = value;
    if (at != type || on != layer) continue;
    if (code == 10) points.emplace_back(value, "");
    if (code == 20) points.back().second = value;
  }
  return points;
}

TEST_F(Unroll, SvgAndDxfHaveTheCoordinatesOfTheJson) {
  const ProgramResult result = run_program({"unroll", file("net.json", crease), "-o", file("a.svg"), "-o",
                                            file("a.DXF"), "-o", file("a.json"), "--unit", "cm", "--rulings", "4"});
  ASSERT_EQ(result.exit, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("200 x 80 cm"));
  EXPECT_THAT(result.out, HasSubstr("no overlap"));
  const json plate = json::parse(slurp(scratch / "a.json"));
  std::vector<std::pair<double, double>> corners;
  for (const auto& x : plate["c"]["points"]) corners.emplace_back(x[0], x[1]);
  for (auto i = plate["d"]["points"].rbegin(); i != plate["d"]["points"].rend(); ++i)
    corners.emplace_back((*i)[0], (*i)[1]);

  const auto groups = dxf_groups(slurp(scratch / "a.DXF"));
  EXPECT_EQ(groups.back(), (std::pair<int, std::string>(0, "EOF")));
  std::vector<std::pair<double, double>> drawn;
  for (const auto& [x, y] : dxf_points(groups, "VERTEX", "CUT")) drawn.emplace_back(std::stod(x), std::stod(y));
  EXPECT_EQ(drawn, corners);
  EXPECT_EQ(dxf_points(groups, "LINE", "RULINGS").size(), 2U);
  EXPECT_EQ(dxf_points(groups, "LINE", "BENDS").size(), 1U);
  EXPECT_GE(dxf_points(groups, "TEXT", "TEXT").size(), 7U);

  const std::string svg = slurp(scratch / "a.svg");
  drawn.clear();
  const std::size_t path = svg.find("<path d=\"M") + 10;
  std::istringstream pairs(svg.substr(path, svg.find(" Z\"", path) - path));
  char comma = 0;
  for (double x = 0, y = 0; pairs >> x >> comma >> y;) drawn.emplace_back(x, y);
  EXPECT_EQ(drawn, corners);
  // True scale: the width in cm is that of the view box.
  double width = 0;
  double left = 0;
  double top = 0;
  double box = 0;
  ASSERT_EQ(std::sscanf(svg.c_str() + svg.find(" width="), " width=\"%lfcm\"", &width), 1);
  ASSERT_EQ(std::sscanf(svg.c_str() + svg.find("viewBox="), "viewBox=\"%lf %lf %lf", &left, &top, &box), 3);
  EXPECT_EQ(width, box);
  EXPECT_EQ(width, 200 - 2 * left);
  EXPECT_THAT(svg, HasSubstr("bend +36.87 deg"));
}

TEST_F(Unroll, AnOverlapIsSaidAndWritten) {
  const json sheet = plate(loop, {}, 1);
  EXPECT_EQ(sheet["overlap"]["verdict"], true);
  const auto& first = sheet["overlap"]["meetings"][0];
  EXPECT_TRUE(first["first"]["rail"] == "c" || first["first"]["rail"] == "d");
  const ProgramResult result = run_program({"unroll", file("net.json"), "-o", file("a.svg")});
  EXPECT_EQ(result.exit, 1);
  EXPECT_THAT(result.out, HasSubstr("the plate overlaps itself"));
  EXPECT_THAT(slurp(scratch / "a.svg"), HasSubstr("OVERLAPS ITSELF"));
}

TEST_F(Unroll, WarpedSurfaces) {
  // The warp is largest at t = 0: tan = 0.01.
  const json sheet = plate(saddle);
  EXPECT_EQ(sheet["developable"], false);
  EXPECT_EQ(sheet["class"], "none");
  EXPECT_NEAR(sheet["max_warp_deg"]["hi"].get<double>(), std::atan(0.01) * 180 / std::acos(-1.0), 1e-3);
  EXPECT_GT(sheet["error"]["inside"], 0.0);
  EXPECT_LT(sheet["error"]["inside"], 1.3e-5);
  EXPECT_THAT(refusal(saddle, {"--max-warp", "0.5deg"}, 1), HasSubstr("more than --max-warp 0.5deg"));
}

/// The first piece is 1e-20 of the domain: but for that it is the segment from (0, 0) to (1, 2), passed ever slower,
/// and the other one the parabola with the control points (1, 2), (3, 0), (4, 1).
TEST_F(Unroll, APieceOfNextToNoParameters) {
  const json sheet = plate(R"({"torse": 1, "type": "ruled", "degree": 2, "knots": [0,0,"1e-20",1,1],
    "c": {"points": [[0,0,0],[1,2,0],[3,0,0],[4,1,0]]}, "d": {"points": [[0,0,1],[1,2,1],[3,0,1],[4,1,1]]}})");
  const auto speed = [](double t) { return std::hypot(4 - 2 * t, -4 + 6 * t); };
  const int halves = 1000;
  double sum = speed(0) + speed(1);
  for (int i = 1; i < 2 * halves; ++i) sum += (i % 2 == 1 ? 4 : 2) * speed(i / (2.0 * halves));
  const double length = std::sqrt(5.0) + sum / (6 * halves);
  EXPECT_NEAR(sheet["c"]["length"]["before"]["lo"].get<double>(), length, 1e-9);
  EXPECT_NEAR(sheet["c"]["length"]["before"]["hi"].get<double>(), length, 1e-9);
}

TEST_F(Unroll, WhatCannotLieFlatIsRefused) {
  EXPECT_THAT(refusal(bow_tie, {}, 1), HasSubstr("singular at t = 1/2 (vanishing)"));
  const std::string folded = R"({"torse": 1, "type": "ruled", "degree": 2,
    "c": {"points": [[0,0,0],[1,0,0],[2,0,0]]}, "d": {"points": [[0,1,0],[1,1,0],[0,1,0]]}})";
  EXPECT_THAT(refusal(folded, {}, 1), HasSubstr("1/2 to 1 (edge)"));
}

TEST_F(Unroll, UsageAndInput) {
  EXPECT_THAT(refusal(cone, {"--tolerance", "1e-30"}, 2), HasSubstr("--tolerance: expected"));
  EXPECT_THAT(refusal(cone, {"--tolerance", "x"}, 2), HasSubstr("--tolerance: expected a number"));
  EXPECT_THAT(refusal(cone, {"--tolerance", "1e-9"}, 2),
              HasSubstr("json: tolerance: more than 5001 rulings do not reach it"));
  EXPECT_THAT(refusal(cone, {"--unit", "furlong"}, 2), HasSubstr("--unit: expected one of mm"));
  EXPECT_THAT(refusal(cone, {"--rulings", "0"}, 2), HasSubstr("--rulings"));
  EXPECT_THAT(refusal(cone, {"--rulings", "5001"}, 2), HasSubstr("--rulings"));
  EXPECT_THAT(refusal(long_cylinder(5001), {}, 2), HasSubstr("expected at most 5000 pieces to unroll, found 5001"));
  EXPECT_THAT(refusal(cone, {"--max-warp", "60deg"}, 2), HasSubstr("--max-warp: expected at most 45"));
  EXPECT_THAT(refusal(cone, {"-o", file("plate.pdf")}, 2), HasSubstr("ends in .svg, .dxf or .json"));
  EXPECT_THAT(refusal("{}", {}, 2), HasSubstr("net.json"));
  EXPECT_THAT(refusal(R"({"torse": 1, "type": "ruled", "degree": 1, "c": {"points": [[0,0,0],["1e-3000",0,0]]},
    "d": {"points": [[0,"1e-3000",0],["1e-3000","1e-3000",0]]}})",
                      {}, 2),
              HasSubstr("cannot be written"));
  EXPECT_EQ(run_program({"unroll", file("net.json", cone), file("net.json"), "-o", "-"}).exit, 2);
  EXPECT_EQ(run_program({"unroll", file("net.json")}).exit, 2);
}

}  // namespace
}  // namespace torse::testing
