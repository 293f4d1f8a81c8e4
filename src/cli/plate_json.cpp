// A plate with everything that is known of it.
#include <nlohmann/json.hpp>

#include "torse/cli/plate_files.hpp"
#include "torse/cli/surface_report.hpp"

namespace torse::cli {
namespace {

using Json = nlohmann::ordered_json;

Json interval_json(const Interval& x) { return {{"lo", x.lower()}, {"hi", x.upper()}}; }

Json point_json(const PlatePoint& p) { return {p.x, p.y}; }

Json rail_json(const PlateRail& rail) {
  Json points = Json::array();
  for (const PlatePoint& p : rail.points) points.push_back(point_json(p));
  return {{"points", std::move(points)},
          {"length",
           {{"before", interval_json(rail.before)}, {"after", interval_json(rail.after)}, {"error", rail.error}}}};
}

Json rulings_json(const Plate& plate) {
  Json list = Json::array();
  for (const PlateRuling& ruling : plate.rulings) {
    list.push_back({{"t", ruling.t.text()},
                    {"vertex", ruling.vertex},
                    {"length", interval_json(ruling.before)},
                    {"error", ruling.error},
                    {"bend_deg", ruling.bend}});
  }
  return list;
}

/// The part of the outline that an edge belongs to.
Json edge_json(const Plate& plate, std::size_t edge) {
  const std::size_t n = plate.parameters.size();
  const auto part = [&](const char* rail, std::size_t vertex) -> Json {
    return {{"rail", rail}, {"from", plate.parameters[vertex].text()}, {"to", plate.parameters[vertex + 1].text()}};
  };
  const auto ruling = [&](std::size_t vertex) -> Json {
    return {{"rail", nullptr}, {"from", plate.parameters[vertex].text()}, {"to", plate.parameters[vertex].text()}};
  };
  if (edge + 1 < n) return part("c", edge);
  if (edge + 1 == n) return ruling(n - 1);
  return edge + 1 < 2 * n ? part("d", 2 * n - 2 - edge) : ruling(0);
}

Json overlap_json(const Plate& plate) {
  Json meetings = Json::array();
  for (const Meeting& m : plate.overlap.meetings) {
    meetings.push_back({{"first", edge_json(plate, m.first)},
                        {"second", edge_json(plate, m.second)},
                        {"at", point_json(m.at)},
                        {"certain", m.certain}});
  }
  const Truth verdict = plate.overlap.verdict;
  return {{"verdict", verdict == Truth::unknown ? Json() : Json(verdict == Truth::yes)}, {"meetings", meetings}};
}

}  // namespace

std::string plate_json(const PlateSheet& sheet) {
  const Plate& plate = sheet.plate;
  Json parameters = Json::array();
  for (const Rational& t : plate.parameters) parameters.push_back(t.text());
  const Json json{{"torse", 1},
                  {"type", "plate"},
                  {"name", sheet.face.name},
                  {"unit", sheet.unit.name},
                  {"tolerance", sheet.tolerance},
                  {"mirrored", sheet.mirrored},
                  {"developable", sheet.judgement.developable()},
                  {"class", name_of(sheet.judgement.classification.kind)},
                  {"max_warp_deg", interval_json(sheet.warp)},
                  {"width", plate.width},
                  {"height", plate.height},
                  {"parameters", std::move(parameters)},
                  {"c", rail_json(plate.c)},
                  {"d", rail_json(plate.d)},
                  {"rulings", rulings_json(plate)},
                  {"error",
                   {{"vertex", plate.vertex_error},
                    {"boundary", plate.deviation},
                    {"ruling", plate.ruling_error},
                    {"inside", plate.stretch}}},
                  {"area", {{"before", interval_json(plate.area_before)}, {"after", interval_json(plate.area_after)}}},
                  {"overlap", overlap_json(plate)}};
  return json.dump(1) + '\n';
}

}  // namespace torse::cli
