// B-spline surfaces of degree 1 in a direction: a strip between any two neighbouring rows.
#include <algorithm>
#include <string>

#include "torse/cad/read.hpp"
#include "torse/cad/strips.hpp"

namespace torse::cad {
namespace {

/// The net as rows: a row is a curve, and the surface has degree 1 from row to row.
struct Rows {
  int degree = 0;
  std::vector<double> knots{};
  std::vector<double> across{};
  std::vector<CadRail> rails{};
  std::optional<CadRange> along_box{};
  std::optional<CadRange> across_box{};
};

Rows rows_of(const Net& net, const std::optional<Box>& box, bool ruled_in_v) {
  Rows rows;
  rows.degree = ruled_in_v ? net.degree_u : net.degree_v;
  rows.knots = ruled_in_v ? net.knots_u : net.knots_v;
  rows.across = ruled_in_v ? net.knots_v : net.knots_u;
  const std::size_t lines = net.points.size() / net.columns;
  const std::size_t count = ruled_in_v ? net.columns : lines;
  const std::size_t length = ruled_in_v ? lines : net.columns;
  for (std::size_t row = 0; row < count; ++row) {
    CadRail rail{rows.degree, rows.knots, {}, {}};
    for (std::size_t k = 0; k < length; ++k) {
      const std::size_t at = ruled_in_v ? k * net.columns + row : row * net.columns + k;
      rail.points.push_back(net.points[at]);
      rail.weights.push_back(net.weights[at]);
    }
    rows.rails.push_back(std::move(rail));
  }
  if (box) {
    rows.along_box = ruled_in_v ? box->u : box->v;
    rows.across_box = ruled_in_v ? box->v : box->u;
  }
  return rows;
}

/// The domain of a CAD list.
CadRange domain_of(const std::vector<double>& knots, int degree) {
  const auto n = static_cast<std::size_t>(degree);
  return {knots[n], knots[knots.size() - 1 - n]};
}

void require_list(const std::vector<double>& knots, int degree, std::size_t points) {
  const auto n = static_cast<std::size_t>(std::max(degree, 1));
  if (degree < 1 || points < n + 1 || knots.size() != points + n + 1) {
    throw Unreadable("expected " + std::to_string(points + n + 1) + " knots for degree " + std::to_string(degree) +
                     " and " + std::to_string(points) + " control points, found " + std::to_string(knots.size()));
  }
  if (!std::ranges::is_sorted(knots)) throw Unreadable("expected knots that do not decrease");
  const CadRange domain = domain_of(knots, degree);
  if (!(domain.from < domain.to)) throw Unreadable("expected knots with a domain of positive length");
}

void require_fit(const Net& net) {
  if (net.columns == 0 || net.points.empty() || net.weights.size() != net.points.size()) {
    throw Unreadable("expected a weight for each control point");
  }
  require_list(net.knots_u, net.degree_u, net.points.size() / net.columns);
  require_list(net.knots_v, net.degree_v, net.columns);
}

/// Degree 1: row j belongs to the knot j + 1 of the CAD list.
void add_strips(const Rows& rows, CadFace& face) {
  for (std::size_t j = 0; j + 1 < rows.rails.size(); ++j) {
    const CadRange span{rows.across[j + 1], rows.across[j + 2]};
    if (!(span.from < span.to)) continue;
    CadStrip strip{CadRails{rows.rails[j], rows.rails[j + 1]}, rows.along_box, std::nullopt};
    if (rows.across_box) {
      const CadRange& cut = *rows.across_box;
      if (cut.to <= span.from || cut.from >= span.to) continue;
      const double length = span.to - span.from;
      const CadRange part{cut.from <= span.from ? 0 : (cut.from - span.from) / length,
                          cut.to >= span.to ? 1 : (cut.to - span.from) / length};
      if (part.from != 0 || part.to != 1) strip.across = part;
    }
    face.strips.push_back(std::move(strip));
  }
}

}  // namespace

CadRange snapped(CadRange range, const CadRange& natural, double resolution) {
  if (!(range.from > natural.from + resolution)) range.from = natural.from;
  if (!(range.to < natural.to - resolution)) range.to = natural.to;
  return range.from < range.to ? range : natural;
}

void add_net(const Net& net, const std::optional<Box>& box, CadFace& face) {
  require_fit(net);
  if (face.type.empty()) face.type = "B-spline surface";
  if (net.degree_u != 1 && net.degree_v != 1) {
    face.reason =
        "degree " + std::to_string(net.degree_u) + " x " + std::to_string(net.degree_v) + ", no direction has degree 1";
    return;
  }
  std::optional<Box> cut = box;
  if (cut) {
    const CadRange u = domain_of(net.knots_u, net.degree_u);
    const CadRange v = domain_of(net.knots_v, net.degree_v);
    cut->u = snapped(cut->u, u, cut->u_resolution);
    cut->v = snapped(cut->v, v, cut->v_resolution);
    const bool whole_u = cut->u.from == u.from && cut->u.to == u.to;
    const bool whole_v = cut->v.from == v.from && cut->v.to == v.to;
    face.trimmed = !whole_u || !whole_v;
  }
  Rows rows = rows_of(net, cut, net.degree_v == 1);
  if (!face.trimmed) rows.along_box = rows.across_box = std::nullopt;
  add_strips(rows, face);
}

}  // namespace torse::cad
