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
  const bool developable = checked.judgement->developable();
  const SurfaceClass kind = checked.judgement->classification.kind;
  const bool edge = developable && (kind == SurfaceClass::tangent || kind == SurfaceClass::cone);
  return surface_picture(checked.face.name, surface, edge, developable ? quick_singularities(surface) : std::nullopt,
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

}  // namespace torse::cli
