// torse unroll: a developable surface, or a nearly developable one, as a flat plate with certified lengths.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "torse/cli/command.hpp"
#include "torse/cli/effort.hpp"
#include "torse/cli/plate_files.hpp"
#include "torse/cli/surface_report.hpp"
#include "torse/cli/terminal.hpp"
#include "torse/cli/warp.hpp"
#include "torse/io/file.hpp"
#include "torse/io/number.hpp"
#include "torse/io/text.hpp"

namespace torse::cli {
namespace {

/// The tolerance, as a share of the diagonal of the box around the control points, where none is asked for.
constexpr double default_share = 1e-5;

/// A tolerance below this share drowns in the rounding of coordinates to doubles.
constexpr double least_share = 1e-10;

/// Sizes between which squares and products of coordinates are doubles without over- or underflow.
constexpr double least_size = 1e-100;
constexpr double largest_size = 1e100;

/// As many parts as a plate may be marked in, and as many pieces as it may consist of: each takes a ruling at least.
constexpr int most_parts = 5'000;

/// The time of a ruling grows with the square of the degree: so many rulings are allowed for each, up to most_parts
/// + 1.
constexpr int most_rulings_times_squares = 450'000;

/// What the roots of the forms of all pieces may cost: effort_of the surface by degree^3 bits^2.
constexpr double most_effort = 0x1p40;

/// As many obstacles as a person reads.
constexpr std::size_t most_obstacles = 6;

struct UnrollOptions {
  FaceInput input;
  std::vector<std::string> outputs;
  std::string tolerance;
  int rulings = 10;
  std::string max_warp = "1deg";
  std::string unit;
  bool mirrored = false;
};

/// The writer for a file's name.
using Writer = std::string (*)(const PlateSheet&);

Writer writer_for(const std::string& output) {
  std::string extension = output == "-" ? ".json" : std::filesystem::path(output).extension().string();
  std::ranges::transform(extension, extension.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? c + 32 : c; });
  if (extension == ".json") return plate_json;
  if (extension == ".svg") return plate_svg;
  if (extension == ".dxf") return plate_dxf;
  throw UsageError("-o: expected a name that ends in .svg, .dxf or .json, or - for JSON, found " + in_quotes(output));
}

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

/// The diagonal of the box around the control points. Throws FileError for sizes that doubles cannot carry.
double size_of(const Face& face) {
  double square = 0;
  for (int j = 0; j < 3; ++j) {
    Rational low = face.surface->c.points.front()[j];
    Rational high = low;
    for (const auto* net : {&face.surface->c, &face.surface->d}) {
      for (const auto& point : net->points) {
        low = std::min(low, point[j]);
        high = std::max(high, point[j]);
      }
    }
    square = std::hypot(square, (high - low).to_double());
  }
  if (square >= least_size && square <= largest_size) return square;
  throw FileError(face.file, fmt::format("a plate of size {:.3g} cannot be written: expected {:g} to {:g}", square,
                                         least_size, largest_size));
}

double tolerance_of(const UnrollOptions& options, double size) {
  if (options.tolerance.empty()) return default_share * size;
  try {
    const double tolerance = parse_number<Rational>(options.tolerance).to_double();
    if (tolerance >= least_share * size && tolerance <= size) return tolerance;
    throw UsageError(fmt::format("--tolerance: expected {:.3g} to {:.3g} for a surface of size {:.6g}, found {}",
                                 least_share * size, size, size, options.tolerance));
  } catch (const BadNumber& bad) {
    throw UsageError(std::string("--tolerance: ") + bad.what());
  }
}

/// The unit of a CAD file, or that of --unit.
LengthUnit unit_of(const UnrollOptions& options, const Face& face) {
  const bool stated = face.cad && face.cad->metres > 0;
  if (options.unit.empty()) {
    return stated ? LengthUnit{face.cad->unit, Rational::from_double(face.cad->metres)} : millimetres();
  }
  if (stated) throw UsageError("--unit: the file states its own, " + face.cad->unit);
  return read_unit(options.unit);
}

/// What the surface is, and whether that lets it lie flat.
struct Flatness {
  Judgement judgement;
  Interval warp;
  Truth flat;
};

Flatness flatness_of(const RuledFile<Rational>& surface, const Angle& limit) {
  Judgement judgement = judge(surface);
  if (judgement.developable()) return {std::move(judgement), Interval(), Truth::yes};
  const WarpVerdict verdict = judge_warp(surface, limit);
  return {std::move(judgement), Interval::hull(verdict.enclosure.lower, verdict.enclosure.upper), verdict.within_limit};
}

Angle limit_of(const std::string& text) {
  Angle angle = read_angle(text);
  if (sine_squared_at_most_90(angle, 0).upper() > 0.5) {
    throw UsageError("--max-warp: expected at most 45 degrees, found " + in_quotes(text));
  }
  return angle;
}

/// Throws FileError for surfaces that would take too long.
void require_short_work(const Face& face) {
  if (const std::size_t pieces = face.surface->knots.proper_pieces().size(); pieces > most_parts) {
    throw FileError(face.file, fmt::format("expected at most {} pieces to unroll, found {}", most_parts, pieces));
  }
  if (const double effort = effort_of(*face.surface, 3, 2); effort > most_effort) {
    throw FileError(face.file,
                    fmt::format("expected a surface of effort 2^40 at most to unroll, found 2^{:.1f}: degree "
                                "{} with numbers of this length takes too long",
                                std::log2(effort), face.surface->knots.degree()));
  }
}

/// As many rulings as the development may take.
std::size_t most_stations(int degree) {
  return static_cast<std::size_t>(std::min(most_parts, most_rulings_times_squares / (degree * degree))) + 1;
}

std::string length_line(const char* name, const PlateRail& rail, const std::string& unit) {
  return fmt::format("  {}: length {:.12g} {}, drawn {:.12g}, difference of any part at most {:.3g}\n", name,
                     rail.before.lower(), unit, rail.after.lower(), rail.error);
}

std::string overlap_text(const Plate& plate) {
  const Overlap& overlap = plate.overlap;
  if (overlap.verdict == Truth::no) return "  no overlap\n";
  std::string text =
      overlap.verdict == Truth::yes ? "  the plate overlaps itself" : "  the outline touches itself, or nearly so";
  if (!overlap.meetings.empty()) {
    const PlatePoint& at = overlap.meetings.front().at;
    text += fmt::format(", near ({:.6g}, {:.6g})", at.x, at.y);
  }
  return text + '\n';
}

void print_sheet(const PlateSheet& sheet, const Terminal& terminal) {
  const Plate& plate = sheet.plate;
  const std::string& unit = sheet.unit.name;
  terminal.print(fmt::format("{}: {:.6g} x {:.6g} {}, {} vertices on each rail, {} rulings\n", title_of(sheet.face),
                             plate.width, plate.height, unit, plate.parameters.size(), plate.rulings.size()));
  terminal.print(length_line("C", plate.c, unit) + length_line("D", plate.d, unit));
  terminal.print(fmt::format("  rulings: lengths within {:.3g} {}; outline within {:.3g} {}\n", plate.ruling_error,
                             unit, plate.deviation, unit));
  if (!sheet.judgement.developable()) {
    terminal.print(
        fmt::format("  warp up to {:.4g} degrees: lengths inside the plate are up to {:.3g} of themselves too long\n",
                    sheet.warp.upper(), plate.stretch));
  }
  terminal.print(fmt::format("  area before [{:.12g}, {:.12g}], drawn {:.12g} {}^2\n", plate.area_before.lower(),
                             plate.area_before.upper(), plate.area_after.lower(), unit));
  const Paint paint = plate.overlap.verdict == Truth::no    ? Paint::good
                      : plate.overlap.verdict == Truth::yes ? Paint::bad
                                                            : Paint::doubtful;
  terminal.print(terminal.painted(paint, overlap_text(plate)));
}

int refuse(const Face& face, const std::string& reason, int code) {
  print_error(title_of(face) + ": " + reason);
  return code;
}

int code_of(Truth overlap) {
  if (overlap == Truth::unknown) return exit_code::undecided;
  return overlap == Truth::yes ? exit_code::refuted : exit_code::success;
}

int run_unroll(const UnrollOptions& options) {
  std::vector<Writer> writers;
  for (const std::string& output : options.outputs) writers.push_back(writer_for(output));
  const Angle limit = limit_of(options.max_warp);
  const Face face = face_of(options.input);
  const LengthUnit unit = unit_of(options, face);
  require_short_work(face);
  const std::size_t stations = most_stations(face.surface->knots.degree());
  if (static_cast<std::size_t>(options.rulings) >= stations) {
    throw UsageError(fmt::format("--rulings: expected at most {} for degree {}, found {}", stations - 1,
                                 face.surface->knots.degree(), options.rulings));
  }
  const double tolerance = tolerance_of(options, size_of(face));
  const RuledFile<Rational>& surface = *face.surface;

  Flatness flatness = flatness_of(surface, limit);
  if (flatness.flat != Truth::yes) {
    return refuse(
        face,
        fmt::format("not developable: the largest warp angle lies in [{:.6g}, {:.6g}] degrees, {} --max-warp {}",
                    flatness.warp.lower(), flatness.warp.upper(),
                    flatness.flat == Truth::no ? "more than" : "which does not decide", options.max_warp),
        flatness.flat == Truth::no ? exit_code::refuted : exit_code::undecided);
  }
  const std::vector<PieceStrip> strips = piece_strips(surface.knots, homogeneous(surface.c), homogeneous(surface.d));
  const std::vector<SingularSet> obstacles = find_obstacles(strips);
  if (!obstacles.empty()) {
    return refuse(face, "cannot lie flat as one plate: " + singular_text(obstacles, most_obstacles),
                  exit_code::refuted);
  }
  PlateSheet sheet{unroll_plate(strips, {.tolerance = tolerance,
                                         .marks = ruling_marks(surface.knots, strips, options.rulings),
                                         .warp_degrees = flatness.warp.upper(),
                                         .mirrored = options.mirrored,
                                         .stations = stations}),
                   face,
                   std::move(flatness.judgement),
                   flatness.warp,
                   unit,
                   tolerance,
                   options.mirrored};
  for (std::size_t i = 0; i < writers.size(); ++i) write_file(options.outputs[i], writers[i](sheet));
  const bool quiet = std::ranges::count(options.outputs, "-") > 0;
  if (!quiet) print_sheet(sheet, Terminal(stdout));
  return code_of(sheet.plate.overlap.verdict);
}

}  // namespace

std::function<int()> define_unroll(CLI::App& app) {
  const auto options = std::make_shared<UnrollOptions>();
  add_face_inputs(app, options->input, "a developable ruled surface");
  app.add_option("-o,--output", options->outputs, "the plate: .svg, .dxf or .json; - is JSON on standard output")
      ->required()
      ->type_name("FILE");
  app.add_option("--tolerance", options->tolerance, "how far the outline may be off, in the file's unit")
      ->type_name("LENGTH");
  app.add_option("--rulings", options->rulings, "parts between marked rulings")
      ->capture_default_str()
      ->check(CLI::Range(1, most_parts));
  app.add_option("--max-warp", options->max_warp, "unroll what is warped by at most ANGLE too")
      ->capture_default_str()
      ->type_name("ANGLE");
  app.add_option("--unit", options->unit,
                 "the unit of a file that states none: mm (default), cm, m, km, um, in, ft, mi, mil")
      ->type_name("UNIT");
  app.add_flag("--mirror", options->mirrored, "seen from the other side");
  return [options] { return run_unroll(*options); };
}

}  // namespace torse::cli
