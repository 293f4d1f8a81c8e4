// Drawings of a plate made by hand: every group code of the DXF, the groups of the SVG, the places of the words.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "torse/cli/plate_files.hpp"

namespace torse::cli {
namespace {

/// 800 x 64 with four rulings along y, bent at the third.
PlateSheet sheet() {
  PlateSheet sheet{};
  Plate& plate = sheet.plate;
  for (const double x : {0.0, 200.0, 400.0, 800.0}) {
    const std::size_t vertex = plate.rulings.size();
    plate.c.points.push_back({x, 0});
    plate.d.points.push_back({x, 64});
    plate.rulings.push_back({ratio<Rational>(static_cast<int>(vertex), 3), vertex, Interval::point(64), 0});
  }
  plate.rulings[2].bend = 36.87;
  for (PlateRail* rail : {&plate.c, &plate.d}) {
    rail->before = rail->after = Interval::point(800);
    rail->deviation = {0, 0, 0};
    rail->error = rail == &plate.c ? 0.5 : 0.25;
  }
  plate.width = 800;
  plate.height = 64;
  plate.deviation = 0.001;
  plate.area_after = Interval::point(800 * 64);  // letters of height 64 / 8
  sheet.face.name = "band & é →";
  sheet.unit = millimetres();
  return sheet;
}

void expect_at(const Lettering& found, double x, double y, double angle, const std::string& text) {
  EXPECT_NEAR(found.at.x, x, 1e-12) << text;
  EXPECT_NEAR(found.at.y, y, 1e-12) << text;
  EXPECT_NEAR(found.angle, angle, 1e-12) << text;
  EXPECT_EQ(found.text, text);
}

/// Words along a ruling begin after 0.08 of it, 0.4 letters away from it.
TEST(Letterings, AlongRulingsRailsAndBelow) {
  const std::vector<Lettering> list = letterings(sheet());
  ASSERT_EQ(list.size(), 8U);
  const double y = 0.08 * 64;
  expect_at(list[0], -3.2, y, 90, "R0  L 64");
  expect_at(list[1], 196.8, y, 90, "R1  L 64");
  expect_at(list[2], 396.8, y, 90, "R2  L 64  bend +36.87 deg");
  expect_at(list[3], 796.8, y, 90, "R3  L 64");
  expect_at(list[4], 200, -1.4 * 8, 0, "C  L 800");
  expect_at(list[5], 200, 64 + 0.4 * 8, 0, "D  L 800");
  expect_at(list[6], 0, -40, 0, "band & é →: 800 x 64 mm, seen from the side of the normal");
  expect_at(list[7], 0, -52, 0, "outline within 0.001 mm; length of C within 0.5, of D within 0.25");
}

/// The ruling from (0, 0) to each of these points, with C and D on either side.
TEST(Letterings, AreUpright) {
  const auto angle = [](double x, double y) {
    PlateSheet turned = sheet();
    turned.plate.d.points[0] = {x, y};
    return letterings(turned)[0].angle;
  };
  EXPECT_NEAR(angle(0, 64), 90, 1e-12);
  EXPECT_NEAR(angle(0, -64), 90, 1e-12);
  EXPECT_NEAR(angle(64, 64), 45, 1e-12);
  EXPECT_NEAR(angle(64, -64), -45, 1e-12);
  EXPECT_NEAR(angle(-64, 64), -45, 1e-12);
  EXPECT_NEAR(angle(-64, -64), 45, 1e-12);
}

TEST(Letterings, SayWhatIsWrong) {
  PlateSheet bad = sheet();
  bad.mirrored = true;
  bad.plate.overlap.verdict = Truth::yes;
  std::vector<Lettering> list = letterings(bad);
  ASSERT_EQ(list.size(), 9U);
  EXPECT_TRUE(list[6].text.ends_with("seen from the side opposite to the normal"));
  expect_at(list[8], 0, -64, 0, "OVERLAPS ITSELF: cannot be cut from one sheet");
  bad.plate.overlap.verdict = Truth::unknown;
  EXPECT_EQ(letterings(bad).back().text, "THE OUTLINE TOUCHES ITSELF, or nearly so");
}

TEST(Letterings, CanBeReadAndFitTheRulings) {
  Plate plate = sheet().plate;
  EXPECT_EQ(letter_height(plate), 8);
  plate.area_after = Interval::point(800 * 1000);
  EXPECT_EQ(letter_height(plate), 10);
  plate.area_after = Interval::point(800);
  EXPECT_EQ(letter_height(plate), 2);
}

/// "%%d" would be drawn as a degree sign, "^I" read as a tab.
TEST(PlateDxf, NamesHoldNoControlCodes) {
  PlateSheet odd = sheet();
  odd.face.name = "a%%d 50% %%% ^I";
  EXPECT_NE(plate_dxf(odd).find("\n  1\na%%%%%%d 50% %%%%%%%%% ^ I: 800 x 64 mm,"), std::string::npos);
}

/// The parts of the outline in the order of its edges: C, the last ruling, D backwards, the first ruling.
TEST(PlateJson, EveryMember) {
  PlateSheet bad = sheet();
  Plate& plate = bad.plate;
  for (int i = 0; i < 4; ++i) plate.parameters.push_back(ratio<Rational>(i, 3));
  plate.vertex_error = 0.125;
  plate.ruling_error = 0.25;
  plate.stretch = 0.5;
  plate.area_before = Interval::hull(51000, 52000);
  plate.rulings.resize(1, plate.rulings.front());
  plate.rulings[0] = {ratio<Rational>(2, 3), 2, Interval::hull(63, 65), 0.0625, 36.5};
  plate.overlap.verdict = Truth::yes;
  plate.overlap.meetings = {{0, 7, {1, 2}, true}, {2, 4, {3, 4}, false}, {3, 6, {5, 6}, true}};
  plate.c.deviation.clear();
  bad.warp = Interval::hull(0.25, 0.75);
  bad.tolerance = 0.001;
  bad.mirrored = true;
  EXPECT_EQ(nlohmann::json::parse(plate_json(bad)), nlohmann::json::parse(R"({
    "torse": 1, "type": "plate", "name": "band & é →", "unit": "mm", "tolerance": 0.001, "mirrored": true,
    "developable": true, "class": "plane", "max_warp_deg": {"lo": 0.25, "hi": 0.75}, "width": 800.0, "height": 64.0,
    "parameters": ["0", "1/3", "2/3", "1"],
    "c": {"points": [[0.0, 0.0], [200.0, 0.0], [400.0, 0.0], [800.0, 0.0]],
          "length": {"before": {"lo": 800.0, "hi": 800.0}, "after": {"lo": 800.0, "hi": 800.0}, "error": 0.5}},
    "d": {"points": [[0.0, 64.0], [200.0, 64.0], [400.0, 64.0], [800.0, 64.0]],
          "length": {"before": {"lo": 800.0, "hi": 800.0}, "after": {"lo": 800.0, "hi": 800.0}, "error": 0.25}},
    "rulings": [{"t": "2/3", "vertex": 2, "length": {"lo": 63.0, "hi": 65.0}, "error": 0.0625, "bend_deg": 36.5}],
    "error": {"vertex": 0.125, "boundary": 0.001, "ruling": 0.25, "inside": 0.5},
    "area": {"before": {"lo": 51000.0, "hi": 52000.0}, "after": {"lo": 51200.0, "hi": 51200.0}},
    "overlap": {"verdict": true, "meetings": [
      {"first": {"rail": "c", "from": "0", "to": "1/3"}, "second": {"rail": null, "from": "0", "to": "0"},
       "at": [1.0, 2.0], "certain": true},
      {"first": {"rail": "c", "from": "2/3", "to": "1"}, "second": {"rail": "d", "from": "2/3", "to": "1"},
       "at": [3.0, 4.0], "certain": false},
      {"first": {"rail": null, "from": "1", "to": "1"}, "second": {"rail": "d", "from": "0", "to": "1/3"},
       "at": [5.0, 6.0], "certain": true}]}})"));
  bad.plate.overlap = {Truth::unknown, {}};
  EXPECT_EQ(nlohmann::json::parse(plate_json(bad))["overlap"],
            nlohmann::json::parse(R"({"verdict": null, "meetings": []})"));
}

/// What a group of the drawing holds.
std::string svg_group(const std::string& svg, const std::string& id) {
  const std::size_t begin = svg.find('\n', svg.find("<g id=\"" + id + "\"")) + 1;
  return svg.substr(begin, svg.find("  </g>", begin) - begin);
}

TEST(PlateSvg, Groups) {
  const std::string svg = plate_svg(sheet());
  EXPECT_EQ(svg_group(svg, "cut"), "   <path d=\"M0,0 200,0 400,0 800,0 800,64 400,64 200,64 0,64 Z\"/>\n");
  EXPECT_EQ(svg_group(svg, "rulings"), "   <line id=\"R1\" x1=\"200\" y1=\"0\" x2=\"200\" y2=\"64\"/>\n");
  EXPECT_EQ(svg_group(svg, "bends"), "   <line id=\"R2\" x1=\"400\" y1=\"0\" x2=\"400\" y2=\"64\"/>\n");
  const std::string words = svg_group(svg, "text");
  EXPECT_NE(words.find("rotate(0) scale(0.8 -0.8)\">C  L 800</text>"), std::string::npos) << words;
  EXPECT_NE(svg.find(" width=\"960mm\" height=\"224mm\" viewBox=\"-80 -144 960 224\">"), std::string::npos) << svg;
  EXPECT_NE(svg.find("<title>band &amp; é →</title>"), std::string::npos);
}

TEST(PlateSvg, SizesInUnitsThatSvgDoesNotKnow) {
  PlateSheet large = sheet();
  large.unit = read_unit("m");
  EXPECT_NE(plate_svg(large).find(" width=\"960000mm\" height=\"224000mm\" viewBox=\"-80 -144 960 224\">"),
            std::string::npos);
  large.unit = read_unit("ft");
  EXPECT_NE(plate_svg(large).find(" width=\"292608mm\" height=\"68275.2mm\" viewBox=\"-80 -144 960 224\">"),
            std::string::npos);
}

/// Codes and values with a blank between them, a bar behind each pair.
std::string pairs(const std::string& dxf) {
  std::string text;
  bool code = true;
  for (const char c : dxf) {
    if (c == ' ' && code) continue;
    text += c != '\n' ? c : code ? ' ' : '|';
    if (c == '\n') code = !code;
  }
  return text;
}

TEST(PlateDxf, EveryGroup) {
  const std::string text = pairs(plate_dxf(sheet()));
  const std::string start =
      "999 torse unroll, 1 drawing unit = 1 mm|0 SECTION|2 HEADER|9 $ACADVER|1 AC1009|9 $EXTMIN|10 0|20 0|30 0|"
      "9 $EXTMAX|10 800|20 64|30 0|0 ENDSEC|0 SECTION|2 TABLES|0 TABLE|2 LTYPE|70 1|0 LTYPE|2 CONTINUOUS|70 0|"
      "3 Solid line|72 65|73 0|40 0|0 ENDTAB|0 TABLE|2 LAYER|70 4|0 LAYER|2 CUT|70 0|62 7|6 CONTINUOUS|"
      "0 LAYER|2 RULINGS|70 0|62 5|6 CONTINUOUS|0 LAYER|2 BENDS|70 0|62 1|6 CONTINUOUS|"
      "0 LAYER|2 TEXT|70 0|62 3|6 CONTINUOUS|0 ENDTAB|0 ENDSEC|0 SECTION|2 ENTITIES|"
      "0 POLYLINE|8 CUT|66 1|10 0|20 0|30 0|70 1|";
  std::string corners;
  for (const char* corner : {"10 0|20 0", "10 200|20 0", "10 400|20 0", "10 800|20 0", "10 800|20 64", "10 400|20 64",
                             "10 200|20 64", "10 0|20 64"}) {
    corners += std::string("0 VERTEX|8 CUT|") + corner + "|30 0|";
  }
  const std::string lines =
      "0 SEQEND|8 CUT|0 LINE|8 RULINGS|10 200|20 0|30 0|11 200|21 64|31 0|"
      "0 LINE|8 BENDS|10 400|20 0|30 0|11 400|21 64|31 0|";
  EXPECT_EQ(text.substr(0, text.find("0 TEXT|8 TEXT")), start + corners + lines);
  EXPECT_NE(text.find("|0 TEXT|8 TEXT|10 0|20 -40|30 0|40 8|1 band & ? ?: 800 x 64 mm, "), std::string::npos) << text;
  EXPECT_TRUE(text.ends_with("|50 0|0 ENDSEC|0 EOF|"));
}

TEST(PlateDxf, BendsToEitherSideAreBends) {
  PlateSheet folded = sheet();
  const std::string towards = plate_dxf(folded);
  folded.plate.rulings[2].bend *= -1;
  const std::string away = plate_dxf(folded);
  for (const std::string* dxf : {&towards, &away})
    EXPECT_NE(pairs(*dxf).find("0 LINE|8 BENDS|10 400"), std::string::npos);
}

TEST(PlateDxf, EqualCornersAreOne) {
  PlateSheet cone = sheet();
  for (PlatePoint& p : cone.plate.c.points) p = {0, 0};
  const std::string text = pairs(plate_dxf(cone));
  std::size_t count = 0;
  for (std::size_t at = text.find("0 VERTEX"); at != std::string::npos; at = text.find("0 VERTEX", at + 1)) ++count;
  EXPECT_EQ(count, 5U);
}

}  // namespace
}  // namespace torse::cli
