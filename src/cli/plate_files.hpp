// A plate as a file: JSON for programs, SVG and DXF for people and machines.
//   PlateSheet                  a plate with what its files say about it
//   Lettering, letterings      what is written on a drawing
//   plate_json, plate_svg, plate_dxf
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "torse/cli/faces.hpp"
#include "torse/cli/judge.hpp"
#include "torse/cli/units.hpp"
#include "torse/exact/unroll/plate.hpp"

namespace torse::cli {

/// What is drawn, and what is told of it.
struct PlateSheet {
  Plate plate;
  Face face;
  Judgement judgement;
  Interval warp;  ///< degrees
  LengthUnit unit;
  double tolerance;
  bool mirrored;
};

/// A line of text that begins at a point, turned by degrees.
struct Lettering {
  PlatePoint at;
  double angle;
  std::string text;
};

/// The height of letters: a label fits a ruling of mean length, unless it could not be read.
double letter_height(const Plate& plate);

/// A label at each marked ruling ("R3  L 812.5", and the angle where the sheet is bent), the rails' names and lengths,
/// and notes below the plate.
std::vector<Lettering> letterings(const PlateSheet& sheet);

/// docs/formats.md.
std::string plate_json(const PlateSheet& sheet);
/// True scale: a user unit is a unit of the file. Groups "cut", "rulings", "bends", "text".
std::string plate_svg(const PlateSheet& sheet);
/// AutoCAD Release 12, ASCII. Layers CUT, RULINGS, BENDS, TEXT.
std::string plate_dxf(const PlateSheet& sheet);

}  // namespace torse::cli
