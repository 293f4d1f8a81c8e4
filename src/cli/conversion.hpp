// What torse convert makes of the faces of a file.
//   OutputFormat, format_of       by the extension          is_written, require_json_name     where there is one only
//   Conversion                    the bytes, and what there is to say about them
//   scaled_surface                in another unit
//   convert_to_mesh               OBJ, STL, glTF          convert_to_cad      STEP, IGES
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "torse/cli/faces.hpp"
#include "torse/cli/units.hpp"
#include "torse/cli/warp.hpp"

namespace torse::cli {

/// The formats of torse convert.
enum class OutputFormat { json, step, iges, obj, stl, gltf, glb };

/// The format that a file's extension names, in any case. Throws UsageError listing all of them.
OutputFormat format_of(const std::string& file);

/// Whether torse writes files of this extension, ".step", be they surfaces, plates, pages or reports.
bool is_written(std::string_view extension);

/// Throws UsageError where the name of a file for torse's JSON, or "-", ends like that of another format that torse
/// writes. `option` is where it was given.
void require_json_name(const std::string& option, const std::string& file);

/// Whether it holds triangles.
bool is_mesh(OutputFormat format);

/// Whether OpenCASCADE writes it.
bool is_cad(OutputFormat format);

/// The bytes of a file, a line for the terminal and a JSON object for each face, in order.
struct Conversion {
  std::string bytes;
  std::vector<std::string> lines;
  std::vector<nlohmann::ordered_json> faces;
};

/// Every coordinate times `factor`.
RuledFile<Rational> scaled_surface(RuledFile<Rational> surface, const Rational& factor);

/// Meshes of faces that are ruled, in the numbers' unit. Each is within `tolerance`, if there is one, else within its
/// own default. Throws FileError for a face that cannot be meshed.
Conversion convert_to_mesh(const std::vector<Face>& faces, OutputFormat format,
                           const std::optional<Rational>& tolerance);

/// What STEP and IGES files have beside surfaces.
struct CadWishes {
  OutputFormat format;
  /// Of the faces' numbers, and of the file.
  LengthUnit unit;
  /// In that unit.
  double tolerance{};
  /// Sets the developable flag of a surface that is not exactly developable as written, but whose warp is at most this.
  std::optional<Angle> max_warp{};
  /// The file's name, for errors.
  std::string file;
  /// Bounds every face: CadSheet::outline.
  std::vector<std::array<double, 2>> outline{};
};

/// Faces that are ruled as a CAD file. Throws FileError.
Conversion convert_to_cad(const std::vector<Face>& faces, const CadWishes& wishes);

}  // namespace torse::cli
