// Pictures of ruled surfaces.
#include "torse/cli/surface_picture.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "torse/algebra/determinant.hpp"
#include "torse/cli/fitting.hpp"
#include "torse/cli/surface_report.hpp"
#include "torse/exact/decide/words.hpp"
#include "torse/quasi/ruling_angle.hpp"
#include "torse/scalar/errors.hpp"

namespace torse::cli {
namespace {

using Json = nlohmann::ordered_json;
using quasi::RailJet;
using quasi::Rails;
using quasi::SampledRuling;
using quasi::Vector;

/// More points in a row are not drawn as a net, and are sampled no more: exact Bezier pieces take seconds from here on.
constexpr std::size_t most_net_points = 1000;
constexpr std::size_t most_picture_points = 5000;
constexpr std::size_t most_picture_bits = std::size_t{1} << 22;

/// A ruling with an end farther away, in sizes of the control net, is left out: the rail goes to infinity there.
constexpr double farthest = 2;

/// Six decimals: a millionth of the surface's size.
double rounded(double x) {
  const double y = std::round(x * 1e6) / 1e6;
  return y == 0 ? 0 : y;
}

Json finite_json(double x) { return std::isfinite(x) ? Json(rounded(x)) : Json(); }

Vec<Rational, 3> in_frame(const Vec<Rational, 3>& x, const UnitFrame& frame) {
  Vec<Rational, 3> y;
  for (int j = 0; j < 3; ++j) y[j] = (x[j] - frame.middle[j]) / frame.size;
  return y;
}

Json row_json(const WeightedPoints<Rational, 3>& row, const UnitFrame& frame) {
  Json points = Json::array();
  Json weights = Json::array();
  for (const Vec<Rational, 3>& x : row.points) {
    const Vec<Rational, 3> y = in_frame(x, frame);
    for (int j = 0; j < 3; ++j) points.push_back(rounded(y[j].to_double()));
  }
  for (const Rational& weight : row.weights) weights.push_back(weight.to_double());
  return {{"points", points}, {"weights", weights}};
}

/// Whether the ruling can be drawn.
bool within_reach(const SampledRuling& ruling) {
  return ruling.c.lpNorm<Eigen::Infinity>() <= farthest && ruling.d.lpNorm<Eigen::Infinity>() <= farthest;
}

Json ruling_json(const SampledRuling& ruling) {
  if (!within_reach(ruling)) return nullptr;
  Json list = Json::array();
  for (const Vector& x : {ruling.c, ruling.d}) {
    for (int j = 0; j < 3; ++j) list.push_back(rounded(x[j]));
  }
  return list;
}

/// Rulings at evenly spread parameters, both ends included.
std::vector<SampledRuling> even_rulings(const Rails& rails, std::size_t count) {
  std::vector<SampledRuling> rulings;
  rulings.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(count - 1);
    const RailJet c = rails.c(t);
    const RailJet d = rails.d(t);
    const double angle = quasi::ruling_angle(c, d, quasi::AngleKind::planes).angle.value;
    rulings.push_back({t, t, c.point, d.point, std::abs(angle) * 180 / std::numbers::pi});
  }
  return rulings;
}

/// The edge on each ruling.
std::vector<std::optional<double>> edge_of(const Rails& rails, const std::vector<SampledRuling>& rulings) {
  std::vector<std::optional<double>> edge;
  edge.reserve(rulings.size());
  for (const SampledRuling& ruling : rulings) edge.push_back(edge_position(rails.c(ruling.t), rails.d(ruling.target)));
  return edge;
}

Json singular_picture(const std::vector<SingularSet>& sets, const KnotList<Rational>& u) {
  const Rational begin = u.domain_begin();
  const Rational length = u.domain_end() - begin;
  const auto place = [&](const SingularSet::Bound& bound) {
    return rounded(Rational((bound.root.lower - begin) / length).to_double());
  };
  Json list = Json::array();
  for (const SingularSet& set : sets) {
    list.push_back({{"reason", name_of(set.reason)}, {"from", place(set.from)}, {"to", place(set.to)}});
  }
  return list;
}

RuledFile<Rational> in_unit_cube(RuledFile<Rational> surface, const UnitFrame& frame) {
  for (WeightedPoints<Rational, 3>* row : {&surface.c, &surface.d}) {
    for (Vec<Rational, 3>& x : row->points) x = in_frame(x, frame);
  }
  return surface;
}

}  // namespace

std::optional<UnitFrame> unit_frame(const WeightedPoints<Rational, 3>& c, const WeightedPoints<Rational, 3>& d) {
  Vec<Rational, 3> low = c.points.front();
  Vec<Rational, 3> high = low;
  for (const auto* row : {&c, &d}) {
    for (const Vec<Rational, 3>& x : row->points) {
      for (int j = 0; j < 3; ++j) {
        low[j] = std::min(low[j], x[j]);
        high[j] = std::max(high[j], x[j]);
      }
    }
  }
  UnitFrame frame{.middle = low, .size = Rational(0)};
  for (int j = 0; j < 3; ++j) {
    frame.middle[j] = (low[j] + high[j]) / Rational(2);
    frame.size = std::max(frame.size, Rational(high[j] - low[j]));
  }
  if (frame.size.sign() == 0) return std::nullopt;
  return frame;
}

Json net_json(const RuledFile<Rational>& surface, const UnitFrame& frame) {
  if (surface.c.points.size() > most_net_points) return nullptr;
  Json knots = Json::array();
  for (const Rational& knot : surface.knots.list()) knots.push_back(knot.to_double());
  return {{"degree", surface.knots.degree()},
          {"knots", knots},
          {"c", row_json(surface.c, frame)},
          {"d", row_json(surface.d, frame)}};
}

Json state_json(const std::string& label, const std::vector<SampledRuling>& rulings,
                const std::vector<std::optional<double>>& edge) {
  Json parameters = Json::array();
  Json targets = Json::array();
  Json lines = Json::array();
  Json warp = Json::array();
  for (const SampledRuling& ruling : rulings) {
    parameters.push_back(rounded(ruling.t));
    targets.push_back(rounded(ruling.target));
    lines.push_back(ruling_json(ruling));
    warp.push_back(finite_json(ruling.warp));
  }
  Json json{{"label", label}, {"t", parameters}, {"targets", targets}, {"rulings", lines}, {"warp", warp}};
  if (edge.empty()) return json;
  Json places = Json::array();
  for (const std::optional<double>& v : edge) places.push_back(v ? finite_json(*v) : Json());
  json["edge"] = places;
  return json;
}

std::optional<double> edge_position(const RailJet& c, const RailJet& d) {
  const Vector w = difference(d.point, c.point);
  const Vector turn = cross(difference(d.first, c.first), w);
  const double v = -dot(cross(c.first, w), turn) / dot(turn, turn);
  if (!std::isfinite(v)) return std::nullopt;
  return v;
}

Known known_of(const RuledFile<Rational>& surface, SurfaceClass kind) {
  if (kind == SurfaceClass::none) return {};
  return {.developable = true,
          .edge = kind == SurfaceClass::tangent || kind == SurfaceClass::cone,
          .singular = quick_singularities(surface)};
}

Json surface_picture(const std::string& name, const RuledFile<Rational>& surface, const Known& known,
                     std::size_t rulings) {
  const std::optional<UnitFrame> frame = unit_frame(surface.c, surface.d);
  if (!frame || surface.c.points.size() > most_picture_points || !within_budget(surface, most_picture_bits)) {
    return nullptr;
  }
  try {
    const RuledFile<Rational> unit = in_unit_cube(surface, *frame);
    const Rails rails = unit_rails({{unit.knots, unit.c}, {unit.knots, unit.d}});
    std::vector<SampledRuling> lines = even_rulings(rails, rulings);
    if (known.developable) {
      for (SampledRuling& line : lines) line.warp = 0;
    }
    using Edge = std::vector<std::optional<double>>;
    Json state = state_json("surface", lines, known.edge ? edge_of(rails, lines) : Edge{});
    return {{"name", name},
            {"size", short_number(frame->size)},
            {"net", net_json(surface, *frame)},
            {"states", Json::array({std::move(state)})},
            {"singular", known.singular ? singular_picture(*known.singular, surface.knots) : Json::array()}};
  } catch (const InvalidInput&) {
    return nullptr;
  }
}

}  // namespace torse::cli
