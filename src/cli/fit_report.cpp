#include "torse/cli/fit_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "torse/cli/judge.hpp"
#include "torse/exact/decide/words.hpp"
#include "torse/exact/warp/words.hpp"

namespace torse::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string monotony_word(Monotony kind) {
  return kind == Monotony::strict ? "strict" : kind == Monotony::weak ? "weak" : "none";
}

Json numbers_json(const std::vector<Rational>& numbers) {
  Json list = Json::array();
  for (const Rational& x : numbers) list.push_back(x.text());
  return list;
}

Json mapping_json(const FittedStrip& strip) {
  Json json{{"degree", strip.sigma.knots.degree()},
            {"knots", numbers_json(strip.sigma.knots.list())},
            {"coefficients", numbers_json(coefficients(strip.sigma))},
            {"monotone", monotony_word(strip.monotony.kind)}};
  if (strip.monotony.witness) json["witness"] = strip.monotony.witness->text();
  json["change"] = strip.change.to_double();
  return json;
}

Json statistics_json(const quasi::WarpStatistics& warp) {
  return {{"mean_deg", warp.mean},
          {"rms_deg", warp.rms},
          {"max_deg", warp.max},
          {"folded", warp.folded},
          {"rulings", measured_rulings}};
}

Json fit_record(const quasi::Fit& fit) {
  Json stages = Json::array();
  for (const quasi::FitStage& stage : fit.stages) {
    stages.push_back({{"start", stage.start},
                      {"before_deg", stage.before},
                      {"after_deg", stage.after},
                      {"steps", stage.steps},
                      {"evaluations", stage.evaluations},
                      {"stop", stage.converged ? "converged" : "the steps ran out"}});
  }
  Json curve = Json::array();
  for (const quasi::FitStep& step : fit.curve) curve.push_back({step.seconds, step.value});
  Json json{{"stages", stages}, {"curve", curve}};
  if (fit.by_sides) json["regular_deg"] = *fit.by_sides;
  return json;
}

Json paper_record(const quasi::PaperFit& paper) {
  Json curve = Json::array();
  for (const quasi::PaperStep& step : paper.curve) curve.push_back({step.seconds, step.objective});
  return {{"objective", paper.objective},
          {"stop", paper.stop},
          {"converged", paper.converged},
          {"steps", paper.steps},
          {"evaluations", paper.evaluations},
          {"gradient_error", paper.gradient_error},
          {"curve", curve}};
}

/// A parameter of the surface from one of the first rail as the fit had it.
double own_parameter(const FittedStrip& strip, double t) {
  const KnotList<Rational>& u = strip.surface.knots;
  const Rational share = Rational::from_double((t - strip.range.from) / (strip.range.to - strip.range.from));
  return (u.domain_begin() + (u.domain_end() - u.domain_begin()) * share).to_double();
}

Json findings_json(const FittedStrip& strip) {
  Json list = Json::array();
  for (const quasi::Finding& finding : strip.findings) {
    Json json{{"from", own_parameter(strip, finding.from)},
              {"to", own_parameter(strip, finding.to)},
              {"obstacle", name_of(finding.obstacle)},
              {"mean_deg", finding.mean},
              {"max_deg", finding.max},
              {"best_deg", finding.best}};
    if (finding.extension > 0) json["extension"] = finding.extension;
    list.push_back(std::move(json));
  }
  return list;
}

std::string reason(const quasi::Finding& finding) {
  switch (finding.obstacle) {
    case quasi::Obstacle::tangents:
      return fmt::format("no ruling from there is developable, the best have {:.3g} degrees", finding.best);
    case quasi::Obstacle::beyond_begin:
      return fmt::format("developable rulings lead before the begin of the second rail, by {:.2g} % of its parameters",
                         100 * finding.extension);
    case quasi::Obstacle::beyond_end:
      return fmt::format("developable rulings lead behind the end of the second rail, by {:.2g} % of its parameters",
                         100 * finding.extension);
    case quasi::Obstacle::order:
      return "developable rulings from there would cross the good ones beside them";
    default:
      return "developable rulings in order exist there: try more coefficients or free ends";
  }
}

/// As many findings as a person reads.
constexpr std::size_t most_findings = 6;

std::string findings_text(const FittedStrip& strip) {
  std::string text;
  for (std::size_t i = 0; i < std::min(strip.findings.size(), most_findings); ++i) {
    const quasi::Finding& finding = strip.findings[i];
    text +=
        fmt::format("  u from {:.3g} to {:.3g}: warp up to {:.3g} degrees: {}\n", own_parameter(strip, finding.from),
                    own_parameter(strip, finding.to), finding.max, reason(finding));
  }
  if (strip.findings.size() > most_findings) {
    text += fmt::format("  and {} more parts with more than {:.3g} degrees\n", strip.findings.size() - most_findings,
                        strip.threshold);
  }
  return text;
}

/// What is known of folds: certified, or a ruling that folds over.
std::string folds_text(const FittedStrip& strip, const Terminal& terminal) {
  if (!strip.fold) {
    return "  certified: the normal turns by at most 90 degrees along every ruling, so there is no edge of "
           "regression\n";
  }
  std::string text = fmt::format("  {} between the rails, as at u = {:.6g}, and along {:.2g} % of the rulings",
                                 terminal.painted(Paint::bad, "folds over"), strip.fold->parameter.to_double(),
                                 100 * strip.after.folded);
  const bool other = strip.method.fit && strip.method.fit->by_sides;
  return text + (other ? fmt::format("; --regular: {:.6g} degrees\n", *strip.method.fit->by_sides) : "\n");
}

Json crossings_json(const SelfIntersection& crossings) {
  Json json{{"crosses", crossings.crosses == Truth::unknown ? Json() : Json(crossings.crosses == Truth::yes)}};
  if (const auto& at = crossings.witness) {
    json["first"] = {{"u", at->first}, {"v", at->first_share}};
    json["second"] = {{"u", at->second}, {"v", at->second_share}};
    json["distance"] = at->distance;
  }
  return json;
}

std::string crossings_text(const FittedStrip& strip, const Terminal& terminal) {
  const SelfIntersection& crossings = strip.crossings;
  if (crossings.crosses == Truth::no) return "  certified: no two rulings cross\n";
  if (crossings.crosses == Truth::unknown) {
    return fmt::format("  {}: whether rulings cross\n", terminal.painted(Paint::doubtful, "undecided"));
  }
  return fmt::format("  {}: the rulings of u = {:.6g} and u = {:.6g}\n", terminal.painted(Paint::bad, "crosses itself"),
                     crossings.witness->first, crossings.witness->second);
}

Json simplified_json(const Simplified& simplified) {
  return {
      {"distance", simplified.distance},
      {"exact",
       {{"degree", simplified.exact_degree}, {"pieces", simplified.exact_pieces}, {"points", simplified.exact_points}}},
      {"warp", statistics_json(simplified.warp)}};
}

std::string surface_text(const FittedStrip& strip) {
  const KnotList<Rational>& u = strip.surface.knots;
  std::string text = fmt::format("  surface: degree {}, {} pieces, {} points on each rail, ", u.degree(),
                                 u.proper_pieces().size(), u.last() + 1);
  if (!strip.simplified) return text + "exactly on both rails\n";
  const Simplified& simplified = *strip.simplified;
  text += fmt::format("certified: within {} of the exact one (degree {}, {} pieces, {} points)\n",
                      decimal_above(simplified.distance, 3), simplified.exact_degree, simplified.exact_pieces,
                      simplified.exact_points);
  text += fmt::format("  its own warp: mean {:.6g} degrees, sampled maximum {:.6g}\n", simplified.warp.mean,
                      simplified.warp.max);
  if (simplified.warp.max > strip.after.max + strip.threshold) {
    text += "  near points do not make near normals: a smaller --within keeps the warp\n";
  }
  return text;
}

/// Six digits, and no less than that for small angles.
std::string degrees_text(double x) { return fmt::format("{:.6g}", x); }

}  // namespace

nlohmann::ordered_json fit_json(const FitTitle& title, const FittedStrip& strip) {
  Json json{{"file", title.file},
            {"name", title.name},
            {"method", title.method},
            {"measure", title.measure},
            {"ends", title.ends},
            {"developable", !strip.certified},
            {"exact", !strip.simplified},
            {"mapping", mapping_json(strip)},
            {"before", statistics_json(strip.before)},
            {"after", statistics_json(strip.after)}};
  const WarpEnclosure warp = strip.certified ? strip.certified->enclosure : WarpEnclosure{};
  json["max_warp_deg"] = {{"lo", warp.lower}, {"hi", warp.upper}};
  const KnotList<Rational>& u = strip.surface.knots;
  json["surface"] = {{"degree", u.degree()}, {"pieces", u.proper_pieces().size()}, {"points", u.last() + 1}};
  if (strip.simplified) json["simplified"] = simplified_json(*strip.simplified);
  json["seconds"] = strip.method.seconds;
  Json folds{{"folded", strip.fold.has_value()}};
  if (strip.fold) folds["at"] = strip.fold->parameter.text();
  json["folds"] = folds;
  json["self_intersection"] = crossings_json(strip.crossings);
  if (!strip.trims.empty()) {
    const auto line = [](const TrimLine& trim) { return Json{{"c", trim.c.text()}, {"d", trim.d.text()}}; };
    json["trim"] = {{"begin", line(strip.trims[0])}, {"end", line(strip.trims[1])}};
  }
  if (strip.seam) json["seam"] = strip.seam->text();
  if (!strip.notes.empty()) json["notes"] = strip.notes;
  json["threshold_deg"] = strip.threshold;
  json["findings"] = findings_json(strip);
  if (strip.method.fit) json["fit"] = fit_record(*strip.method.fit);
  if (strip.method.paper) json["fit"] = paper_record(*strip.method.paper);
  return json;
}

std::string fit_text(const FitTitle& title, const FittedStrip& strip, const Terminal& terminal) {
  std::string text =
      fmt::format("{}: mean warp {} -> {} degrees, sampled maximum {} -> {}\n", title.file,
                  degrees_text(strip.before.mean), terminal.painted(Paint::good, degrees_text(strip.after.mean)),
                  degrees_text(strip.before.max), degrees_text(strip.after.max));
  text += strip.certified ? fmt::format("  certified: {}\n", describe(strip.certified->enclosure))
                          : fmt::format("  {}\n", terminal.painted(Paint::good, "exactly developable"));
  const std::string order = strip.monotony.kind == Monotony::strict ? "increases strictly"
                            : strip.monotony.kind == Monotony::weak ? "rests on a point of the second rail somewhere"
                                                                    : "decreases somewhere";
  text += fmt::format("  mapping: degree {}, {} coefficients, {}\n", strip.sigma.knots.degree(),
                      strip.sigma.control.size(), order);
  text += surface_text(strip);
  for (const TrimLine& trim : strip.trims) {
    text += fmt::format("  trim along the line from c({:.6g}) to d at the ruling of u = {:.6g}\n", trim.c.to_double(),
                        trim.d.to_double());
  }
  if (strip.seam) {
    text += fmt::format("  both rails are closed: d is taken from u = {:.6g} on, where the ends of c belong\n",
                        strip.seam->to_double());
  }
  for (const std::string& note : strip.notes) text += "  note: " + note + '\n';
  text += folds_text(strip, terminal) + crossings_text(strip, terminal);
  text += findings_text(strip);
  if (strip.method.paper)
    text += fmt::format("  L-BFGS: {} steps, {}\n", strip.method.paper->steps, strip.method.paper->stop);
  return text + fmt::format("  fitted in {:.3g} ms\n", 1000 * strip.method.seconds);
}

}  // namespace torse::cli
