// The words on a plate.
#include "torse/cli/plate_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "torse/exact/decide/words.hpp"

namespace torse::cli {
namespace {

PlatePoint between(const PlatePoint& a, const PlatePoint& b, double s) {
  return {a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)};
}

/// A text along the line from a to b, upright, beginning at that share of it; `above` and `below`: how far it keeps off
/// the line on either side of its own baseline.
Lettering along(const PlatePoint& a, const PlatePoint& b, double share, double above, const std::string& text) {
  const bool reversed = b.x < a.x || (b.x == a.x && b.y < a.y);
  const PlatePoint& from = reversed ? b : a;
  const PlatePoint& to = reversed ? a : b;
  const double angle = std::atan2(to.y - from.y, to.x - from.x);
  const PlatePoint start = between(from, to, share);
  return {{start.x - above * std::sin(angle), start.y + above * std::cos(angle)}, angle * 180 / std::numbers::pi, text};
}

double middle(const Interval& x) { return x.lower() + (x.upper() - x.lower()) / 2; }

std::string label_of(const PlateRuling& ruling, std::size_t number) {
  return fmt::format("R{}  L {:.6g}{}", number, middle(ruling.before),
                     ruling.bend == 0 ? "" : fmt::format("  bend {:+.4g} deg", ruling.bend));
}

/// The name of a rail beside its middle edge, on the side away from the other rail.
Lettering rail_lettering(const PlateRail& rail, const PlateRail& other, const std::string& name, double height) {
  const std::size_t i = (rail.points.size() - 1) / 2;
  const PlatePoint& a = rail.points[i];
  const PlatePoint& b = rail.points[i + 1];
  const PlatePoint& far = other.points[i];
  const std::string text = fmt::format("{}  L {:.6g}", name, middle(rail.before));
  const Lettering line = along(a, b, 0, 0, text);
  const double angle = line.angle * std::numbers::pi / 180;
  const bool other_above = (far.y - a.y) * std::cos(angle) > (far.x - a.x) * std::sin(angle);
  return along(a, b, 0, other_above ? -1.4 * height : 0.4 * height, text);
}

std::vector<std::string> notes_of(const PlateSheet& sheet) {
  const Plate& plate = sheet.plate;
  const std::string& unit = sheet.unit.name;
  std::vector<std::string> notes{
      fmt::format("{}: {:.6g} x {:.6g} {}, seen from the side {} the normal", sheet.face.name, plate.width,
                  plate.height, unit, sheet.mirrored ? "opposite to" : "of"),
      fmt::format("outline within {} {}; length of C within {}, of D within {}", decimal_above(plate.deviation, 2),
                  unit, decimal_above(plate.c.error, 2), decimal_above(plate.d.error, 2))};
  if (plate.overlap.verdict == Truth::yes) notes.emplace_back("OVERLAPS ITSELF: cannot be cut from one sheet");
  if (plate.overlap.verdict == Truth::unknown) notes.emplace_back("THE OUTLINE TOUCHES ITSELF, or nearly so");
  return notes;
}

}  // namespace

double letter_height(const Plate& plate) {
  const double size = std::max(plate.width, plate.height);
  const double mean_ruling = plate.area_after.upper() / std::max(plate.c.after.upper(), plate.d.after.upper());
  return std::clamp(mean_ruling / 8, size / 400, size / 80);
}

std::vector<Lettering> letterings(const PlateSheet& sheet) {
  const Plate& plate = sheet.plate;
  const double height = letter_height(plate);
  std::vector<Lettering> list;
  for (std::size_t i = 0; i < plate.rulings.size(); ++i) {
    const PlateRuling& ruling = plate.rulings[i];
    list.push_back(
        along(plate.c.points[ruling.vertex], plate.d.points[ruling.vertex], 0.08, 0.4 * height, label_of(ruling, i)));
  }
  list.push_back(rail_lettering(plate.c, plate.d, "C", height));
  list.push_back(rail_lettering(plate.d, plate.c, "D", height));
  double y = -5 * height;
  for (const std::string& note : notes_of(sheet)) {
    list.push_back({{0, y}, 0, note});
    y -= 1.5 * height;
  }
  return list;
}

}  // namespace torse::cli
