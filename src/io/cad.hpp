// What a STEP or IGES file holds for torse, and the interface of the plugin that reads and writes them, in doubles and
// the standard library alone: the plugin (src/cad) is the only part of torse that knows OpenCASCADE.
//   CadRail, CadRails         two curves joined by rulings
//   CadExtrusion              a curve and a vector
//   CadRevolution             a straight line that turns about an axis
//   CadStrip                  one of these, cut to the face's parameters
//   CadFace, CadModel         the faces of a file
//   CadCurve, CadCurves       the curves of a file that bound no face
//   CadSheet, CadSheets       the ruled surfaces for a file
//   cad_out_of_memory         a reason
//   CadFormats                the plugin                     cad_entry      the name of the function that makes it
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "torse/io/limits.hpp"

namespace torse {

/// Coordinates in the unit of the file.
using CadPoint = std::array<double, 3>;

/// A closed interval of parameters.
struct CadRange {
  double from{};
  double to{};
};

/// A B-spline curve: the CAD list of knots (points + degree + 1 of them), control points, as many weights. `part` cuts
/// it to parameters of its own, none for the whole; then `reversed` turns it round.
struct CadRail {
  int degree = 1;
  std::vector<double> knots{};
  std::vector<CadPoint> points{};
  std::vector<double> weights{};
  std::optional<CadRange> part{};
  bool reversed = false;
};

/// The rulings join points of equal parameters, each relative to its own curve's domain. Degrees and knots may differ.
struct CadRails {
  CadRail c{};
  CadRail d{};
};

/// The rulings are translates of one vector: c + s vector, `across` being the range of s. With `end`, the vector leads
/// there from the begin of c.
struct CadExtrusion {
  CadRail c{};
  CadPoint vector{};
  std::optional<CadPoint> end{};
};

/// A point of a meridian: base + radius * radial + height * axis.
struct CadMeridianEnd {
  CadPoint base{};
  double radius = 0;
  double height = 0;
};

/// The segment between two points turns about the line through `origin` along `axis`, from the angle `turn.from` to
/// `turn.to` in radians. Kept as it is, since rotated points in doubles would lie on no cone or cylinder.
struct CadRevolution {
  CadPoint origin{};
  CadPoint axis{};
  CadPoint radial{};
  std::array<CadMeridianEnd, 2> meridian{};
  CadRange turn{};
};

/// A ruled surface. `along` cuts it to parameters of its first rail and `across` to a part of each ruling (0 at c, 1 at
/// d); none for the whole. A revolution is cut already.
struct CadStrip {
  std::variant<CadRails, CadExtrusion, CadRevolution> surface{};
  std::optional<CadRange> along{};
  std::optional<CadRange> across{};
};

/// An affine map x -> A x + b, its rows (A | b).
using CadPlacement = std::array<std::array<double, 4>, 3>;

/// The map that leaves everything where it is.
inline constexpr CadPlacement cad_identity{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

/// A face, or a surface that belongs to none.
struct CadFace {
  /// From 1, in the order of the file.
  int number = 0;
  /// As the file has it, empty for none.
  std::string name{};
  /// "plane", "cylinder", "cone", "extrusion", "revolution", "ruled surface", "B-spline surface", "sphere", ...
  std::string type{};
  /// The ruled surfaces that it consists of; none for one that is not ruled, and then `reason` says why.
  std::vector<CadStrip> strips{};
  std::string reason{};
  /// What is worth knowing beside the verdict.
  std::string remark{};
  /// The developable flag of an IGES ruled surface (entity 118).
  std::optional<bool> claimed_developable{};
  /// Whether the rulings of a ruled surface join points of equal relative arc length (entity 118, form 0).
  bool by_arc_length = false;
  /// Whether the face covers less than its surface.
  bool trimmed = false;
  CadPlacement placement = cad_identity;
};

/// A file. Lengths are in its own unit.
struct CadModel {
  /// "mm", "inch", ..., and the same in metres.
  std::string unit{};
  double metres = 0;
  /// The uncertainty that the file states, in its unit; 0 for none.
  double tolerance = 0;
  std::vector<CadFace> faces{};
};

/// A curve that bounds no face.
struct CadCurve {
  /// From 1, in the order of the file.
  int number = 0;
  /// As the file has it, empty for none.
  std::string name{};
  /// None for a curve that cannot be used, and then `reason` says why.
  std::optional<CadRail> rail{};
  std::string reason{};
  CadPlacement placement = cad_identity;
};

/// The curves of a file. Lengths are in its own unit, as in CadModel.
struct CadCurves {
  std::string unit{};
  double metres = 0;
  double tolerance = 0;
  std::vector<CadCurve> curves{};
};

/// A ruled surface to write: both rails over the same knots, whose ends are n + 1 times there, with positive weights;
/// the rulings join equal parameters.
struct CadSheet {
  std::string name{};
  CadRail c{};
  CadRail d{};
  /// The developable flag of an IGES ruled surface.
  bool developable = false;
  /// The corners of a polygon in the plane of the parameters (u, v) that bounds the face, v from 0 on c to 1 on d;
  /// empty for a face over all of the surface. For STEP.
  std::vector<std::array<double, 2>> outline{};
};

/// What a file is made of.
struct CadSheets {
  /// OpenCASCADE's name of the unit for STEP ("MM", "INCH", ...), the unit flag of IGES, and the unit in metres.
  std::string step_unit{};
  int iges_unit{};
  double metres{};
  /// In that unit, positive.
  double tolerance{};
  std::vector<CadSheet> sheets{};
};

/// The reason where the memory of limits.hpp does not suffice.
inline std::string cad_out_of_memory() {
  return "OpenCASCADE needs more than " + std::to_string(limits::cad_memory >> 20) + " MiB for it";
}

/// The formats of the plugin.
enum class CadFormat { step, iges };

/// The plugin. Nothing is thrown across this interface.
class CadFormats {
 public:
  virtual ~CadFormats() = default;
  /// "OpenCASCADE 7.6.3".
  virtual std::string version() const = 0;
  /// Reads a file. Returns what is wrong with it, or an empty text.
  virtual std::string read(CadFormat format, const std::string& path, CadModel& model) noexcept = 0;
  /// Reads the curves of a file, which may have none. Returns what is wrong with it, or an empty text.
  virtual std::string read_curves(CadFormat format, const std::string& path, CadCurves& curves) noexcept = 0;
  /// The first entity of a file that does not fit its definition, with what is wrong; empty for none.
  virtual std::string complaint(CadFormat format, const std::string& path) noexcept = 0;
  /// The bytes of a file. Every number reads back as the same double. Returns why there is none, or an empty text.
  virtual std::string write(CadFormat format, const CadSheets& sheets, std::string& bytes) noexcept = 0;
};

/// The symbol of the plugin, an extern "C" function of this type; the object lives as long as the plugin is loaded.
inline constexpr const char* cad_entry = "torse_cad_formats";
using CadEntry = CadFormats* (*)();

}  // namespace torse
