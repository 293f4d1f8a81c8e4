// The units that STEP and IGES have names for.
#include "torse/cli/units.hpp"

#include <string_view>

#include "torse/cli/command.hpp"
#include "torse/io/text.hpp"

namespace torse::cli {
namespace {

struct NamedUnit {
  std::string_view name;
  std::string_view metres;
};

/// The inch is 25.4 mm by definition.
constexpr NamedUnit units[] = {{"mm", "1/1000"},   {"cm", "1/100"},      {"m", "1"},
                               {"km", "1000"},     {"um", "1/1000000"},  {"in", "127/5000"},
                               {"ft", "381/1250"}, {"mi", "201168/125"}, {"mil", "127/5000000"}};

}  // namespace

LengthUnit read_unit(const std::string& name) {
  std::string known;
  for (const NamedUnit& unit : units) {
    if (unit.name == name) return {name, Rational::from_text(unit.metres)};
    known += (known.empty() ? "" : ", ") + std::string(unit.name);
  }
  throw UsageError("--unit: expected one of " + known + ", found " + in_quotes(name));
}

LengthUnit millimetres() { return read_unit("mm"); }

LengthUnit metres() { return read_unit("m"); }

}  // namespace torse::cli
