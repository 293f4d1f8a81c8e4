#include "torse/quasi/rail.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "torse/spline/insertion.hpp"

namespace torse::quasi {
namespace {

using Row = Vec<double, 4>;

/// The degree up to which a Bezier polygon needs no memory from the heap.
constexpr int small_degree = 12;

/// A polynomial at a parameter with three derivatives.
template <int D>
struct Derivatives {
  Vec<double, D> value;
  Vec<double, D> first = Vec<double, D>::Zero();
  Vec<double, D> second = Vec<double, D>::Zero();
  Vec<double, D> third = Vec<double, D>::Zero();
};

/// At the share y of a piece, which is 1 / rate long, by de Casteljau's algorithm: its last rows hold the differences
/// that the derivatives are made of.
template <int D>
Derivatives<D> derivatives(const Vec<double, D>* bezier, int degree, double y, double rate) {
  std::array<Vec<double, D>, small_degree + 1> small;
  std::vector<Vec<double, D>> large;
  Vec<double, D>* row = small.data();
  if (degree > small_degree) {
    large.resize(static_cast<std::size_t>(degree) + 1);
    row = large.data();
  }
  std::copy_n(bezier, degree + 1, row);

  const double x = 1 - y;
  const double factor1 = degree * rate;
  const double factor2 = (degree - 1) * rate * factor1;
  Derivatives<D> at;
  for (int size = degree + 1; size > 1; --size) {
    if (size == 4) at.third = (degree - 2) * rate * factor2 * (row[3] - 3 * row[2] + 3 * row[1] - row[0]);
    if (size == 3) at.second = factor2 * (row[2] - 2 * row[1] + row[0]);
    if (size == 2) at.first = factor1 * (row[1] - row[0]);
    for (int i = 0; i + 1 < size; ++i) row[i] = x * row[i] + y * row[i + 1];
  }
  at.value = row[0];
  return at;
}

/// The quotient x = r / w of a numerator and a weight with their derivatives: r = x w gives r' = x' w + x w' and so on.
RailJet quotient(const Derivatives<4>& r) {
  const double w = r.value[0], w1 = r.first[0], w2 = r.second[0], w3 = r.third[0];
  RailJet jet;
  jet.point = r.value.tail<3>() / w;
  jet.first = (r.first.tail<3>() - w1 * jet.point) / w;
  jet.second = (r.second.tail<3>() - w2 * jet.point - 2 * w1 * jet.first) / w;
  jet.third = (r.third.tail<3>() - w3 * jet.point - 3 * w2 * jet.first - 3 * w1 * jet.second) / w;
  return jet;
}

/// The ends of the proper pieces, mapped to [0, 1].
std::vector<double> breaks_of(const Spline<double, Row>& curve) {
  const double begin = curve.knots.domain_begin();
  const double length = curve.knots.domain_end() - begin;
  std::vector<double> breaks;
  for (const int k : curve.knots.proper_pieces()) breaks.push_back((curve.knots.piece_begin(k) - begin) / length);
  breaks.push_back(1);
  return breaks;
}

std::vector<Row> bezier_rows(const Spline<double, Row>& curve) {
  std::vector<Row> rows;
  for (const int k : curve.knots.proper_pieces()) {
    for (const Row& row : bezier_points(curve.knots, curve.points(), k)) rows.push_back(row);
  }
  return rows;
}

}  // namespace

Rail::Rail(int degree, std::vector<double> breaks, std::vector<Row> control)
    : degree_(degree), breaks_(std::move(breaks)) {
  for (std::size_t i = 0; i + 1 < breaks_.size(); ++i) rates_.push_back(1 / (breaks_[i + 1] - breaks_[i]));
  const double weight = control.front()[0];
  bool rational = false;
  for (const Row& row : control) {
    if (!row.allFinite()) throw InvalidInput("points", "expected finite numbers");
    rational = rational || row[0] != weight;
  }
  if (rational) {
    rows_ = std::move(control);
    return;
  }
  for (const Row& row : control) points_.push_back(row.tail<3>() / weight);
}

Rail::Rail(const Spline<double, Row>& curve) : Rail(curve.knots.degree(), breaks_of(curve), bezier_rows(curve)) {}

RailJet Rail::operator()(double t) const {
  const auto above = std::upper_bound(breaks_.begin() + 1, breaks_.end() - 1, t);
  const std::size_t piece = static_cast<std::size_t>(above - breaks_.begin()) - 1;
  const std::size_t first = piece * (static_cast<std::size_t>(degree_) + 1);
  const double y = (t - breaks_[piece]) / (breaks_[piece + 1] - breaks_[piece]);
  if (!rows_.empty()) return quotient(derivatives<4>(rows_.data() + first, degree_, y, rates_[piece]));
  const Derivatives<3> at = derivatives<3>(points_.data() + first, degree_, y, rates_[piece]);
  return {at.value, at.first, at.second, at.third};
}

}  // namespace torse::quasi
