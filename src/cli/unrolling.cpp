#include "torse/cli/unrolling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>
#include <vector>

#include "torse/cli/command.hpp"
#include "torse/cli/effort.hpp"
#include "torse/cli/surface_report.hpp"
#include "torse/exact/decide/words.hpp"
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

/// The time of a ruling grows with the square of the degree: so many rulings are allowed for each, up to
/// most_plate_parts
/// + 1.
constexpr int most_rulings_times_squares = 450'000;

/// As many obstacles as a person reads.
constexpr std::size_t most_obstacles = 6;

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

double tolerance_of(const std::string& text, double size) {
  if (text.empty()) return default_share * size;
  try {
    const double tolerance = parse_number<Rational>(text).to_double();
    if (tolerance >= least_share * size && tolerance <= size) return tolerance;
    throw UsageError(fmt::format("--tolerance: expected {:.3g} to {:.3g} for a surface of size {:.6g}, found {}",
                                 least_share * size, size, size, text));
  } catch (const BadNumber& bad) {
    throw UsageError(std::string("--tolerance: ") + bad.what());
  }
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

/// Throws FileError for surfaces that would take too long.
void require_short_work(const Face& face, double most_effort) {
  if (const std::size_t pieces = face.surface->knots.proper_pieces().size(); pieces > most_plate_parts) {
    throw FileError(face.file, fmt::format("expected at most {} pieces to unroll, found {}", most_plate_parts, pieces));
  }
  if (const double effort = effort_of(*face.surface, 3, 2); effort > most_effort) {
    throw FileError(face.file,
                    fmt::format("expected a surface of effort 2^{:.0f} at most to unroll, found 2^{:.1f}: degree "
                                "{} with numbers of this length takes too long",
                                std::log2(most_effort), std::log2(effort), face.surface->knots.degree()));
  }
}

/// As many rulings as the development may take.
std::size_t most_stations(int degree) {
  return static_cast<std::size_t>(std::min(most_plate_parts, most_rulings_times_squares / (degree * degree))) + 1;
}

std::string length_line(const char* name, const PlateRail& rail, const std::string& unit) {
  return fmt::format("  {}: length {:.12g} {}, drawn {:.12g}, difference of any part at most {}\n", name,
                     rail.before.lower(), unit, rail.after.lower(), decimal_above(rail.error, 3));
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

}  // namespace

PlateWriter plate_writer(const std::string& output, const char* option) {
  const std::string extension = output == "-" ? ".json" : extension_of(output);
  if (extension == ".json") return plate_json;
  if (extension == ".svg") return plate_svg;
  if (extension == ".dxf") return plate_dxf;
  throw UsageError(std::string(option) + ": expected a name that ends in .svg, .dxf or .json, or - for JSON, found " +
                   in_quotes(output));
}

Angle read_plate_warp(const std::string& text) {
  Angle angle = read_angle(text);
  if (sine_squared_at_most_90(angle, 0).upper() > 0.5) {
    throw UsageError("--max-warp: expected at most 45 degrees, found " + in_quotes(text));
  }
  return angle;
}

Unrolled unrolled(const Face& face, const UnrollWishes& wishes) {
  require_short_work(face, wishes.most_effort);
  const std::size_t stations = most_stations(face.surface->knots.degree());
  if (static_cast<std::size_t>(wishes.rulings) >= stations) {
    throw UsageError(fmt::format("--rulings: expected at most {} for degree {}, found {}", stations - 1,
                                 face.surface->knots.degree(), wishes.rulings));
  }
  const double tolerance = tolerance_of(wishes.tolerance, size_of(face));
  const RuledFile<Rational>& surface = *face.surface;

  Flatness flatness = flatness_of(surface, read_plate_warp(wishes.max_warp));
  if (flatness.flat != Truth::yes) {
    return {.refusal = fmt::format("not developable: the largest warp angle lies in [{}, {}] degrees, {} {}{}",
                                   decimal_below(flatness.warp.lower(), 6), decimal_above(flatness.warp.upper(), 6),
                                   flatness.flat == Truth::no ? "more than" : "which does not decide",
                                   wishes.limit_name, wishes.max_warp),
            .code = flatness.flat == Truth::no ? exit_code::refuted : exit_code::undecided};
  }
  const std::vector<PieceStrip> strips = piece_strips(surface.knots, homogeneous(surface.c), homogeneous(surface.d));
  const std::vector<SingularSet> obstacles = find_obstacles(strips);
  if (!obstacles.empty()) {
    return {.refusal = "cannot lie flat as one plate: " + singular_text(obstacles, most_obstacles),
            .code = exit_code::refuted};
  }
  std::optional<Plate> plate;
  try {
    plate = unroll_plate(strips, {.tolerance = tolerance,
                                  .marks = ruling_marks(surface.knots, strips, wishes.rulings),
                                  .warp_degrees = flatness.warp.upper(),
                                  .mirrored = wishes.mirrored,
                                  .stations = stations});
  } catch (const InvalidInput& invalid) {  // too fine a tolerance for this surface
    return {.refusal = invalid.what(), .code = exit_code::unusable};
  }
  PlateSheet sheet{.plate = *std::move(plate),
                   .face = face,
                   .judgement = std::move(flatness.judgement),
                   .warp = flatness.warp,
                   .unit = wishes.unit,
                   .tolerance = tolerance,
                   .mirrored = wishes.mirrored};
  const int code = plate_exit(sheet);
  return {.sheet = std::move(sheet), .code = code};
}

std::string plate_text(const PlateSheet& sheet, const Terminal& terminal) {
  const Plate& plate = sheet.plate;
  const std::string& unit = sheet.unit.name;
  std::string text = fmt::format("{:.6g} x {:.6g} {}, {} vertices on each rail, {} rulings\n", plate.width,
                                 plate.height, unit, plate.parameters.size(), plate.rulings.size());
  text += length_line("C", plate.c, unit) + length_line("D", plate.d, unit);
  text += fmt::format("  rulings: lengths within {} {}; outline within {} {}\n", decimal_above(plate.ruling_error, 3),
                      unit, decimal_above(plate.deviation, 3), unit);
  if (!sheet.judgement.developable()) {
    text += fmt::format("  warp up to {} degrees: lengths inside the plate are up to {} of themselves too long\n",
                        decimal_above(sheet.warp.upper(), 4), decimal_above(plate.stretch, 3));
  }
  text += fmt::format("  area before [{}, {}], drawn {:.12g} {}^2\n", decimal_below(plate.area_before.lower(), 12),
                      decimal_above(plate.area_before.upper(), 12), plate.area_after.lower(), unit);
  const Paint paint = plate.overlap.verdict == Truth::no    ? Paint::good
                      : plate.overlap.verdict == Truth::yes ? Paint::bad
                                                            : Paint::doubtful;
  return text + terminal.painted(paint, overlap_text(plate));
}

int plate_exit(const PlateSheet& sheet) {
  const Truth overlap = sheet.plate.overlap.verdict;
  if (overlap == Truth::unknown) return exit_code::undecided;
  return overlap == Truth::yes ? exit_code::refuted : exit_code::success;
}

}  // namespace torse::cli
