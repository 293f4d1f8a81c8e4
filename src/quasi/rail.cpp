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

Vector affine(const Row& row) { return row.tail<3>(); }

/// The quotient x = r / w of a numerator and a weight with their derivatives: r = x w gives r' = x' w + x w' and so on.
RailJet quotient(const Row& r, const Row& r1, const Row& r2, const Row& r3) {
  RailJet jet;
  jet.point = affine(r) / r[0];
  jet.first = (affine(r1) - r1[0] * jet.point) / r[0];
  jet.second = (affine(r2) - r2[0] * jet.point - 2 * r1[0] * jet.first) / r[0];
  jet.third = (affine(r3) - r3[0] * jet.point - 3 * r2[0] * jet.first - 3 * r1[0] * jet.second) / r[0];
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
    : degree_(degree), breaks_(std::move(breaks)), control_(std::move(control)) {
  const double weight = control_.front()[0];
  for (Row& row : control_) {
    if (!row.allFinite()) throw InvalidInput("points", "expected finite numbers");
    rational_ = rational_ || row[0] != weight;
    row /= weight;
  }
}

Rail::Rail(const Spline<double, Row>& curve) : Rail(curve.knots.degree(), breaks_of(curve), bezier_rows(curve)) {}

RailJet Rail::operator()(double t) const {
  const auto piece = std::upper_bound(breaks_.begin() + 1, breaks_.end() - 1, t) - breaks_.begin() - 1;
  const double begin = breaks_[static_cast<std::size_t>(piece)];
  const double length = breaks_[static_cast<std::size_t>(piece) + 1] - begin;
  const double y = (t - begin) / length;
  const double x = 1 - y;
  const auto first = control_.begin() + piece * (degree_ + 1);

  std::array<Row, small_degree + 1> small;
  std::vector<Row> large;
  Row* row = small.data();
  if (degree_ > small_degree) {
    large.resize(static_cast<std::size_t>(degree_) + 1);
    row = large.data();
  }
  std::copy_n(first, degree_ + 1, row);

  // De Casteljau's algorithm; its last rows hold the differences that the derivatives are made of.
  Row r1 = Row::Zero(), r2 = Row::Zero(), r3 = Row::Zero();
  double factor = 1 / (length * length * length);
  for (int i = 0; i < 3; ++i) factor *= degree_ - i;
  for (int size = degree_ + 1; size > 1; --size) {
    if (size == 4) r3 = factor * (row[3] - 3 * row[2] + 3 * row[1] - row[0]);
    if (size == 3) r2 = (degree_ * (degree_ - 1) / (length * length)) * (row[2] - 2 * row[1] + row[0]);
    if (size == 2) r1 = (degree_ / length) * (row[1] - row[0]);
    for (int i = 0; i + 1 < size; ++i) row[i] = x * row[i] + y * row[i + 1];
  }
  if (rational_) return quotient(row[0], r1, r2, r3);
  return {affine(row[0]), affine(r1), affine(r2), affine(r3)};
}

}  // namespace torse::quasi
