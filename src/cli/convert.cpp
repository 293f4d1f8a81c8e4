// torse convert: the ruled faces of a file in another format.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "torse/cli/command.hpp"
#include "torse/cli/conversion.hpp"
#include "torse/cli/faces.hpp"
#include "torse/cli/json_report.hpp"
#include "torse/cli/terminal.hpp"
#include "torse/cli/units.hpp"
#include "torse/cli/warp.hpp"
#include "torse/io/file.hpp"
#include "torse/io/number.hpp"
#include "torse/io/text.hpp"

namespace torse::cli {
namespace {

using Json = nlohmann::ordered_json;

struct ConvertOptions {
  std::string input;
  std::string output;
  std::string face;
  std::string unit;
  std::string tolerance;
  std::string max_warp;
  std::string json;
};

/// The options as a user has to give them for this format.
struct Wanted {
  OutputFormat format;
  std::optional<LengthUnit> unit;
  std::optional<Rational> tolerance;
  std::optional<Angle> max_warp;
};

/// OpenCASCADE's own, for files that state none.
constexpr double usual_tolerance = 1e-7;

std::optional<Rational> read_tolerance(const std::string& text) {
  if (text.empty()) return std::nullopt;
  try {
    Rational length = parse_number<Rational>(text);
    if (length.sign() <= 0) throw UsageError("--tolerance: expected a length above 0, found " + text);
    return length;
  } catch (const BadNumber& bad) {
    throw UsageError(std::string("--tolerance: ") + bad.what());
  }
}

Wanted wanted_by(const ConvertOptions& options) {
  Wanted wanted{format_of(options.output), std::nullopt, read_tolerance(options.tolerance), std::nullopt};
  if (!options.unit.empty()) wanted.unit = read_unit(options.unit);
  if (wanted.tolerance && !is_mesh(wanted.format))
    throw UsageError("--tolerance is for meshes: .obj, .stl, .gltf, .glb");
  if (!options.max_warp.empty()) wanted.max_warp = read_angle(options.max_warp);
  if (wanted.max_warp && wanted.format != OutputFormat::iges) {
    throw UsageError("--max-warp is for the developable flag of IGES: .iges, .igs");
  }
  if (wanted.unit && wanted.format == OutputFormat::json) throw UsageError("--unit: torse's JSON has no unit");
  return wanted;
}

std::vector<std::string> replay_words(const ConvertOptions& options) {
  std::vector<std::string> words{"torse", "convert"};
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) words.insert(words.end(), {name, value});
  };
  add("--unit", options.unit);
  add("--tolerance", options.tolerance);
  add("--max-warp", options.max_warp);
  add("-o", options.output);
  std::ranges::move(words_of(options.input, options.face), std::back_inserter(words));
  return words;
}

std::vector<Face> ruled_faces(const std::vector<Face>& faces) {
  std::vector<Face> ruled;
  std::ranges::copy_if(faces, std::back_inserter(ruled), [](const Face& face) { return face.surface.has_value(); });
  if (ruled.empty()) {
    const Face& first = faces.front();
    throw FileError(first.file, faces.size() == 1 ? "is not ruled: " + first.remark
                                                  : fmt::format("none of its {} faces is ruled", faces.size()));
  }
  return ruled;
}

Conversion convert_to_json(const std::vector<Face>& faces) {
  if (faces.size() > 1) {
    throw FileError(faces.front().file,
                    fmt::format("has {} ruled faces; torse's JSON holds one: choose it by --face", faces.size()));
  }
  return {write_ruled(*faces.front().surface), {"exact"}, {Json::object()}};
}

/// The unit of the faces' numbers, which all have the same: that of the CAD file, else the one asked for.
Rational metres_of(const std::vector<Face>& faces, const Wanted& wanted) {
  const std::optional<CadNote>& cad = faces.front().cad;
  if (!cad) return wanted.unit.value_or(millimetres()).metres;
  const std::optional<LengthUnit> known = unit_of_length(cad->metres);
  return known ? known->metres : Rational::from_double(cad->metres);
}

/// glTF is in metres; elsewhere the numbers keep their unit unless another is asked for. A unit without a name becomes
/// millimetres.
LengthUnit unit_of_output(const std::vector<Face>& faces, const Wanted& wanted) {
  if (wanted.format == OutputFormat::gltf || wanted.format == OutputFormat::glb) return metres();
  if (wanted.unit) return *wanted.unit;
  return faces.front().cad ? unit_of_length(faces.front().cad->metres).value_or(millimetres()) : millimetres();
}

Conversion convert_faces(std::vector<Face> faces, const Wanted& wanted, const std::string& output) {
  if (wanted.format == OutputFormat::json) return convert_to_json(faces);
  const LengthUnit unit = unit_of_output(faces, wanted);
  const Rational factor = metres_of(faces, wanted) / unit.metres;
  if (factor != Rational(1)) {
    for (Face& face : faces) face.surface = scaled_surface(std::move(*face.surface), factor);
  }
  if (is_mesh(wanted.format)) return convert_to_mesh(faces, wanted.format, wanted.tolerance);
  const double stated = faces.front().cad ? faces.front().cad->tolerance * factor.to_double() : 0;
  return convert_to_cad(
      faces, {wanted.format, unit, stated > 0 ? stated : usual_tolerance, wanted.max_warp, printable(output)});
}

Json report_of(const ConvertOptions& options, const std::vector<Face>& faces, const Conversion& conversion) {
  Json surfaces = Json::array();
  auto written = conversion.faces.begin();
  for (const Face& face : faces) {
    Json json{{"file", printable(face.file)},
              {"name", face.name},
              {"face", face.number},
              {"ruled", face.surface.has_value()}};
    if (face.surface) {
      json.update(*written++);
    } else {
      json["remark"] = face.remark;
    }
    surfaces.push_back(std::move(json));
  }
  return {{"torse", 1}, {"output", printable(options.output)}, {"surfaces", surfaces}};
}

void print_faces(const ConvertOptions& options, const std::vector<Face>& faces, const Conversion& conversion) {
  const Terminal terminal(stdout);
  auto line = conversion.lines.begin();
  for (const Face& face : faces) {
    const std::string text =
        face.surface ? *line++ : terminal.painted(Paint::doubtful, "not ruled, left out") + ": " + face.remark;
    terminal.print(fmt::format("{}: {}: {}\n", printable(options.output), face.name, text));
  }
}

int convert(const ConvertOptions& options, const Wanted& wanted) {
  const std::vector<Face> faces = read_faces(options.input, options.face);
  const Conversion conversion = convert_faces(ruled_faces(faces), wanted, options.output);
  write_file(options.output, conversion.bytes);
  if (options.json != "-") print_faces(options, faces, conversion);
  write_json(options.json, report_of(options, faces, conversion));
  return exit_code::success;
}

int run_convert(const ConvertOptions& options) {
  const Wanted wanted = wanted_by(options);
  try {
    return convert(options, wanted);
  } catch (const FileError& error) {
    print_error(std::string(error.what()) + "\n  replay: " + printable(command_line(replay_words(options))));
    return exit_code::unusable;
  }
}

}  // namespace

std::function<int()> define_convert(CLI::App& app) {
  const auto options = std::make_shared<ConvertOptions>();
  app.add_option("FILE", options->input, "ruled surfaces; - is standard input")->required();
  app.add_option("-o,--output", options->output, "the file to write: .json, .step, .iges, .obj, .stl, .gltf or .glb")
      ->type_name("OUT")
      ->required();
  app.add_option("--face", options->face, "only the face of this name or number")->type_name("NAME|NUMBER");
  app.add_option("--unit", options->unit,
                 "of the numbers in OUT, and of those in a JSON file: mm (default), cm, m, in, ...")
      ->type_name("UNIT");
  app.add_option("--tolerance", options->tolerance, "the largest distance of a mesh from its surface")
      ->type_name("LENGTH");
  app.add_option("--max-warp", options->max_warp,
                 "IGES: flag surfaces as developable whose warp angle is at most ANGLE, not only exact ones")
      ->type_name("ANGLE");
  app.add_option("--json", options->json, "write what was done as JSON; - is standard output")->type_name("FILE");
  return [options] { return run_convert(*options); };
}

}  // namespace torse::cli
