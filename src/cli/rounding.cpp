// Each number is rounded by itself, once.
#include "torse/cli/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "torse/spline/compatible.hpp"

namespace torse::cli {
namespace {

using Row = Vec<Rational, 4>;

std::vector<Row> clamped(const KnotList<Rational>& u, const WeightedPoints<Rational, 3>& net) {
  std::vector<Row> rows = homogeneous(net);
  if (definitely(u.clamped())) return rows;
  return restrict_spline(Spline<Rational, Row>(u, std::move(rows)), u.domain_begin(), u.domain_end()).control;
}

KnotList<Rational> clamped(const KnotList<Rational>& u) {
  if (definitely(u.clamped())) return u;
  const std::vector<Rational> zeros(static_cast<std::size_t>(u.last()) + 1);
  return restrict_spline(Spline<Rational, Vec<Rational, 1>>(u, std::vector<Vec<Rational, 1>>(zeros.size())),
                         u.domain_begin(), u.domain_end())
      .knots;
}

/// The rail with positive weights.
WeightedPoints<Rational, 3> positive(const std::vector<Row>& rows, const char* name) {
  WeightedPoints<Rational, 3> net = dehomogenize(rows);
  const auto negative = [](const Rational& w) { return w.sign() < 0; };
  const auto count = std::ranges::count_if(net.weights, negative);
  if (count != 0 && count != std::ssize(net.weights)) {
    throw InvalidInput(std::string(name) + ".weights", "have both signs; CAD systems take positive ones only");
  }
  if (count != 0) {
    for (Rational& w : net.weights) w = -w;
  }
  return net;
}

void make_unit_weights(RuledFile<Rational>& surface) {
  const Rational& first = surface.c.weights.front();
  const auto equal = [&](const Rational& w) { return w == first; };
  if (!std::ranges::all_of(surface.c.weights, equal) || !std::ranges::all_of(surface.d.weights, equal)) return;
  surface.c.weights.assign(surface.c.weights.size(), Rational(1));
  surface.d.weights.assign(surface.d.weights.size(), Rational(1));
}

/// Rounds numbers and counts.
class Rounder {
 public:
  Rational knot_or_weight(const Rational& x, const char* place) { return rounded(x, place); }

  Rational coordinate(const Rational& x) {
    Rational y = rounded(x, "points");
    const Rational change = x < y ? y - x : x - y;
    if (shift_ < change) shift_ = change;
    return y;
  }

  void count_into(RoundedSurface& result) const {
    result.numbers = numbers_;
    result.changed = changed_;
    const double nearest = shift_.to_double();
    result.shift = Rational::from_double(nearest) < shift_
                       ? std::nextafter(nearest, std::numeric_limits<double>::infinity())
                       : nearest;
  }

 private:
  Rational rounded(const Rational& x, const char* place) {
    const double nearest = x.to_double();
    if (!std::isfinite(nearest)) throw InvalidInput(place, "are beyond the range of double");
    Rational y = Rational::from_double(nearest);
    ++numbers_;
    if (y != x) ++changed_;
    return y;
  }

  std::size_t numbers_ = 0;
  std::size_t changed_ = 0;
  Rational shift_;
};

void round_net(WeightedPoints<Rational, 3>& net, Rounder& rounder) {
  for (Vec<Rational, 3>& x : net.points) {
    for (int j = 0; j < 3; ++j) x[j] = rounder.coordinate(x[j]);
  }
  for (Rational& w : net.weights) {
    w = rounder.knot_or_weight(w, "weights");
    if (w.sign() == 0) throw InvalidInput("weights", "are beyond the range of double");
  }
}

CadRail rail_of(const KnotList<Rational>& u, const WeightedPoints<Rational, 3>& net) {
  CadRail rail{.degree = u.degree()};
  for (const Rational& knot : u.cad_list()) rail.knots.push_back(knot.to_double());
  for (const Vec<Rational, 3>& x : net.points) {
    rail.points.push_back({x[0].to_double(), x[1].to_double(), x[2].to_double()});
  }
  for (const Rational& w : net.weights) rail.weights.push_back(w.to_double());
  return rail;
}

}  // namespace

RoundedSurface round_surface(const RuledFile<Rational>& surface) {
  RuledFile<Rational> exact{clamped(surface.knots), positive(clamped(surface.knots, surface.c), "c"),
                            positive(clamped(surface.knots, surface.d), "d")};
  make_unit_weights(exact);
  Rounder rounder;
  std::vector<Rational> knots;
  for (const Rational& knot : exact.knots.list()) knots.push_back(rounder.knot_or_weight(knot, "knots"));
  round_net(exact.c, rounder);
  round_net(exact.d, rounder);
  RoundedSurface result{{KnotList<Rational>(exact.knots.degree(), std::move(knots)), exact.c, exact.d}};
  rounder.count_into(result);
  return result;
}

CadSheet sheet_of(const RoundedSurface& rounded, const std::string& name) {
  const RuledFile<Rational>& s = rounded.surface;
  return {.name = name, .c = rail_of(s.knots, s.c), .d = rail_of(s.knots, s.d)};
}

}  // namespace torse::cli
