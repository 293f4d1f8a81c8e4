// From the model of a CAD file to faces.
#include "torse/cli/cad_faces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "torse/cli/cad_process.hpp"
#include "torse/cli/cad_surface.hpp"
#include "torse/io/text.hpp"

namespace torse::cli {
namespace {

/// The first line and those of this width after it are an IGES file.
constexpr std::size_t iges_section_column = 72;

std::string_view without_blanks(std::string_view bytes) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos ? std::string_view() : bytes.substr(first);
}

CadNote note_of(const CadModel& model, const CadFace& face) {
  return {.unit = printable(model.unit),
          .metres = model.metres,
          .tolerance = model.tolerance,
          .type = printable(face.type),
          .trimmed = face.trimmed,
          .claimed_developable = face.claimed_developable};
}

Face face_of(const std::string& file, const CadModel& model, const CadFace& face) {
  return {.file = file,
          .name = face.name.empty() ? fmt::format("face {}", face.number) : printable(face.name),
          .number = static_cast<std::size_t>(face.number),
          .remark = printable(face.remark),
          .cad = note_of(model, face)};
}

/// The surface of a strip, or why there is none.
void set_surface(const CadFace& face, const CadStrip& strip, Face& result) {
  try {
    RuledFile<Rational> surface = surface_of(strip, face.placement);
    if (face.by_arc_length && !speeds_are_proportional(surface)) {
      result.remark =
          face.type + ": its rulings join points of equal relative arc length (form 0), which is no spline surface";
      return;
    }
    result.surface = std::move(surface);
  } catch (const InvalidInput& error) {
    throw FileError(result.file, fmt::format("face {} {}: {}", face.number, in_quotes(face.name), error.what()));
  }
}

void require_few(const std::string& file, const CadModel& model) {
  constexpr std::size_t most_surfaces = 100'000;
  std::size_t count = 0;
  for (const CadFace& face : model.faces) count += std::max<std::size_t>(face.strips.size(), 1);
  if (count > most_surfaces) {
    throw FileError(file, fmt::format("expected at most {} surfaces, found {}", most_surfaces, count));
  }
}

void append(const std::string& file, const CadModel& model, const CadFace& face, std::vector<Face>& faces) {
  if (face.strips.empty()) {
    faces.push_back(face_of(file, model, face));
    faces.back().remark = printable(face.type + (face.reason.empty() ? "" : ": " + face.reason));
    return;
  }
  for (std::size_t i = 0; i < face.strips.size(); ++i) {
    Face strip = face_of(file, model, face);
    if (face.strips.size() > 1) {
      strip.strip = i + 1;
      strip.name += fmt::format(" strip {}", strip.strip);
    }
    set_surface(face, face.strips[i], strip);
    faces.push_back(std::move(strip));
  }
}

}  // namespace

std::optional<CadFormat> cad_format(const std::string& file, std::string_view bytes) {
  bytes = without_byte_order_mark(bytes);
  const std::string_view text = without_blanks(bytes);
  if (text.starts_with("ISO-10303-21")) return CadFormat::step;
  const std::string_view line = bytes.substr(0, bytes.find_first_of("\r\n"));
  if (line.size() > iges_section_column && line.size() <= 80 &&
      line.find_first_not_of(" 0123456789", iges_section_column + 1) == std::string_view::npos) {
    const char section = line[iges_section_column];
    if (section == 'S') return CadFormat::iges;
    if (section == 'C') throw FileError(file, "compressed IGES: expected the form of fixed lines of 80 columns");
    if (section == 'B') throw FileError(file, "binary IGES: expected the form of fixed lines of 80 columns");
  }
  const std::string extension = extension_of(file);
  if (extension == ".step" || extension == ".stp" || extension == ".p21") {
    throw FileError(file,
                    "expected a STEP file that begins with ISO-10303-21;, found " + in_quotes(text.substr(0, 60)));
  }
  if (extension == ".igs" || extension == ".iges") {
    throw FileError(
        file, "expected an IGES file with S in column 73 of its first line, found " + in_quotes(line.substr(0, 100)));
  }
  return std::nullopt;
}

std::vector<Face> faces_of(const std::string& file, const CadModel& model) {
  require_few(file, model);
  std::vector<Face> faces;
  for (const CadFace& face : model.faces) append(file, model, face, faces);
  return faces;
}

std::vector<Face> cad_faces(const std::string& file, CadFormat format, const std::string& bytes) {
  return faces_of(file, read_cad(file, format, bytes));
}

}  // namespace torse::cli
