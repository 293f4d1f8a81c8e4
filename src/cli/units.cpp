// The units that STEP and IGES have names for.
#include "torse/cli/units.hpp"

#include <string_view>

#include "torse/cli/command.hpp"
#include "torse/io/text.hpp"

namespace torse::cli {
namespace {

struct Row {
  std::string_view name;
  std::string_view metres;
  std::string_view step_name;
  int iges_flag;
};

/// The inch is 25.4 mm by definition. Of two names the first is the one in reports.
constexpr Row units[] = {{"mm", "1/1000", "MM", 2},
                         {"cm", "1/100", "CM", 10},
                         {"m", "1", "M", 6},
                         {"km", "1000", "KM", 7},
                         {"um", "1/1000000", "UM", 9},
                         {"in", "127/5000", "INCH", 1},
                         {"ft", "381/1250", "FT", 4},
                         {"mi", "201168/125", "MI", 5},
                         {"mil", "127/5000000", "MIL", 8},
                         {"uin", "127/5000000000", "UIN", 11},
                         {"inch", "127/5000", "INCH", 1},
                         {"mile", "201168/125", "MI", 5}};

LengthUnit unit_of(const Row& row) {
  return {std::string(row.name), Rational::from_text(row.metres), std::string(row.step_name), row.iges_flag};
}

}  // namespace

LengthUnit read_unit(const std::string& name) {
  std::string known;
  for (const Row& row : units) {
    if (row.name == name) return unit_of(row);
    known += (known.empty() ? "" : ", ") + std::string(row.name);
  }
  throw UsageError("--unit: expected one of " + known + ", found " + in_quotes(name));
}

LengthUnit millimetres() { return read_unit("mm"); }

LengthUnit metres() { return read_unit("m"); }

std::optional<LengthUnit> unit_of_length(double metres) {
  for (const Row& row : units) {
    LengthUnit unit = unit_of(row);
    if (unit.metres.to_double() == metres) return unit;
  }
  return std::nullopt;
}

}  // namespace torse::cli
