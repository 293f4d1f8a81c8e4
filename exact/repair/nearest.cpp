// All families, the choice between them, and the decision about the result.
#include "torse/exact/repair/nearest.hpp"

#include <algorithm>
#include <utility>

#include "torse/exact/decide/decide.hpp"
#include "torse/exact/repair/families.hpp"

namespace torse {
namespace {

using repair::Candidate;
using repair::Real;
using repair::RealNet;
using repair::RuledRows;

bool unit_weights(const WeightedPoints<Rational, 3>& net) {
  return std::all_of(net.weights.begin(), net.weights.end(), [](const Rational& w) { return w == Rational(1); });
}

bool developable(const KnotList<Rational>& u, const RuledRows& rows) {
  if (unit_weights(rows.c) && unit_weights(rows.d)) {
    return !find_witness_over_q<3>(u, rows.c.points, rows.d.points);
  }
  return !find_witness_over_q<4>(u, homogeneous(rows.c), homogeneous(rows.d));
}

/// A candidate of either dimension.
struct Option {
  FamilyDistance summary;
  Real squared;
  std::vector<repair::RelationConstants> constants;
  std::function<std::optional<RuledRows>()> realise;
};

/// What the search works with; the candidates refer to it.
struct Search {
  const KnotList<Rational>& knots;
  const RuledRows& rows;
  repair::Frame frame;
  RealNet<3> points;
  RealNet<4> homogeneous;
  std::vector<Option> options{};

  template <int D>
  void add(NetFamily family, const Candidate<D>& candidate, int degree = 0) {
    const Real mean = candidate.squared / Real(points.size());
    const Real scale = Real::from_rational(repair::power_of_two(frame.exponent));
    options.push_back({{family, degree, (scale * mean.square_root()).to_double(), candidate.converged},
                       candidate.squared,
                       candidate.constants,
                       [this, realise = candidate.realise]() -> std::optional<RuledRows> {
                         const auto net = realise();
                         if (!net) return std::nullopt;
                         return repair::rows_of<D>(*net, frame, rows);
                       }});
  }

  /// The least squared distance so far.
  Real least() const {
    return std::ranges::min_element(options, {}, [](const Option& option) { return option.squared; })->squared;
  }

  template <int D>
  void add_relations(const RealNet<D>& net) {
    if (const auto candidate = repair::constant_candidate<D>(knots, net, least())) add(NetFamily::constant, *candidate);
    add_edges<D>(net);
    if (const auto candidate = repair::segments_candidate<D>(knots, net, least())) add(NetFamily::segments, *candidate);
  }

  template <int D>
  void add_edges(const RealNet<D>& net) {
    // The equations of an edge grow with 2^n and have no recursion: large nets do without.
    constexpr int most_degree = 8;
    constexpr int most_points = 500;
    if (knots.degree() > most_degree || knots.last() > most_points) return;
    for (int j = 1; j <= std::min(2, knots.degree() - 1); ++j) {
      if (const auto candidate = repair::edge_candidate<D>(knots, net, j, least())) {
        add(NetFamily::edge, *candidate, knots.degree() + 1 - j);
      }
    }
  }

  /// All families, simple ones first.
  void collect(bool polynomial) {
    add(NetFamily::plane, repair::plane_candidate(points));
    if (polynomial) {
      add(NetFamily::cylinder, repair::cylinder_candidate<3>(points));
      add(NetFamily::cone, repair::cone_candidate(points));
      add_relations<3>(points);
    } else {
      add(NetFamily::cylinder, repair::cylinder_candidate<4>(homogeneous));
      add(NetFamily::cone, repair::pencil_candidate(homogeneous));
      add_relations<4>(homogeneous);
    }
  }
};

/// The options in the order in which they are tried: by their distance, but where the least root mean square is below a
/// thousandth of the surface's size, those within twice of it come first, simple ones before others.
std::vector<const Option*> order_of(const std::vector<Option>& options, const Real& least, std::size_t points) {
  std::vector<const Option*> order;
  for (const Option& option : options) order.push_back(&option);
  const Real noise = Real(points) * Real::from_rational(repair::power_of_two(-20));
  const Real near = least < noise ? Real(4) * std::max(least, repair::negligible_distance()) : Real(0);
  const auto rest =
      std::stable_partition(order.begin(), order.end(), [&](const Option* option) { return option->squared <= near; });
  std::stable_sort(rest, order.end(), [](const Option* x, const Option* y) { return x->squared < y->squared; });
  return order;
}

}  // namespace

std::optional<NearestNet> nearest_developable(const KnotList<Rational>& u, const RuledRows& rows) {
  NearestNet result{.rows = rows};
  if (developable(u, rows)) {
    result.distance = distance_between(rows, rows);
    return result;
  }
  const bool polynomial = unit_weights(rows.c) && unit_weights(rows.d);
  const repair::Frame frame = repair::frame_of(rows);
  Search search{u, rows, frame, repair::real_net<3>(rows, frame), repair::real_net<4>(rows, frame)};
  search.collect(polynomial);
  for (const Option& option : search.options) result.families.push_back(option.summary);
  for (const Option* option : order_of(search.options, search.least(), search.points.size())) {
    auto found = option->realise();
    if (!found || !developable(u, *found)) continue;
    result.family = option->summary.family;
    result.degree = option->summary.degree;
    result.constants = option->constants;
    result.rows = std::move(*found);
    result.distance = distance_between(rows, result.rows);
    return result;
  }
  return std::nullopt;
}

}  // namespace torse
