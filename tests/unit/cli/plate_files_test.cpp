// Drawings of a plate: a strip of 6 by 2 whose rulings are upright, with a bend of 5 degrees at the second one inside.
#include "torse/cli/plate_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace torse::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

PlateSheet sheet() {
  PlateSheet made{};
  made.face.name = "hull";
  made.unit = millimetres();
  Plate& plate = made.plate;
  for (const double x : {0.0, 2.0, 4.0, 6.0}) {
    plate.c.points.push_back({x, 0});
    plate.d.points.push_back({x, 2});
  }
  plate.c.before = plate.c.after = plate.d.before = plate.d.after = Interval(6);
  for (std::size_t i = 0; i < 4; ++i) plate.rulings.push_back({Rational(0), i, Interval(2), 0, i == 2 ? 5.0 : 0.0});
  plate.width = 6;
  plate.height = 2;
  plate.area_before = plate.area_after = Interval(12);
  plate.overlap.verdict = Truth::no;
  return made;
}

TEST(PlateFiles, LettersRunAlongTheirRulings) {
  const PlateSheet drawn = sheet();
  const double height = letter_height(drawn.plate);
  EXPECT_EQ(height, 6.0 / 80);
  const std::vector<Lettering> lines = letterings(drawn);
  EXPECT_EQ(lines[1].text, "R1  L 2");
  EXPECT_EQ(lines[2].text, "R2  L 2  bend +5 deg");
  EXPECT_EQ(lines[1].angle, 90);
  EXPECT_NEAR(lines[1].at.x, 2 - 0.4 * height, 1e-15);
  EXPECT_NEAR(lines[1].at.y, 0.16, 1e-15);
  EXPECT_EQ(lines[4].text, "C  L 6");
  EXPECT_NEAR(lines[4].at.y, -1.4 * height, 1e-15);
  EXPECT_EQ(lines[5].text, "D  L 6");
  EXPECT_NEAR(lines[5].at.y, 2 + 0.4 * height, 1e-15);
}

TEST(PlateFiles, RulingsThatRunDownAreReadFromBelow) {
  PlateSheet drawn = sheet();
  std::swap(drawn.plate.c, drawn.plate.d);
  const Lettering line = letterings(drawn)[1];
  EXPECT_EQ(line.angle, 90);
  EXPECT_NEAR(line.at.y, 0.16, 1e-15);
}

TEST(PlateFiles, SvgHasBentRulingsInAGroupOfTheirOwn) {
  const std::string svg = plate_svg(sheet());
  EXPECT_THAT(svg, HasSubstr("<g id=\"rulings\" stroke=\"blue\">\n   <line id=\"R1\" x1=\"2\" y1=\"0\" x2=\"2\" "
                             "y2=\"2\"/>\n  </g>\n  <g id=\"bends\" stroke=\"red\">\n   <line id=\"R2\" x1=\"4\" "
                             "y1=\"0\" x2=\"4\" y2=\"2\"/>\n  </g>"));
  EXPECT_THAT(svg, HasSubstr("<path d=\"M0,0 2,0 4,0 6,0 6,2 4,2 2,2 0,2 Z\"/>"));
}

/// Group codes and values by the reference of Release 12: a plain line type, four layers, one closed polyline.
TEST(PlateFiles, DxfIsReleaseTwelve) {
  const std::string dxf = plate_dxf(sheet());
  EXPECT_THAT(dxf, HasSubstr("999\ntorse unroll, 1 drawing unit = 1 mm\n  0\nSECTION\n  2\nHEADER\n  9\n$ACADVER\n  1\n"
                             "AC1009\n  9\n$EXTMIN\n 10\n0\n 20\n0\n 30\n0\n  9\n$EXTMAX\n 10\n6\n 20\n2\n 30\n0\n  0\n"
                             "ENDSEC\n  0\nSECTION\n  2\nTABLES\n  0\nTABLE\n  2\nLTYPE\n 70\n1\n  0\nLTYPE\n  2\n"
                             "CONTINUOUS\n 70\n0\n  3\nSolid line\n 72\n65\n 73\n0\n 40\n0\n  0\nENDTAB\n  0\nTABLE\n"
                             "  2\nLAYER\n 70\n4\n  0\nLAYER\n  2\nCUT\n 70\n0\n 62\n7\n  6\nCONTINUOUS\n"));
  for (const char* layer : {"RULINGS\n 70\n0\n 62\n5\n", "BENDS\n 70\n0\n 62\n1\n", "TEXT\n 70\n0\n 62\n3\n"})
    EXPECT_THAT(dxf, HasSubstr(std::string("  0\nLAYER\n  2\n") + layer + "  6\nCONTINUOUS\n"));
  EXPECT_THAT(dxf, HasSubstr("  2\nENTITIES\n  0\nPOLYLINE\n  8\nCUT\n 66\n1\n 10\n0\n 20\n0\n 30\n0\n 70\n1\n  0\n"
                             "VERTEX\n  8\nCUT\n 10\n0\n 20\n0\n 30\n0\n  0\nVERTEX\n  8\nCUT\n 10\n2\n 20\n0\n"));
  EXPECT_THAT(dxf, HasSubstr("  0\nLINE\n  8\nRULINGS\n 10\n2\n 20\n0\n 30\n0\n 11\n2\n 21\n2\n 31\n0\n  0\nLINE\n  8\n"
                             "BENDS\n 10\n4\n 20\n0\n 30\n0\n 11\n4\n 21\n2\n 31\n0\n  0\nTEXT\n"));
  EXPECT_THAT(dxf, ::testing::EndsWith("  0\nENDSEC\n  0\nEOF\n"));
}

/// Release 12 has no letters beyond ASCII: each becomes one question mark.
TEST(PlateFiles, DxfIsAscii) {
  PlateSheet drawn = sheet();
  drawn.face.name = "Bu\u00F1a \u2192 end";
  EXPECT_THAT(plate_dxf(drawn), HasSubstr("  1\nBu?a ? end: 6 x 2 mm, seen from the side of the normal\n"));
  drawn.mirrored = true;
  EXPECT_THAT(plate_dxf(drawn), HasSubstr("seen from the side opposite to the normal\n"));
}

TEST(PlateFiles, NotesSayWhatTheOutlineDoes) {
  PlateSheet drawn = sheet();
  EXPECT_THAT(plate_svg(drawn), Not(HasSubstr("THE OUTLINE")));
  drawn.plate.overlap.verdict = Truth::unknown;
  EXPECT_THAT(plate_svg(drawn), HasSubstr("THE OUTLINE TOUCHES ITSELF"));
  drawn.plate.overlap.verdict = Truth::yes;
  EXPECT_THAT(plate_svg(drawn), HasSubstr("OVERLAPS ITSELF"));
}

}  // namespace
}  // namespace torse::cli
