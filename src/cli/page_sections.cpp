// Reports and pictures, put together for a page.
#include "torse/cli/page_sections.hpp"

#include <algorithm>
#include <utility>

#include "torse/cli/surface_picture.hpp"
#include "torse/cli/surface_report.hpp"
#include "torse/cli/terminal.hpp"

namespace torse::cli {
namespace {

using Json = nlohmann::ordered_json;

/// Fewer rulings for each of many surfaces: about a megabyte in all.
std::size_t rulings_for(std::size_t surfaces) {
  constexpr std::size_t in_all = 12'000;
  return std::clamp(in_all / std::max<std::size_t>(surfaces, 1), std::size_t{25}, std::size_t{241});
}

/// More surfaces than these are not drawn; their verdicts are in the list.
constexpr std::size_t most_pictures = 300;

std::string word_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::passed:
      return "passed";
    case Outcome::failed:
      return "failed";
    case Outcome::undecided:
      return "undecided";
    case Outcome::skipped:
      return "not ruled";
    case Outcome::error:
      return "unreadable";
  }
  return "";
}

Json verdict_json(const CheckedFace& checked, const ReportCase& c) {
  return {{"title", title_of(checked.face)},
          {"verdict", verdict_of(checked)},
          {"outcome", word_of(c.outcome)},
          {"findings", findings(checked)},
          {"replay", checked.replay}};
}

Json picture_of(const CheckedFace& checked, std::size_t rulings) {
  if (!checked.face.surface) return nullptr;
  const RuledFile<Rational>& surface = *checked.face.surface;
  return surface_picture(checked.face.name, surface, known_of(surface, checked.judgement->classification.kind),
                         rulings);
}

}  // namespace

Json check_section(const std::vector<CheckedFace>& faces, const std::vector<ReportCase>& cases, Json data) {
  const std::size_t rulings = rulings_for(faces.size());
  Json verdicts = Json::array();
  Json pictures = Json::array();
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (faces[i].error) continue;
    verdicts.push_back(verdict_json(faces[i], cases[i]));
    if (pictures.size() < most_pictures) pictures.push_back(picture_of(faces[i], rulings));
  }
  return {{"kind", "surfaces"}, {"data", std::move(data)}, {"verdicts", verdicts}, {"pictures", pictures}};
}

Json fit_section(const RailsFile<Rational>& rails, const FittedStrip& strip, Json data) {
  const UnitFrame frame = *unit_frame(rails.c.net, rails.d.net);
  Json picture{{"name", data["surfaces"][0]["name"]},
               {"size", short_number(frame.size)},
               {"net", strip.trims.empty() ? net_json(strip.surface, frame) : Json()},
               {"states", {state_json("T = t", strip.old_rulings), state_json("fitted", strip.rulings)}},
               {"singular", Json::array()}};
  return {{"kind", "fit"}, {"data", std::move(data)}, {"pictures", Json::array({std::move(picture)})}};
}

Json figures_section(const std::vector<figures::PaperFigure>& chosen, bool drawings) {
  constexpr std::size_t rulings = 81;
  Json list = Json::array();
  Json pictures = Json::array();
  for (const figures::PaperFigure& paper : chosen) {
    const figures::Figure figure = paper.draw();
    list.push_back({{"id", paper.id},
                    {"title", paper.title},
                    {"caption", figure.caption},
                    {"svg", drawings ? Json(figures::figure_svg(paper, figure)) : Json()}});
    Json surfaces = Json::array();
    for (const figures::FigureSurface& part : figure.surfaces) {
      const RuledFile<Rational> surface{part.surface.knots, dehomogenize<Rational, 4>(part.surface.c),
                                        dehomogenize<Rational, 4>(part.surface.d)};
      surfaces.push_back(surface_picture(part.name, surface, known_of(surface, part.kind), rulings));
    }
    pictures.push_back(std::move(surfaces));
  }
  return {{"kind", "figures"}, {"figures", list}, {"pictures", pictures}};
}

}  // namespace torse::cli
