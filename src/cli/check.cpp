// torse check: whether ruled surfaces are developable, decided exactly, and of which class.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "torse/cli/command.hpp"
#include "torse/cli/judge.hpp"
#include "torse/cli/report_files.hpp"
#include "torse/cli/surface_report.hpp"
#include "torse/cli/terminal.hpp"
#include "torse/cli/warp.hpp"
#include "torse/io/file.hpp"
#include "torse/io/text.hpp"

namespace torse::cli {
namespace {

using Json = nlohmann::ordered_json;

struct CheckOptions {
  std::vector<std::string> files;
  std::string max_warp;
  ReportFiles reports;
};

/// One file: a surface with its judgement, or an error.
struct CheckedFile {
  std::string file;
  std::string replay;
  std::optional<RuledFile<Rational>> surface{};
  std::optional<Judgement> judgement{};
  WarpVerdict warp{};
  std::optional<FileError> error{};
  double seconds = 0;

  std::string name() const { return printable(file == "-" ? file : std::filesystem::path(file).stem().string()); }
};

CheckedFile check_file(const std::string& file, const CheckOptions& options, const std::optional<Angle>& max_warp) {
  std::vector<std::string> words{"torse", "check"};
  if (file.starts_with('-') && file != "-") words.push_back("--");
  words.push_back(file);
  if (!options.max_warp.empty()) words.insert(words.begin() + 2, {"--max-warp", options.max_warp});
  CheckedFile checked{.file = file, .replay = printable(command_line(words))};
  const auto start = std::chrono::steady_clock::now();
  try {
    const Document document(file, read_file(file));
    checked.surface = read_ruled<Rational>(document);
    checked.judgement = judge(*checked.surface);
    if (!checked.judgement->developable()) checked.warp = judge_warp(*checked.surface, max_warp);
  } catch (const FileError& error) {
    checked.error = error;
  }
  checked.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return checked;
}

/// Whether a file passes: without --max-warp a surface must be developable, with it the warp must not exceed the angle.
Outcome outcome_of(const CheckedFile& checked, const std::optional<Angle>& max_warp) {
  if (checked.error) return Outcome::error;
  if (checked.judgement->developable()) return Outcome::passed;
  if (!max_warp) return Outcome::failed;
  if (possibly(checked.warp.within_limit)) {
    return definitely(checked.warp.within_limit) ? Outcome::passed : Outcome::undecided;
  }
  return Outcome::failed;
}

int code_of(const std::vector<ReportCase>& cases) {
  const auto any = [&](Outcome outcome) { return std::ranges::count(cases, outcome, &ReportCase::outcome) > 0; };
  if (any(Outcome::error)) return exit_code::unusable;
  if (any(Outcome::failed)) return exit_code::refuted;
  return any(Outcome::undecided) ? exit_code::undecided : exit_code::success;
}

std::string message_of(const CheckedFile& checked, Outcome outcome) {
  if (checked.error) return checked.error->what();
  if (checked.judgement->developable()) return "developable: " + describe(checked.judgement->classification);
  const WarpEnclosure& warp = checked.warp.enclosure;
  return fmt::format("not developable: {}; the largest warp angle lies in [{}, {}] degrees{}",
                     describe(*checked.judgement->witness, checked.surface->knots), warp.lower, warp.upper,
                     outcome == Outcome::undecided ? ", which does not decide" : "");
}

ReportCase case_of(const CheckedFile& checked, Outcome outcome) {
  ReportCase c;
  c.suite = "check";
  c.name = checked.name();
  c.outcome = outcome;
  c.message = message_of(checked, outcome);
  c.replay = checked.replay;
  c.rule = checked.error ? "readable-input" : "developable";
  c.rule_text = checked.error ? "The file is a ruled surface in torse's JSON." : "The ruled surface is developable.";
  c.file = checked.file;
  c.seconds = checked.seconds;
  if (checked.error) {
    c.line = checked.error->line();
    c.column = checked.error->column();
  }
  return c;
}

Json surface_json(const CheckedFile& checked) {
  const Judgement& judgement = *checked.judgement;
  Json json{{"file", printable(checked.file)},
            {"name", checked.name()},
            {"developable", judgement.developable()},
            {"exact", true},
            {"class", name_of(judgement.classification.kind)}};
  if (judgement.classification.vertex) json["vertex"] = point_json(*judgement.classification.vertex);
  if (judgement.classification.direction) json["direction"] = point_json(*judgement.classification.direction);
  json["max_warp_deg"] = {{"lo", checked.warp.enclosure.lower}, {"hi", checked.warp.enclosure.upper}};
  Json exclusions = Json::array();
  for (const WarpExclusion& at : checked.warp.enclosure.exclusions) {
    exclusions.push_back({{"piece", at.piece}, {"from", at.lower.text()}, {"to", at.upper.text()}});
  }
  json["warp_excluded"] = std::move(exclusions);
  json["witness"] = judgement.witness ? witness_json(*judgement.witness, checked.surface->knots) : Json();
  const auto singular = judgement.developable() ? quick_singularities(*checked.surface) : std::nullopt;
  json["singular"] = singular ? singular_json(*singular) : Json();
  return json;
}

std::string json_report(const std::vector<CheckedFile>& files) {
  Json surfaces = Json::array();
  Json errors = Json::array();
  for (const CheckedFile& checked : files) {
    if (checked.error) {
      errors.push_back({{"file", printable(checked.file)}, {"message", checked.error->what()}});
    } else {
      surfaces.push_back(surface_json(checked));
    }
  }
  return Json{{"torse", 1}, {"surfaces", surfaces}, {"errors", errors}}.dump(2) + '\n';
}

std::string verdict_word(Outcome outcome, bool developable) {
  if (outcome == Outcome::undecided) return "undecided";
  return developable ? "developable" : "not developable";
}

void print_file(const Terminal& terminal, const CheckedFile& checked, const ReportCase& c, std::size_t width) {
  const bool developable = checked.judgement->developable();
  const Paint paint = c.outcome == Outcome::passed   ? Paint::good
                      : c.outcome == Outcome::failed ? Paint::bad
                                                     : Paint::doubtful;
  const std::string verdict = fmt::format("{:<15}", verdict_word(c.outcome, developable));
  const std::string detail = developable ? describe(checked.judgement->classification)
                                         : describe(*checked.judgement->witness, checked.surface->knots);
  terminal.print(
      fmt::format("{:<{}}  {}  {}\n", printable(checked.file), width, terminal.painted(paint, verdict), detail));
  if (c.outcome != Outcome::passed) {
    terminal.print(fmt::format("{:<{}}  {}\n", "", width, terminal.painted(Paint::dim, "replay: " + c.replay)));
  }
}

void print_summary(const Terminal& terminal, const std::vector<CheckedFile>& files) {
  const auto readable = std::ranges::count_if(files, [](const CheckedFile& f) { return !f.error; });
  const auto developable =
      std::ranges::count_if(files, [](const CheckedFile& f) { return !f.error && f.judgement->developable(); });
  terminal.print(
      fmt::format("{} of {} developable{}\n", developable, files.size(),
                  readable == std::ssize(files) ? "" : fmt::format(", {} unreadable", std::ssize(files) - readable)));
}

void print_files(const std::vector<CheckedFile>& files, const std::vector<ReportCase>& cases) {
  std::size_t width = 0;
  for (const CheckedFile& checked : files) {
    if (!checked.error) width = std::max(width, printable(checked.file).size());
  }
  const Terminal terminal(stdout);
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (!files[i].error) print_file(terminal, files[i], cases[i], width);
  }
  if (files.size() > 1) print_summary(terminal, files);
}

int run_check(const CheckOptions& options) {
  require_one_output(options.reports);
  std::optional<Angle> max_warp;
  if (!options.max_warp.empty()) max_warp = read_angle(options.max_warp);
  std::vector<CheckedFile> files;
  std::vector<ReportCase> cases;
  for (const std::string& file : options.files) {
    files.push_back(check_file(file, options, max_warp));
    cases.push_back(case_of(files.back(), outcome_of(files.back(), max_warp)));
    if (files.back().error) print_error(cases.back().message + "\n  replay: " + cases.back().replay);
  }
  if (!options.reports.use_stdout()) print_files(files, cases);
  if (!options.reports.json.empty()) write_file(options.reports.json, json_report(files));
  write_case_reports(options.reports, cases);
  return code_of(cases);
}

}  // namespace

std::function<int()> define_check(CLI::App& app) {
  const auto options = std::make_shared<CheckOptions>();
  app.add_option("FILE", options->files, "ruled surfaces in torse's JSON; - is standard input")->required();
  app.add_option("--max-warp", options->max_warp, "pass where the warp angle is at most ANGLE: 0.5, 0.5deg or 0.01rad")
      ->type_name("ANGLE");
  add_report_options(app, options->reports);
  return [options] { return run_check(*options); };
}

}  // namespace torse::cli
