// The two rails of torse fit, from torse's JSON or from the curves of a STEP or IGES file.
//   RailsInput      the file, and which of its curves
//   InputRails, read_input_rails
//   opposite        whether they run in opposite directions
//   one_point, notes_on      what is unusual about them
#pragma once

#include <string>
#include <vector>

#include "torse/cli/units.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/io/spline_file.hpp"

namespace torse::cli {

/// A file, "-" being standard input. In a STEP or IGES file `c` and `d` choose the rails by name or number; where both
/// are empty they are the curves that are called c and d, or the only two that there are.
struct RailsInput {
  std::string file;
  std::string c{};
  std::string d{};
  bool reverse = false;  ///< takes d from its end to its begin
};

/// Rails with their unit: that of a CAD file, else the millimetre.
struct InputRails {
  RailsFile<Rational> rails;
  LengthUnit unit;
  double tolerance = 0;  ///< that a CAD file states, in its unit; 0 for none
};

/// Throws FileError; UsageError for a choice of curves in a file that is JSON.
InputRails read_input_rails(const RailsInput& input);

/// Whether the rails run in opposite directions, as far as the distances of their ends tell.
bool opposite(const RailsFile<Rational>& rails);

/// Whether all its control points are the same.
bool one_point(const CurveFile<Rational>& rail);

/// Lines on rails between which there is a cone, or nothing.
std::vector<std::string> notes_on(const RailsFile<Rational>& rails);

}  // namespace torse::cli
