// SVG 1.1: geometry with y upwards in one transformed group, so that the coordinates are those of the plate.
#include <fmt/format.h>

#include "torse/cli/plate_files.hpp"
#include "torse/figures/svg.hpp"

namespace torse::cli {
namespace {

/// A length for SVG's width and height: in the plate's unit where SVG knows it, else in millimetres.
std::string svg_length(double x, const LengthUnit& unit) {
  if (unit.name == "mm" || unit.name == "cm" || unit.name == "in") return fmt::format("{}{}", x, unit.name);
  return fmt::format("{}mm", x * (unit.metres / millimetres().metres).to_double());
}

std::string outline_path(const Plate& plate) {
  std::string path;
  for (const PlatePoint& p : outline_of(plate).points)
    path += fmt::format("{}{},{}", path.empty() ? "M" : " ", p.x, p.y);
  return path + " Z";
}

/// The marked rulings between the first and the last; `bent`: those where the sheet is bent sharply.
std::string ruling_lines(const Plate& plate, bool bent) {
  std::string lines;
  for (std::size_t i = 1; i + 1 < plate.rulings.size(); ++i) {
    const PlateRuling& ruling = plate.rulings[i];
    if ((ruling.bend != 0) != bent) continue;
    const PlatePoint& c = plate.c.points[ruling.vertex];
    const PlatePoint& d = plate.d.points[ruling.vertex];
    lines += fmt::format("   <line id=\"R{}\" x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"/>\n", i, c.x, c.y, d.x, d.y);
  }
  return lines;
}

/// Letters of a size that renderers draw well, scaled to theirs.
constexpr double font_size = 10;

std::string texts(const PlateSheet& sheet) {
  const double scale = letter_height(sheet.plate) / font_size;
  std::string result;
  for (const Lettering& line : letterings(sheet)) {
    result += fmt::format("   <text transform=\"translate({} {}) rotate({}) scale({} {})\">{}</text>\n", line.at.x,
                          line.at.y, line.angle, scale, -scale, figures::svg_escaped(line.text));
  }
  return result;
}

}  // namespace

std::string plate_svg(const PlateSheet& sheet) {
  const Plate& plate = sheet.plate;
  const double margin = 10 * letter_height(plate);
  const double width = plate.width + 2 * margin;
  const double height = plate.height + 2 * margin;
  const double stroke = letter_height(plate) / 12;
  std::string svg = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  svg += fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"{}\" height=\"{}\" viewBox=\"{} {} {} {}\">\n",
      svg_length(width, sheet.unit), svg_length(height, sheet.unit), -margin, -plate.height - margin, width, height);
  svg += fmt::format(" <title>{}</title>\n <desc>1 user unit = 1 {}</desc>\n", figures::svg_escaped(sheet.face.name),
                     sheet.unit.name);
  svg += fmt::format(" <g transform=\"scale(1 -1)\" fill=\"none\" stroke-width=\"{}\">\n", stroke);
  svg += fmt::format("  <g id=\"cut\" stroke=\"black\">\n   <path d=\"{}\"/>\n  </g>\n", outline_path(plate));
  svg += fmt::format("  <g id=\"rulings\" stroke=\"blue\">\n{}  </g>\n", ruling_lines(plate, false));
  svg += fmt::format("  <g id=\"bends\" stroke=\"red\">\n{}  </g>\n", ruling_lines(plate, true));
  svg += fmt::format(
      "  <g id=\"text\" fill=\"green\" stroke=\"none\" font-family=\"sans-serif\" font-size=\"{}\">\n{}  </g>\n",
      font_size, texts(sheet));
  return svg + " </g>\n</svg>\n";
}

}  // namespace torse::cli
