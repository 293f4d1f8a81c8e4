#include "torse/fuzz/properties/repair.hpp"

#include <algorithm>
#include <cmath>

#include "torse/exact/repair/nearest.hpp"
#include "torse/fuzz/draw/rough.hpp"
#include "torse/fuzz/plain/length.hpp"

namespace torse::fuzz {
namespace {

using plain::Point;
using plain::squared_distance;
using repair::RuledRows;

Rational magnitude(const Rational& x) { return x.sign() < 0 ? -x : x; }

WeightedPoints<Rational, 3> points_of(const std::vector<Row4>& row) {
  WeightedPoints<Rational, 3> net;
  for (const Row4& x : row) {
    net.points.push_back(plain::point_of(x));
    net.weights.push_back(x[0]);
  }
  return net;
}

std::vector<Row4> rows_of(const WeightedPoints<Rational, 3>& net) {
  std::vector<Row4> rows;
  for (std::size_t i = 0; i < net.points.size(); ++i) {
    const Rational& w = net.weights[i];
    rows.emplace_back(w, w * net.points[i][0], w * net.points[i][1], w * net.points[i][2]);
  }
  return rows;
}

/// The largest and the mean squared distance of points, the largest relative change of a weight.
struct Change {
  Rational largest;
  Rational mean;
  Rational weights;
};

Change change_of(const RuledRows& before, const RuledRows& after) {
  Change change;
  std::size_t count = 0;
  for (const auto& [old, now] : {std::pair(&before.c, &after.c), std::pair(&before.d, &after.d)}) {
    for (std::size_t i = 0; i < old->points.size(); ++i, ++count) {
      const Rational square = squared_distance(old->points[i], now->points[i]);
      change.largest = std::max<Rational>(change.largest, square);
      change.mean += square;
      change.weights =
          std::max<Rational>(change.weights, magnitude(now->weights[i] - old->weights[i]) / magnitude(old->weights[i]));
    }
  }
  change.mean /= Rational(static_cast<long>(count));
  return change;
}

/// A bound of a root is not below it, and above it by rounding alone.
void require_root(double bound, const Rational& square, const char* message) {
  if (std::isinf(bound)) return;
  const Rational x = Rational::from_double(bound);
  const Rational rounded = Rational::from_double(bound * (1 - 0x1p-40));
  require(x * x >= square && rounded * rounded <= square, message);
}

void check_distance(const NetDistance& distance, const Change& change) {
  require_root(distance.largest, change.largest, "the largest distance is wrong");
  require_root(distance.root_mean_square, change.mean, "the root mean square is wrong");
  require_root(distance.weights, change.weights * change.weights, "the change of the weights is wrong");
}

void check_surfaces(const NearestNets::In& in, const NearestNet& nearest) {
  if (!nearest.distance.surfaces || std::isinf(*nearest.distance.surfaces)) return;
  const KnotList<Rational>& u = in.net.knots;
  const plain::Strip before = plain::strip_of(u, in.net.c, in.net.d);
  const plain::Strip after = plain::strip_of(u, rows_of(nearest.rows.c), rows_of(nearest.rows.d));
  const Rational bound = Rational::from_double(*nearest.distance.surfaces);
  for (int j = 0; j < before.p.count(); ++j) {
    const auto at = static_cast<std::size_t>(j);
    for (const Rational& share : in.shares) {
      const Rational& begin = before.p.breaks[at];
      const Rational t = begin + share * (before.p.breaks[at + 1] - begin);
      const Rational c = squared_distance(plain::point_of(plain::value_at<4>(before.p.rows[at], t)),
                                          plain::point_of(plain::value_at<4>(after.p.rows[at], t)));
      const Rational d = squared_distance(plain::point_of(plain::value_at<4>(before.q.rows[at], t)),
                                          plain::point_of(plain::value_at<4>(after.q.rows[at], t)));
      require(c <= bound * bound && d <= bound * bound, "points of the surfaces are farther apart than the bound");
    }
  }
}

bool unit_weights(const std::vector<Row4>& row) {
  return std::all_of(row.begin(), row.end(), [](const Row4& x) { return x[0] == Rational(1); });
}

}  // namespace

const PropertyInfo& NearestNets::info() {
  static const PropertyInfo info{
      "repair.nearest",
      "the nearest net is exactly developable, with weights that are not 0 and stay 1 where all are 1; its distances "
      "are those of the points; a developable net stays as it is",
      1,
      {"family=unchanged", "class=none", "class=tangent"}};
  return info;
}

NearestNets::In NearestNets::draw(Choices& choices, const Scale& scale, Labels& labels) {
  In in{choices.once_in(3) ? draw_rational_net(choices, scale) : with_weights(draw_net(choices, scale)), {}};
  if (choices.once_in(2)) roughen(choices, in.net);
  add_net_labels(labels, in.net);
  for (int i = 0; i < 3; ++i) in.shares.push_back(Rational(choices.between(0, 16)) / Rational(16));
  return in;
}

void NearestNets::check(const In& in, Labels& labels) {
  const RuledRows rows{points_of(in.net.c), points_of(in.net.d)};
  const std::optional<NearestNet> nearest = nearest_developable(in.net.knots, rows);
  labels.add("family", nearest ? std::string(name_of(nearest->family)) : "none");
  if (!nearest) return require(!in.net.developable, "no net for one that is developable");
  const std::vector<Row4> c = rows_of(nearest->rows.c);
  const std::vector<Row4> d = rows_of(nearest->rows.d);
  require((nearest->family == NetFamily::unchanged) == in.net.developable, "changed or unchanged wrongly");
  require(c.size() == in.net.c.size() && d.size() == in.net.d.size(), "another number of points");
  if (in.net.developable) return require(c == in.net.c && d == in.net.d, "a developable net is changed");
  for (const auto* row : {&c, &d}) {
    for (const Row4& x : *row) require(x[0].sign() != 0, "a weight 0");
  }
  require(!unit_weights(in.net.c) || !unit_weights(in.net.d) || (unit_weights(c) && unit_weights(d)),
          "weights 1 that do not stay");
  require(plain::holds_by_samples(plain::strip_of(in.net.knots, c, d)), "the net is not developable");
  check_distance(nearest->distance, change_of(rows, nearest->rows));
  check_surfaces(in, *nearest);
}

}  // namespace torse::fuzz
