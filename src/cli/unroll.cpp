// torse unroll: a developable surface, or a nearly developable one, as a flat plate with certified lengths.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "torse/cli/command.hpp"
#include "torse/cli/unrolling.hpp"
#include "torse/io/file.hpp"

namespace torse::cli {
namespace {

struct UnrollOptions {
  FaceInput input;
  std::vector<std::string> outputs;
  std::string unit;
  UnrollWishes wishes;
};

/// The one face to unroll.
Face face_of(const FaceInput& input) {
  if (input.files.size() != 1) throw UsageError("expected one FILE, found " + std::to_string(input.files.size()));
  std::vector<Face> faces = read_faces(input.files.front(), input.face);
  if (input.face.empty()) std::erase_if(faces, [](const Face& face) { return !face.surface; });
  if (faces.size() != 1) {
    throw FileError(input.files.front(),
                    fmt::format("expected one ruled face, found {}: choose one by --face", faces.size()));
  }
  if (!faces.front().surface) throw FileError(input.files.front(), "not ruled: " + faces.front().remark);
  return std::move(faces.front());
}

/// The unit of a CAD file, or that of --unit.
LengthUnit unit_of(const UnrollOptions& options, const Face& face) {
  if (options.unit.empty()) {
    return face.cad ? LengthUnit{face.cad->unit, Rational::from_double(face.cad->metres)} : millimetres();
  }
  if (face.cad) throw UsageError("--unit: the file states its own, " + face.cad->unit);
  return read_unit(options.unit);
}

int run_unroll(const UnrollOptions& options) {
  std::vector<PlateWriter> writers;
  for (const std::string& output : options.outputs) writers.push_back(plate_writer(output, "-o"));
  read_plate_warp(options.wishes.max_warp);
  const Face face = face_of(options.input);
  UnrollWishes wishes = options.wishes;
  wishes.unit = unit_of(options, face);
  const Unrolled result = unrolled(face, wishes);
  if (!result.sheet) {
    print_error(title_of(face) + ": " + result.refusal);
    return result.code;
  }
  for (std::size_t i = 0; i < writers.size(); ++i) write_file(options.outputs[i], writers[i](*result.sheet));
  if (std::ranges::count(options.outputs, "-") == 0) {
    const Terminal terminal(stdout);
    terminal.print(title_of(face) + ": " + plate_text(*result.sheet, terminal));
  }
  return result.code;
}

}  // namespace

std::function<int()> define_unroll(CLI::App& app) {
  const auto options = std::make_shared<UnrollOptions>();
  add_face_inputs(app, options->input, "a developable ruled surface");
  app.add_option("-o,--output", options->outputs,
                 "the plate: .svg, .dxf or .json; - is JSON on standard output; repeatable")
      ->required()
      ->type_name("FILE");
  app.add_option("--tolerance", options->wishes.tolerance, "how far the outline may be off, in the file's unit")
      ->type_name("LENGTH");
  app.add_option("--rulings", options->wishes.rulings, "parts between marked rulings")
      ->capture_default_str()
      ->check(CLI::Range(1, most_plate_parts));
  app.add_option("--max-warp", options->wishes.max_warp, "unroll what is warped by at most ANGLE too")
      ->capture_default_str()
      ->type_name("ANGLE");
  app.add_option("--unit", options->unit,
                 "the unit of a file that states none: mm (default), cm, m, km, um, in, ft, mi, mil")
      ->type_name("UNIT");
  app.add_flag("--mirror", options->wishes.mirrored, "seen from the other side");
  return [options] { return run_unroll(*options); };
}

}  // namespace torse::cli
