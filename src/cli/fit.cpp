// torse fit: the most developable ruled surface between two rails (BZZ19).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "torse/cli/command.hpp"
#include "torse/cli/conversion.hpp"
#include "torse/cli/fit_plate.hpp"
#include "torse/cli/fit_report.hpp"
#include "torse/cli/html_report.hpp"
#include "torse/cli/json_report.hpp"
#include "torse/cli/page_sections.hpp"
#include "torse/cli/rails.hpp"
#include "torse/cli/suggest.hpp"
#include "torse/cli/terminal.hpp"
#include "torse/io/file.hpp"
#include "torse/io/number.hpp"
#include "torse/io/text.hpp"

namespace torse::cli {
namespace {

using Json = nlohmann::ordered_json;

struct FitCommand {
  RailsInput input;
  std::vector<std::string> outputs;
  std::string method = "warp";
  std::string measure = "mean";
  std::string ends = "fixed";
  int degree = 2;
  int coefficients = 50;
  bool even_knots = false;
  bool regular = false;
  std::string picture;
  std::vector<std::string> plates;
  std::optional<std::string> extend;
  std::string within;
  std::string simplest = "points";
  std::string max_warp;
  std::string json;
  HtmlOption html;
};

/// The value that a word stands for. Throws UsageError listing the words.
template <class T, std::size_t N>
T choice(const char* option, const std::string& word, const std::array<std::pair<const char*, T>, N>& choices) {
  std::vector<std::string> words;
  for (const auto& [name, value] : choices) {
    if (word == name) return value;
    words.emplace_back(name);
  }
  throw UsageError(fmt::format("{}: expected {}, found {}{}", option, fmt::join(words, ", "), in_quotes(word),
                               suggestion(word, words)));
}

/// How far extended rails go on where --extend does not say it.
constexpr const char* usual_extension = "0.1";

Rational read_share(const std::string& text) {
  try {
    Rational share = parse_number<Rational>(text);
    if (share.sign() > 0 && share <= Rational(1)) return share;
    throw UsageError("--extend: expected a share above 0 and at most 1, found " + text);
  } catch (const BadNumber& bad) {
    throw UsageError(std::string("--extend: ") + bad.what());
  }
}

Rational read_length(const std::string& text) {
  try {
    Rational length = parse_number<Rational>(text);
    if (length.sign() > 0) return length;
    throw UsageError("--within: expected a length above 0, found " + text);
  } catch (const BadNumber& bad) {
    throw UsageError(std::string("--within: ") + bad.what());
  }
}

FitWishes wishes_of(const FitCommand& command) {
  constexpr std::array methods{std::pair{"warp", FitMethod::warp}, std::pair{"paper", FitMethod::paper},
                               std::pair{"discrete", FitMethod::discrete}, std::pair{"same", FitMethod::same}};
  constexpr std::array measures{std::pair{"mean", quasi::Measure::mean}, std::pair{"rms", quasi::Measure::rms},
                                std::pair{"max", quasi::Measure::max}};
  constexpr std::array ends{std::pair{"fixed", quasi::Ends::fixed}, std::pair{"free", quasi::Ends::free},
                            std::pair{"extended", quasi::Ends::free}};
  constexpr std::array simplest{std::pair{"knots", Simplest::knots}, std::pair{"degree", Simplest::degree},
                                std::pair{"points", Simplest::points}};
  FitWishes wishes;
  wishes.file = command.input.file;
  wishes.method = choice("--method", command.method, methods);
  wishes.options = {.degree = command.degree,
                    .coefficients = command.coefficients,
                    .measure = choice("--measure", command.measure, measures),
                    .kind = command.regular ? quasi::AngleKind::sides : quasi::AngleKind::planes,
                    .ends = choice("--ends", command.ends, ends),
                    .adaptive = !command.even_knots};
  if (command.coefficients < command.degree + 1) {
    throw UsageError(fmt::format("--coefficients: expected at least {} for degree {}, found {}", command.degree + 1,
                                 command.degree, command.coefficients));
  }
  if (!command.max_warp.empty()) wishes.max_warp = read_angle(command.max_warp);
  if (command.ends == "extended") {
    wishes.extension = read_share(command.extend.value_or(usual_extension));
  } else if (command.extend) {
    throw UsageError("--extend is for --ends extended");
  }
  const Simplest few = choice("--simplest", command.simplest, simplest);
  if (!command.within.empty()) wishes.within = {read_length(command.within), few};
  return wishes;
}

Face face_of(const FitCommand& command, const FittedStrip& strip) {
  return {.file = command.input.file, .name = name_of_file(command.input.file), .surface = strip.surface};
}

/// A CAD tolerance where the input states none.
constexpr double usual_tolerance = 1e-7;

/// glTF is in metres, a unit that STEP and IGES cannot name becomes millimetres; else the numbers keep their unit.
LengthUnit unit_of_output(OutputFormat format, const LengthUnit& unit) {
  if (format == OutputFormat::gltf || format == OutputFormat::glb) return metres();
  return is_cad(format) && unit.step_name.empty() ? millimetres() : unit;
}

/// The strip between the old ends of extended rails, in the parameters of the surface: along c, back along d.
std::vector<std::array<double, 2>> outline_of(const std::vector<TrimLine>& trims) {
  if (trims.empty()) return {};
  return {{trims[0].c.to_double(), 0},
          {trims[1].c.to_double(), 0},
          {trims[1].d.to_double(), 1},
          {trims[0].d.to_double(), 1}};
}

std::string bytes_of(const std::string& output, Face face, const InputRails& input,
                     const std::vector<TrimLine>& trims) {
  const OutputFormat format = output == "-" ? OutputFormat::json : format_of(output);
  if (format == OutputFormat::json) return write_ruled(*face.surface);
  const LengthUnit unit = unit_of_output(format, input.unit);
  const Rational factor = input.unit.metres / unit.metres;
  if (factor != Rational(1)) face.surface = scaled_surface(*std::move(face.surface), factor);
  if (is_mesh(format)) return convert_to_mesh({face}, format, std::nullopt).bytes;
  const double tolerance = input.tolerance > 0 ? input.tolerance * factor.to_double() : usual_tolerance;
  return convert_to_cad({face}, {format, unit, tolerance, std::nullopt, printable(output), outline_of(trims)}).bytes;
}

int code_of(const FitCommand& command, const FittedStrip& strip) {
  if (command.max_warp.empty() || !strip.certified) return exit_code::success;
  const Truth within = strip.certified->within_limit;
  return within == Truth::yes ? exit_code::success : within == Truth::no ? exit_code::refuted : exit_code::undecided;
}

std::vector<std::string> replay_words(const FitCommand& command) {
  std::vector<std::string> words{"torse",
                                 "fit",
                                 file_word(command.input.file),
                                 "--method",
                                 command.method,
                                 "--measure",
                                 command.measure,
                                 "--ends",
                                 command.ends,
                                 "--degree",
                                 std::to_string(command.degree),
                                 "--coefficients",
                                 std::to_string(command.coefficients)};
  if (command.ends == "extended") words.insert(words.end(), {"--extend", command.extend.value_or(usual_extension)});
  if (!command.within.empty()) {
    words.insert(words.end(), {"--within", command.within, "--simplest", command.simplest});
  }
  if (!command.input.c.empty()) words.insert(words.end(), {"--c", command.input.c, "--d", command.input.d});
  if (command.even_knots) words.emplace_back("--even-knots");
  if (command.regular) words.emplace_back("--regular");
  if (command.input.reverse) words.emplace_back("--reverse");
  if (!command.max_warp.empty()) words.insert(words.end(), {"--max-warp", command.max_warp});
  for (const std::string& output : command.outputs) words.insert(words.end(), {"-o", output});
  for (const std::string& plate : command.plates) words.insert(words.end(), {"--unroll", plate});
  return words;
}

int fit(const FitCommand& command, const FitWishes& wishes) {
  const InputRails input = read_input_rails(command.input);
  const FittedStrip strip = [&] {
    try {
      return fit_strip(input.rails, wishes);
    } catch (const InvalidInput& invalid) {
      throw FileError(command.input.file, invalid.what());
    }
  }();
  const Face face = face_of(command, strip);
  std::vector<std::string> bytes;
  for (const std::string& output : command.outputs) bytes.push_back(bytes_of(output, face, input, strip.trims));
  const std::optional<Unrolled> plate = fitted_plate(command.plates, face, input.unit);
  for (std::size_t i = 0; i < bytes.size(); ++i) write_file(command.outputs[i], bytes[i]);
  if (plate) write_plates(command.plates, *plate);

  const FitTitle title{printable(command.input.file), face.name, command.method, command.measure, command.ends};
  if (!command.picture.empty()) write_file(command.picture, fit_svg(title, strip));
  const bool stdout_taken = command.json == "-" || std::ranges::count(command.outputs, "-") > 0;
  const Terminal terminal(stdout_taken ? stderr : stdout);
  if (command.json != "-") {
    terminal.print(fit_text(title, strip, terminal));
    if (opposite(input.rails)) {
      terminal.print(
          command.input.reverse
              ? "  the rails run in opposite directions, it seems, because of --reverse\n"
              : "  the rails run in opposite directions, it seems: --reverse takes the second one from its end\n");
    }
    if (plate) terminal.print(fit_plate_text(*plate, terminal));
  }
  if (!command.json.empty() || command.html.wanted()) {
    Json entry = fit_json(title, strip);
    if (plate) entry["plate"] = fit_plate_json(command.plates, *plate);
    const Json report{{"torse", 1}, {"surfaces", {std::move(entry)}}, {"errors", Json::array()}};
    write_json(command.json, report);
    if (command.html.wanted()) {
      write_html(command.html, "Surface between two rails", Json::array({fit_section(input.rails, strip, report)}));
    }
  }
  const int code = code_of(command, strip);
  return plate ? exit_code::worse(code, plate->code) : code;
}

int run_fit(const FitCommand& command) {
  const FitWishes wishes = wishes_of(command);
  for (const std::string& output : command.outputs) {
    if (output != "-") format_of(output);
  }
  require_plate_files(command.plates);
  require_viewer(command.html);
  try {
    return fit(command, wishes);
  } catch (const FileError& error) {
    print_error(std::string(error.what()) + "\n  replay: " + printable(command_line(replay_words(command))));
    return exit_code::unusable;
  }
}

}  // namespace

std::function<int()> define_fit(CLI::App& app) {
  const auto command = std::make_shared<FitCommand>();
  app.add_option("RAILS", command->input.file,
                 "two curves: torse's JSON of type \"rails\", STEP or IGES; - is standard input")
      ->required();
  app.add_option("--c", command->input.c, "the first rail among the curves of a STEP or IGES file")
      ->type_name("NAME|NUMBER");
  app.add_option("--d", command->input.d, "the second rail")->type_name("NAME|NUMBER");
  app.add_option("-o,--output", command->outputs,
                 "the ruled surface: .json (- on standard output), .step, .iges, .obj, .stl, .gltf or .glb; repeatable")
      ->required()
      ->type_name("FILE");
  app.add_option("--method", command->method, "warp: ours; paper, discrete: those of BZZ19; same: T = t")
      ->capture_default_str();
  app.add_option("--measure", command->measure, "of the warp angle: mean, rms or max")->capture_default_str();
  app.add_option("--ends", command->ends,
                 "fixed: the rails' ends belong together; free: an end of the second rail may stay unused; extended: "
                 "rails go on beyond their ends, the strip is cut off at the old ones")
      ->capture_default_str();
  app.add_option("--extend", command->extend, "how far extended rails go on, as a share of their parameters")
      ->default_str(usual_extension)
      ->type_name("SHARE");
  app.add_option("--degree", command->degree, "of the mapping")->capture_default_str()->check(CLI::Range(1, 10));
  app.add_option("--coefficients", command->coefficients, "of the mapping")
      ->capture_default_str()
      ->check(CLI::Range(2, 10000));
  app.add_flag("--even-knots", command->even_knots, "evenly spaced knots of the mapping, not where the warp is");
  app.add_flag("--regular", command->regular,
               "count angles beyond 90 degrees, where the surface folds over, as what they are");
  app.add_flag("--reverse", command->input.reverse, "take the second rail from its end to its begin");
  CLI::Option* within = app.add_option("--within", command->within,
                                       "a simpler surface is enough, off by at most LENGTH in the rails' unit")
                            ->type_name("LENGTH");
  app.add_option("--simplest", command->simplest, "what it has few of: control points, knots or its degree is low")
      ->capture_default_str()
      ->type_name("points|knots|degree")
      ->needs(within);
  app.add_option("--max-warp", command->max_warp, "exit code 1 if the certified largest warp angle exceeds ANGLE")
      ->type_name("ANGLE");
  app.add_option("--svg", command->picture,
                 "draw the strip before and after, the mapping, the warp and the convergence")
      ->type_name("FILE");
  app.add_option("--unroll", command->plates,
                 "the surface as a flat plate, if its warp is at most 45 degrees: .svg, .dxf or .json; repeatable")
      ->type_name("FILE");
  app.add_option("--json", command->json, "write the report as JSON; - is standard output")->type_name("FILE");
  add_html_option(app, command->html);
  return [command] { return run_fit(*command); };
}

}  // namespace torse::cli
