#include "torse/figures/sampled.hpp"

#include "torse/quasi/mapping.hpp"
#include "torse/spline/blossom.hpp"

namespace torse::figures {
namespace {

Vec<double, 4> double_row(const Row& row) {
  Vec<double, 4> result;
  for (int i = 0; i < 4; ++i) result[i] = row[i].to_double();
  return result;
}

KnotList<double> double_knots(const KnotList<Rational>& u) {
  std::vector<double> list;
  for (const Rational& x : u.list()) list.push_back(x.to_double());
  return KnotList<double>(u.degree(), std::move(list));
}

Vector affine(const Vec<double, 4>& row) { return row.tail<3>() / row[0]; }

// `count` + 1 even values from `from` to `to`.
std::vector<double> even(std::size_t count, double from, double to) {
  std::vector<double> values;
  for (std::size_t i = 0; i <= count; ++i) {
    values.push_back(from + (to - from) * static_cast<double>(i) / static_cast<double>(count));
  }
  return values;
}

}  // namespace

Vector place(const Row& row) { return affine(double_row(row)); }

std::vector<Vector> places(std::span<const Row> rows) {
  std::vector<Vector> result;
  for (const Row& row : rows) result.push_back(place(row));
  return result;
}

std::vector<Row> rows_of(std::initializer_list<std::array<int, 3>> points) {
  std::vector<Row> rows;
  for (const auto& [x, y, z] : points) {
    Row row;
    row << Rational(1), Rational(x), Rational(y), Rational(z);
    rows.push_back(std::move(row));
  }
  return rows;
}

DrawnSurface::DrawnSurface(const Surface& surface)
    : knots_(double_knots(surface.knots)), c_(doubles(surface.c_row())), d_(doubles(surface.d_row())) {}

std::vector<DrawnSurface::DoubleRow> DrawnSurface::doubles(std::span<const Row> rows) {
  std::vector<DoubleRow> result;
  for (const Row& row : rows) result.push_back(double_row(row));
  return result;
}

Vector DrawnSurface::at(std::span<const DoubleRow> row, double t) const {
  return affine(curve_point<double, DoubleRow>(knots_, row, piece_at(knots_, t), t));
}

Vector DrawnSurface::speed(std::span<const DoubleRow> row, double t) const {
  const int k = piece_at(knots_, t);
  const DoubleRow p = curve_point<double, DoubleRow>(knots_, row, k, t);
  const DoubleRow dp = curve_derivative<double, DoubleRow>(knots_, row, k, t);
  return (dp.tail<3>() - dp[0] * affine(p)) / p[0];
}

std::vector<std::vector<Vector>> DrawnSurface::rulings(std::size_t count, double from, double to) const {
  std::vector<std::vector<Vector>> rows;
  for (double t : even(count, begin(), end())) {
    std::vector<Vector> row;
    for (double v : even(8, from, to)) row.push_back(at(t, v));
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<Vector> curve_points(std::span<const Row> rows, std::size_t count, double from, double to) {
  std::vector<Vec<double, 4>> control;
  for (const Row& row : rows) control.push_back(double_row(row));
  const KnotList<double> u = bezier_knots<double>(static_cast<int>(rows.size()) - 1);
  std::vector<Vector> points;
  for (double t : even(count, from, to)) {
    points.push_back(affine(curve_point<double, Vec<double, 4>>(u, control, 1, t)));
  }
  return points;
}

}  // namespace torse::figures
