// Units of length.
//   LengthUnit      a name and its metres        read_unit      of the command line
#pragma once

#include <string>

#include "torse/exact/rational/rational.hpp"

namespace torse::cli {

/// A unit of length: its name ("mm", "in", ...) and how many metres it has, exactly.
struct LengthUnit {
  std::string name;
  Rational metres;
};

/// Millimetres, what numbers without a unit are taken to be in.
LengthUnit millimetres();

/// Metres.
LengthUnit metres();

/// The unit of this name: mm, cm, m, km, um, in, ft, mi, mil. Throws UsageError naming --unit.
LengthUnit read_unit(const std::string& name);

}  // namespace torse::cli
