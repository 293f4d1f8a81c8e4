// Exact surfaces and curves as places to draw.
//   Row, place, places, rows_of    exact points, as homogeneous rows
//   DrawnSurface                   a surface in doubles: its points, derivatives and rulings
//   curve_points                   of a Bezier curve
#pragma once

#include <array>
#include <initializer_list>
#include <span>
#include <vector>

#include "torse/figures/figure.hpp"
#include "torse/scalar/builtin.hpp"

namespace torse::figures {

using Row = Vec<Rational, 4>;

/// The finite point of a row w (1, c).
Vector place(const Row& row);

/// The places of all vertices of a control polygon.
std::vector<Vector> places(std::span<const Row> rows);

/// (1, c) of points with integer coordinates.
std::vector<Row> rows_of(std::initializer_list<std::array<int, 3>> points);

/// An exact surface in doubles.
class DrawnSurface {
 public:
  explicit DrawnSurface(const Surface& surface);

  double begin() const { return knots_.piece_begin(1); }
  double end() const { return knots_.piece_end(knots_.pieces()); }
  Vector c(double t) const { return at(c_, t); }
  Vector d(double t) const { return at(d_, t); }
  /// (1-v) c(t) + v d(t).
  Vector at(double t, double v) const { return (1 - v) * c(t) + v * d(t); }
  /// The derivatives c'(t), d'(t).
  Vector c_speed(double t) const { return speed(c_, t); }
  Vector d_speed(double t) const { return speed(d_, t); }

  /// The rulings at `count` + 1 even parameters, each as points from v = from to v = to.
  std::vector<std::vector<Vector>> rulings(std::size_t count, double from = 0, double to = 1) const;

 private:
  using DoubleRow = Vec<double, 4>;

  static std::vector<DoubleRow> doubles(std::span<const Row> rows);
  Vector at(std::span<const DoubleRow> row, double t) const;
  Vector speed(std::span<const DoubleRow> row, double t) const;

  KnotList<double> knots_;
  std::vector<DoubleRow> c_;
  std::vector<DoubleRow> d_;
};

/// `count` + 1 points of the Bezier curve with these rows, from parameter `from` to `to`.
std::vector<Vector> curve_points(std::span<const Row> rows, std::size_t count = 48, double from = 0, double to = 1);

}  // namespace torse::figures
