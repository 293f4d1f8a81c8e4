// The search is exact/repair; here its result becomes a file, JSON and a sentence.
#include "torse/cli/repair.hpp"

#include <fmt/format.h>

#include <utility>

#include "torse/cli/judge.hpp"
#include "torse/cli/surface_report.hpp"
#include "torse/cli/terminal.hpp"
#include "torse/exact/decide/words.hpp"
#include "torse/io/file.hpp"
#include "torse/io/text.hpp"

namespace torse::cli {
namespace {

using Json = nlohmann::ordered_json;

Json optional_number(const std::optional<double>& x) { return x ? Json(*x) : Json(); }

Json family_json(NetFamily family, int degree) {
  Json json{{"family", name_of(family)}};
  if (family == NetFamily::edge) json["degree"] = degree;
  return json;
}

Json families_json(const std::vector<FamilyDistance>& families) {
  Json list = Json::array();
  for (const FamilyDistance& family : families) {
    Json json = family_json(family.family, family.degree);
    json["rms_distance"] = family.root_mean_square;
    json["converged"] = family.converged;
    list.push_back(std::move(json));
  }
  return list;
}

Json segments_json(const std::vector<repair::RelationConstants>& segments) {
  Json list = Json::array();
  for (const repair::RelationConstants& each : segments) {
    list.push_back({{"from", each.from.text()},
                    {"to", each.to.text()},
                    {"Lambda", each.lambda.text()},
                    {"M", each.m.text()},
                    {"sigma", each.sigma.text()}});
  }
  return list;
}

}  // namespace

std::optional<RepairedSurface> repair_surface(const RuledFile<Rational>& surface, const std::string& file) {
  auto net = nearest_developable(surface.knots, {surface.c, surface.d});
  if (!net) return std::nullopt;
  const RuledFile<Rational> result{surface.knots, net->rows.c, net->rows.d};
  write_file(file, write_ruled(result));
  return RepairedSurface{file, std::move(*net), judge(result).classification};
}

Json repair_json(const RepairedSurface& repaired) {
  const auto& [file, net, classification] = repaired;
  Json json{{"file", printable(file)}, {"class", name_of(classification.kind)}};
  if (classification.vertex) json["vertex"] = point_json(*classification.vertex);
  if (classification.direction) json["direction"] = point_json(*classification.direction);
  json.update(family_json(net.family, net.degree));
  const bool single = net.constants.size() == 1;
  json["Lambda"] = single ? Json(net.constants.front().lambda.text()) : Json();
  json["M"] = single ? Json(net.constants.front().m.text()) : Json();
  json["sigma"] = single ? Json(net.constants.front().sigma.text()) : Json();
  if (net.family == NetFamily::segments) json["segments"] = segments_json(net.constants);
  json["max_distance"] = net.distance.largest;
  json["rms_distance"] = net.distance.root_mean_square;
  json["relative"] = net.distance.relative;
  json["surface_distance"] = optional_number(net.distance.surfaces);
  json["max_weight_change"] = net.distance.weights;
  json["ulps"] = optional_number(net.distance.ulps);
  json["ulps_of_largest"] = net.distance.ulps_of_largest;
  json["families"] = families_json(net.families);
  return json;
}

std::string repair_text(const RepairedSurface& repaired) {
  const NearestNet& net = repaired.net;
  std::string text = describe(repaired.classification);
  if (net.family == NetFamily::unchanged) return text + "; unchanged";
  if (net.constants.size() == 1) {
    const repair::RelationConstants& only = net.constants.front();
    text += fmt::format(", Lambda {}, M {}", short_number(only.lambda), short_number(only.m));
    if (only.sigma != Rational(1)) text += ", sigma " + short_number(only.sigma);
  }
  return text + fmt::format("; control points move by at most {}, {} of the surface's size{}",
                            decimal_above(net.distance.largest, 3), decimal_above(net.distance.relative, 3),
                            net.distance.ulps
                                ? fmt::format(", coordinates by {} ulps", decimal_above(*net.distance.ulps, 3))
                                : "");
}

}  // namespace torse::cli
