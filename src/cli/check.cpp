// torse check: whether ruled surfaces are developable, decided exactly, and of which class.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "torse/cli/checked.hpp"
#include "torse/cli/command.hpp"
#include "torse/cli/conversion.hpp"
#include "torse/cli/html_report.hpp"
#include "torse/cli/json_report.hpp"
#include "torse/cli/page_sections.hpp"
#include "torse/cli/repair.hpp"
#include "torse/cli/report_files.hpp"
#include "torse/cli/terminal.hpp"
#include "torse/io/text.hpp"

namespace torse::cli {
namespace {

using Json = nlohmann::ordered_json;

struct CheckOptions {
  FaceInput input;
  std::string max_warp;
  std::string repair;
  ReportFiles reports;
  HtmlOption html;

  /// Whether something else than the verdicts takes standard output.
  bool use_stdout() const { return reports.use_stdout() || repair == "-"; }
};

Demand demand_of(const CheckOptions& options) {
  if (options.max_warp.empty()) return {};
  return {options.max_warp, read_angle(options.max_warp)};
}

/// A run that judged nothing decides nothing.
int code_of(const std::vector<ReportCase>& cases) {
  const auto any = [&](Outcome outcome) { return std::ranges::count(cases, outcome, &ReportCase::outcome) > 0; };
  if (any(Outcome::error)) return exit_code::unusable;
  if (any(Outcome::failed)) return exit_code::refuted;
  return any(Outcome::undecided) || !any(Outcome::passed) ? exit_code::undecided : exit_code::success;
}

/// The surface that --repair is about. Throws UsageError unless it is the only one.
const CheckedFace& only_surface(const std::vector<CheckedFace>& faces) {
  const auto ruled = [](const CheckedFace& checked) { return checked.face.surface.has_value(); };
  const auto count = std::ranges::count_if(faces, ruled);
  if (count != 1) {
    throw UsageError(fmt::format("--repair: expected one ruled surface, found {}; --face chooses one", count));
  }
  return *std::ranges::find_if(faces, ruled);
}

/// What takes seconds to repair: control points of a rail times the degree.
constexpr long most_repair = 30'000;

/// Throws UsageError for a surface that is too large to repair. A developable one needs no search.
void require_repairable(const CheckedFace& checked) {
  const KnotList<Rational>& u = checked.face.surface->knots;
  if (checked.judgement->developable() || (u.last() + 1L) * u.degree() <= most_repair) return;
  throw UsageError(fmt::format("--repair: expected at most {} control points for degree {}, found {}",
                               most_repair / u.degree(), u.degree(), u.last() + 1));
}

/// The report on all faces; `repaired` belongs to the only one that is ruled.
Json report_of(const std::vector<CheckedFace>& faces, const std::optional<RepairedSurface>& repaired) {
  Json surfaces = Json::array();
  Json errors = Json::array();
  for (const CheckedFace& checked : faces) {
    if (checked.error) {
      errors.push_back({{"file", printable(checked.face.file)}, {"message", checked.error->what()}});
    } else {
      surfaces.push_back(checked_json(checked));
      if (repaired && checked.face.surface) surfaces.back()["repair"] = repair_json(*repaired);
    }
  }
  return {{"torse", 1}, {"surfaces", surfaces}, {"errors", errors}};
}

void print_face(const Terminal& terminal, const CheckedFace& checked, const ReportCase& c, std::size_t width) {
  const Paint paint = c.outcome == Outcome::passed   ? Paint::good
                      : c.outcome == Outcome::failed ? Paint::bad
                                                     : Paint::doubtful;
  const std::string verdict =
      fmt::format("{:<15}", c.outcome == Outcome::undecided ? "undecided" : verdict_of(checked));
  const std::vector<std::string> details = findings(checked);
  terminal.print(fmt::format("{:<{}}  {}  {}\n", title_of(checked.face), width, terminal.painted(paint, verdict),
                             details.front()));
  for (std::size_t i = 1; i < details.size(); ++i) {
    terminal.print(fmt::format("{:<{}}  {:<15}  {}\n", "", width, "", details[i]));
  }
  if (c.outcome != Outcome::passed && c.outcome != Outcome::skipped) {
    terminal.print(fmt::format("{:<{}}  {}\n", "", width, terminal.painted(Paint::dim, "replay: " + c.replay)));
  }
}

void print_summary(const Terminal& terminal, const std::vector<CheckedFace>& faces) {
  const auto developable = std::ranges::count_if(
      faces, [](const CheckedFace& f) { return f.judgement.has_value() && f.judgement->developable(); });
  const auto unreadable = std::ranges::count_if(faces, [](const CheckedFace& f) { return f.error.has_value(); });
  const auto judged = std::ranges::count_if(faces, [](const CheckedFace& f) { return f.judgement.has_value(); });
  const auto other = std::ssize(faces) - unreadable - judged;
  terminal.print(fmt::format("{} of {} developable{}{}\n", developable, faces.size(),
                             other == 0 ? "" : fmt::format(", {} not ruled", other),
                             unreadable == 0 ? "" : fmt::format(", {} unreadable", unreadable)));
}

void print_faces(const std::vector<CheckedFace>& faces, const std::vector<ReportCase>& cases) {
  std::size_t width = 0;
  for (const CheckedFace& checked : faces) {
    if (!checked.error) width = std::max(width, title_of(checked.face).size());
  }
  const Terminal terminal(stdout);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (!faces[i].error) print_face(terminal, faces[i], cases[i], width);
  }
  if (faces.size() > 1) print_summary(terminal, faces);
}

int run_check(const CheckOptions& options) {
  require_viewer(options.html);
  require_json_name("--repair", options.repair);
  const Demand demand = demand_of(options);
  std::vector<CheckedFace> faces;
  for (const std::string& file : options.input.files) {
    std::ranges::move(check_faces(file, options.input.face, demand), std::back_inserter(faces));
    if (faces.back().error) {
      print_error(std::string(faces.back().error->what()) + "\n  replay: " + faces.back().replay);
    }
  }
  std::vector<ReportCase> cases;
  cases.reserve(faces.size());
  for (const CheckedFace& checked : faces) cases.push_back(case_of(checked, demand));
  const int code = code_of(cases);
  std::optional<RepairedSurface> repaired;
  const bool repairs = !options.repair.empty() && code != exit_code::unusable;
  if (repairs) {
    const CheckedFace& only = only_surface(faces);
    require_repairable(only);
    repaired = repair_surface(*only.face.surface, options.repair);
  }
  if (!options.use_stdout()) print_faces(faces, cases);
  if (repaired && !options.use_stdout()) {
    Terminal(stdout).print(printable(options.repair) + ": " + repair_text(*repaired) + '\n');
  }
  if (!options.reports.json.empty() || options.html.wanted()) {
    const Json report = report_of(faces, repaired);
    write_json(options.reports.json, report);
    if (options.html.wanted()) {
      write_html(options.html, "Surfaces checked", Json::array({check_section(faces, cases, report)}));
    }
  }
  write_case_reports(options.reports, cases);
  if (repairs && !repaired) {
    print_error("--repair: no developable net with finite points was found; nothing is written");
    return exit_code::undecided;
  }
  return code;
}

}  // namespace

std::function<int()> define_check(CLI::App& app) {
  const auto options = std::make_shared<CheckOptions>();
  add_face_inputs(app, options->input, "ruled surfaces");
  app.add_option("--max-warp", options->max_warp, "pass where the warp angle is at most ANGLE: 0.5, 0.5deg or 0.01rad")
      ->type_name("ANGLE");
  app.add_option("--repair", options->repair, "write the nearest exactly developable net of the one surface given")
      ->type_name("OUT");
  add_report_options(app, options->reports);
  add_html_option(app, options->html);
  return [options] { return run_check(*options); };
}

}  // namespace torse::cli
