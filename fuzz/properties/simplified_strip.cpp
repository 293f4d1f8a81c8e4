#include "torse/fuzz/properties/simplified_strip.hpp"

#include <algorithm>
#include <string>

#include "torse/exact/quasi/simplify.hpp"
#include "torse/fuzz/draw/numbers.hpp"
#include "torse/fuzz/plain/pieces.hpp"

namespace torse::fuzz {
namespace {

using In = SimplifiedStrip::In;
using Q = Rational;

/// Clamped knots over [0, last break], inner ones of any multiplicity up to the degree.
KnotList<Q> draw_clamped(Choices& choices, int degree, int pieces) {
  std::vector<Q> list(static_cast<std::size_t>(degree), Q(0));
  Q t(0);
  for (int k = 1; k <= pieces; ++k) {
    t += Q(choices.between(1, 8)) / Q(4);
    list.insert(list.end(), static_cast<std::size_t>(k == pieces ? degree : choices.between(1, degree)), t);
  }
  return {degree, std::move(list)};
}

std::vector<Point3> draw_row(Choices& choices, int count, bool smooth) {
  std::vector<Point3> row;
  for (int i = 0; i < count; ++i) {
    const int jump = smooth ? 1 : 16;
    row.push_back({Q(4 * i), Q(choices.between(-jump, jump)), Q(choices.between(-jump, jump)) / Q(2)});
  }
  return row;
}

Q square(const Point3& x) { return x[0] * x[0] + x[1] * x[1] + x[2] * x[2]; }

bool breaks_among(const KnotList<Q>& fewer, const KnotList<Q>& all) {
  return std::ranges::includes(plain::breaks_of(all), plain::breaks_of(fewer));
}

/// The rows of both surfaces at shares of all pieces are at most the distance apart, and at the ends not at all.
void check_distance(const In& in, const std::vector<Point3>& row, const KnotList<Q>& knots,
                    const std::vector<Point3>& simple, double distance) {
  const plain::Pieces<3> before = plain::pieces_of<3>(in.knots, row);
  const plain::Pieces<3> after = plain::pieces_of<3>(knots, simple);
  const Q most = Q::from_double(distance) * Q::from_double(distance);
  std::size_t k = 0;
  for (std::size_t j = 0; j < before.rows.size(); ++j) {
    const Q& begin = before.breaks[j];
    const Q& end = before.breaks[j + 1];
    while (after.breaks[k + 1] <= begin) ++k;
    for (const Q& share : in.shares) {
      const Q t = begin + share * (end - begin);
      const Point3 gap = plain::value_at<3>(before.rows[j], t) - plain::value_at<3>(after.rows[k], t);
      require(square(gap) <= most, "a simpler surface is further away than it says");
    }
  }
  require(row.front() == simple.front() && row.back() == simple.back(), "a corner has moved");
}

void check_simplified(const In& in, const SimplifiedSurface& found, Labels& labels, const char* key) {
  const ExactSurface& surface = found.surface;
  require(found.distance >= 0 && Q::from_double(found.distance) <= in.tolerance, "beyond the tolerance");
  require(breaks_among(surface.knots, in.knots), "a breakpoint from nowhere");
  require(surface.knots.degree() <= in.knots.degree(), "a higher degree");
  check_distance(in, in.c, surface.knots, surface.c, found.distance);
  check_distance(in, in.d, surface.knots, surface.d, found.distance);
  labels.add(key, surface.c.size() < in.c.size() ? "simpler" : "same");
}

}  // namespace

const PropertyInfo& SimplifiedStrip::info() {
  static const PropertyInfo info{
      "fit.simplified",
      "a simpler surface has the same corners and no point further away than it says, which is within the tolerance",
      1,
      {"points=simpler", "points=same", "degree=simpler", "degree=same", "knots=simpler", "knots=none"}};
  return info;
}

SimplifiedStrip::In SimplifiedStrip::draw(Choices& choices, const Scale& scale, Labels& labels) {
  const int degree = choices.between(1, std::min(scale.degree, 4));
  In in{draw_clamped(choices, degree, choices.between(1, std::min(scale.pieces, 4)))};
  const int count = in.knots.last() + 1;
  const bool smooth = choices.once_in(2);
  in.c = draw_row(choices, count, smooth);
  in.d = draw_row(choices, count, smooth);
  in.tolerance = power_of_two(choices.between(-10, 5));
  in.shares = {Q(0), Q(1), Q(1) / Q(2), Q(choices.between(1, 15)) / Q(16), Q(choices.between(1, 15)) / Q(16)};
  labels.add("pieces", static_cast<int>(in.knots.proper_pieces().size()));
  return in;
}

void SimplifiedStrip::check(const In& in, Labels& labels) {
  const ExactSurface surface(in.knots, in.c, in.d);
  const SimplifiedSurface fewest = with_fewest_points(surface, in.tolerance);
  require(fewest.surface.c.size() <= in.c.size(), "more points than before");
  check_simplified(in, fewest, labels, "points");
  check_simplified(in, with_lowest_degree(surface, in.tolerance), labels, "degree");
  const int degree = std::max(1, in.knots.degree() - 1);
  const std::optional<SimplifiedSurface> fewer = with_fewest_knots(surface, degree, in.tolerance);
  if (!fewer) {
    labels.add("knots", "none");
    return;
  }
  require(fewer->surface.knots.degree() == degree, "another degree than asked for");
  check_distance(in, in.c, fewer->surface.knots, fewer->surface.c, fewer->distance);
  check_distance(in, in.d, fewer->surface.knots, fewer->surface.d, fewer->distance);
  require(Q::from_double(fewer->distance) <= in.tolerance, "beyond the tolerance");
  labels.add("knots", fewer->surface.c.size() < in.c.size() ? "simpler" : "same");
}

}  // namespace torse::fuzz
