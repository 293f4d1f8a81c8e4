// Formats by extension, and meshes.
#include "torse/cli/conversion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <utility>

#include "torse/cli/command.hpp"
#include "torse/cli/mesh.hpp"
#include "torse/cli/terminal.hpp"
#include "torse/exact/decide/words.hpp"
#include "torse/io/mesh_file.hpp"
#include "torse/io/text.hpp"

namespace torse::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Extension {
  const char* text;
  OutputFormat format;
};

constexpr Extension extensions[] = {
    {".json", OutputFormat::json}, {".step", OutputFormat::step}, {".stp", OutputFormat::step},
    {".iges", OutputFormat::iges}, {".igs", OutputFormat::iges},  {".obj", OutputFormat::obj},
    {".stl", OutputFormat::stl},   {".gltf", OutputFormat::gltf}, {".glb", OutputFormat::glb}};

/// The largest double that is not above x > 0.
double rounded_down(const Rational& x) {
  const double nearest = x.to_double();
  return !std::isfinite(nearest) || Rational::from_double(nearest) > x ? std::nextafter(nearest, 0.0) : nearest;
}

std::string mesh_bytes(const std::vector<NamedMesh>& meshes, OutputFormat format) {
  switch (format) {
    case OutputFormat::obj:
      return obj_text(meshes);
    case OutputFormat::stl:
      return stl_bytes(meshes);
    case OutputFormat::gltf:
      return gltf_text(meshes);
    default:
      return glb_bytes(meshes);
  }
}

}  // namespace

OutputFormat format_of(const std::string& file) {
  const std::string extension = extension_of(file);
  std::string known;
  for (const Extension& e : extensions) {
    if (extension == e.text) return e.format;
    known += (known.empty() ? "" : ", ") + std::string(e.text);
  }
  throw UsageError(fmt::format("--output: expected an extension among {}, found {}", known, in_quotes(file)));
}

bool is_written(std::string_view extension) {
  constexpr std::array<std::string_view, 6> others{".svg", ".dxf", ".html", ".csv", ".xml", ".sarif"};
  return std::ranges::any_of(extensions, [&](const Extension& e) { return extension == e.text; }) ||
         std::ranges::count(others, extension) > 0;
}

void require_json_name(const std::string& option, const std::string& file) {
  const std::string extension = extension_of(file);
  if (extension == ".json" || !is_written(extension)) return;
  throw UsageError(fmt::format("{}: expected a name for torse's JSON, found {}; torse convert writes other formats",
                               option, in_quotes(file)));
}

bool is_mesh(OutputFormat format) { return format != OutputFormat::json && !is_cad(format); }

bool is_cad(OutputFormat format) { return format == OutputFormat::step || format == OutputFormat::iges; }

RuledFile<Rational> scaled_surface(RuledFile<Rational> surface, const Rational& factor) {
  for (WeightedPoints<Rational, 3>* row : {&surface.c, &surface.d}) {
    for (Vec<Rational, 3>& x : row->points) scale(x, factor);
  }
  return surface;
}

Conversion convert_to_mesh(const std::vector<Face>& faces, OutputFormat format,
                           const std::optional<Rational>& tolerance) {
  const MeshPrecision precision =
      format == OutputFormat::obj ? MeshPrecision::double_float : MeshPrecision::single_float;
  Conversion conversion;
  std::vector<NamedMesh> meshes;
  for (const Face& face : faces) {
    try {
      const RuledArcs arcs = arcs_of(*face.surface);
      const double limit = tolerance ? rounded_down(*tolerance) : default_tolerance(arcs);
      meshes.push_back({face.name, mesh_surface(arcs, limit, precision)});
      const TriangleMesh& mesh = meshes.back().mesh;
      conversion.lines.push_back(fmt::format("{} triangles, at most {} from the surface", mesh.triangles.size(),
                                             decimal_above(mesh.deviation, 3)));
      conversion.faces.push_back(Json{{"mesh",
                                       {{"triangles", mesh.triangles.size()},
                                        {"points", mesh.points.size()},
                                        {"tolerance", limit},
                                        {"deviation", mesh.deviation}}}});
    } catch (const InvalidInput& invalid) {
      throw FileError(face.file, fmt::format("face {}: {}", in_quotes(face.name), invalid.what()));
    }
  }
  conversion.bytes = mesh_bytes(meshes, format);
  return conversion;
}

}  // namespace torse::cli
