// Units of length.
//   LengthUnit      a name and its metres
//   read_unit       of the command line        unit_of_length      the unit that is so long
#pragma once

#include <optional>
#include <string>

#include "torse/exact/rational/rational.hpp"

namespace torse::cli {

/// A unit of length: its name ("mm", "in", ...), how many metres it has, exactly, what OpenCASCADE calls it in STEP,
/// and its flag in IGES.
struct LengthUnit {
  std::string name;
  Rational metres;
  std::string step_name{};
  int iges_flag = 0;
};

/// Millimetres, what numbers without a unit are taken to be in.
LengthUnit millimetres();

/// Metres.
LengthUnit metres();

/// The unit of this name: mm, cm, m, km, um, in, ft, mi, mil, uin. Throws UsageError naming --unit.
LengthUnit read_unit(const std::string& name);

/// The unit of which `metres` is the nearest double; none for another length.
std::optional<LengthUnit> unit_of_length(double metres);

}  // namespace torse::cli
