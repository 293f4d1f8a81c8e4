// JSON and words for points, witnesses and singularities.
#include "torse/cli/surface_report.hpp"
#include "torse/exact/decide/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "torse/cli/function_report.hpp"
#include "torse/cli/terminal.hpp"
#include "torse/developable/classify.hpp"
#include "torse/io/text.hpp"

namespace torse::cli {
namespace {

using Json = nlohmann::ordered_json;
using Bound = SingularSet::Bound;

/// With so many bits in a cubic net, the singularities take about a quarter of a second.
constexpr std::size_t quick_bits = std::size_t{1} << 18;

/// Of knots, coordinates and weights.
std::size_t bits_of(const RuledFile<Rational>& surface) {
  std::size_t bits = 0;
  const auto count = [&](const Rational& x) { bits += x.numerator_bits() + x.denominator_bits(); };
  std::ranges::for_each(surface.knots.list(), count);
  for (const WeightedPoints<Rational, 3>* net : {&surface.c, &surface.d}) {
    for (const Vec<Rational, 3>& x : net->points) {
      for (int j = 0; j < 3; ++j) count(x[j]);
    }
    std::ranges::for_each(net->weights, count);
  }
  return bits;
}

Json bound_json(const Bound& bound) {
  if (bound.root.rational()) return bound.root.lower.text();
  return {{"lo", bound.root.lower.text()},
          {"hi", bound.root.upper.text()},
          {"zero_of", coefficients_json(integer_coefficients({bound.zero_of}).front())}};
}

std::string bound_text(const Bound& bound) {
  return bound.root.rational() ? short_number(bound.root.lower)
                               : fmt::format("about {:.6g}", bound.root.lower.to_double());
}

}  // namespace

Json face_json(const Face& face) {
  Json json{{"file", printable(face.file)},      {"name", face.name},      {"face", face.number},
            {"ruled", face.surface.has_value()}, {"developable", nullptr}, {"class", name_of(SurfaceClass::none)}};
  if (!face.remark.empty()) json["remark"] = face.remark;
  if (face.cad) {
    json["type"] = face.cad->type;
    json["trimmed"] = face.cad->trimmed;
    json["unit"] = face.cad->unit;
    json["unit_metres"] = face.cad->metres;
    if (face.cad->claimed_developable) json["claimed_developable"] = *face.cad->claimed_developable;
    json["tolerance"] = face.cad->tolerance > 0 ? Json(face.cad->tolerance) : Json();
  }
  return json;
}

Json point_json(const Vec<Rational, 3>& x) { return {x[0].text(), x[1].text(), x[2].text()}; }

Json witness_json(const DevelopabilityWitness<Rational>& witness, const KnotList<Rational>& knots) {
  return {{"piece", witness.piece},
          {"span", {knots.piece_begin(witness.piece).text(), knots.piece_end(witness.piece).text()}},
          {"coefficient", witness.coefficient},
          {"value", witness.value.text()}};
}

bool within_budget(const RuledFile<Rational>& surface, std::size_t most_bits) {
  constexpr std::size_t usual_degree = 3;
  const std::size_t degree = std::max(usual_degree, static_cast<std::size_t>(surface.knots.degree()));
  return bits_of(surface) * degree <= most_bits * usual_degree;
}

std::optional<std::vector<SingularSet>> quick_singularities(const RuledFile<Rational>& surface) {
  if (!within_budget(surface, quick_bits)) return std::nullopt;
  return find_singularities(recover_pieces<Rational>(surface.knots, homogeneous(surface.c), homogeneous(surface.d)));
}

Json singular_json(const std::vector<SingularSet>& sets) {
  Json list = Json::array();
  for (const SingularSet& set : sets) {
    list.push_back({{"reason", name_of(set.reason)}, {"from", bound_json(set.from)}, {"to", bound_json(set.to)}});
  }
  return list;
}

std::string singular_text(const std::vector<SingularSet>& sets, std::size_t most) {
  if (sets.empty()) return "regular: no singular point on the patch";
  std::string text;
  for (std::size_t i = 0; i < sets.size() && i < most; ++i) {
    const SingularSet& set = sets[i];
    const std::string where = set.point() ? bound_text(set.from) : bound_text(set.from) + " to " + bound_text(set.to);
    text += fmt::format("{}{} ({})", i == 0 ? "singular at t = " : ", ", where, name_of(set.reason));
  }
  if (sets.size() > most) text += fmt::format(" and {} more", sets.size() - most);
  return text;
}

}  // namespace torse::cli
