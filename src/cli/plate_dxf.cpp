// DXF of AutoCAD Release 12 (AC1009), the version that every program reads: group codes and values on lines of their
// own.
#include <fmt/format.h>

#include <string_view>

#include "torse/cli/plate_files.hpp"

namespace torse::cli {
namespace {

/// A group code with its value.
template <class T>
std::string group(int code, const T& value) {
  return fmt::format("{:3}\n{}\n", code, value);
}

/// Release 12 knows ASCII only.
std::string ascii(std::string_view text) {
  std::string result;
  for (char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      result += c;
    } else if (byte >= 0xC0) {
      result += '?';
    }
  }
  return result;
}

/// A text that is drawn as it is: "%%" and "^" begin control codes, "%%%" is drawn as a percent sign and "^ " as "^".
std::string drawn(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool doubled = text[i] == '%' && ((i > 0 && text[i - 1] == '%') || text.substr(i + 1).starts_with('%'));
    result += text[i];
    if (doubled) result += "%%";
    if (text[i] == '^') result += ' ';
  }
  return result;
}

std::string point(int code, const PlatePoint& p) { return group(code, p.x) + group(code + 10, p.y); }

std::string point_in_space(const PlatePoint& p) { return point(10, p) + group(30, 0.0); }

std::string section(std::string_view name, const std::string& content) {
  return group(0, "SECTION") + group(2, name) + content + group(0, "ENDSEC");
}

std::string header(const PlateSheet& sheet) {
  return section("HEADER", group(9, "$ACADVER") + group(1, "AC1009") + group(9, "$EXTMIN") + point_in_space({0, 0}) +
                               group(9, "$EXTMAX") + point_in_space({sheet.plate.width, sheet.plate.height}));
}

std::string layer(std::string_view name, int colour) {
  return group(0, "LAYER") + group(2, name) + group(70, 0) + group(62, colour) + group(6, "CONTINUOUS");
}

std::string tables() {
  const std::string line_type = group(0, "TABLE") + group(2, "LTYPE") + group(70, 1) + group(0, "LTYPE") +
                                group(2, "CONTINUOUS") + group(70, 0) + group(3, "Solid line") + group(72, 65) +
                                group(73, 0) + group(40, 0.0) + group(0, "ENDTAB");
  const std::string layers = group(0, "TABLE") + group(2, "LAYER") + group(70, 4) + layer("CUT", 7) +
                             layer("RULINGS", 5) + layer("BENDS", 1) + layer("TEXT", 3) + group(0, "ENDTAB");
  return section("TABLES", line_type + layers);
}

std::string outline(const Plate& plate) {
  std::string polyline = group(0, "POLYLINE") + group(8, "CUT") + group(66, 1) + point_in_space({0, 0}) + group(70, 1);
  const std::vector<PlatePoint> points = outline_of(plate).points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i] == points[(i + 1) % points.size()]) continue;
    polyline += group(0, "VERTEX") + group(8, "CUT") + point_in_space(points[i]);
  }
  return polyline + group(0, "SEQEND") + group(8, "CUT");
}

std::string lines(const Plate& plate) {
  std::string result;
  for (std::size_t i = 1; i + 1 < plate.rulings.size(); ++i) {
    const PlateRuling& ruling = plate.rulings[i];
    const PlatePoint& d = plate.d.points[ruling.vertex];
    result += group(0, "LINE") + group(8, ruling.bend == 0 ? "RULINGS" : "BENDS") +
              point_in_space(plate.c.points[ruling.vertex]) + point(11, d) + group(31, 0.0);
  }
  return result;
}

std::string texts(const PlateSheet& sheet) {
  std::string result;
  for (const Lettering& line : letterings(sheet)) {
    result += group(0, "TEXT") + group(8, "TEXT") + point_in_space(line.at) + group(40, letter_height(sheet.plate)) +
              group(1, drawn(ascii(line.text))) + group(50, line.angle);
  }
  return result;
}

}  // namespace

std::string plate_dxf(const PlateSheet& sheet) {
  return group(999, "torse unroll, 1 drawing unit = 1 " + sheet.unit.name) + header(sheet) + tables() +
         section("ENTITIES", outline(sheet.plate) + lines(sheet.plate) + texts(sheet)) + group(0, "EOF");
}

}  // namespace torse::cli
