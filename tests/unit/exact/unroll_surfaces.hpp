// Ruled surfaces for tests of unrolling, with their points in doubles.
//   Surface, rows, bezier      by homogeneous rows
//   tangent_surface            that of the twisted cubic
//   Point                      three coordinates, and distances
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "torse/exact/unroll/plate.hpp"
#include "torse/scalar/builtin.hpp"
#include "torse/spline/curve.hpp"

namespace torse::test {

using Q = Rational;
using Rows = std::vector<Vec<Q, 4>>;
using Point = std::array<double, 3>;

/// A ruled surface by homogeneous rows, with its points in doubles.
struct Surface {
  KnotList<Q> u;
  Rows p;
  Rows q;

  std::vector<PieceStrip> strips() const { return piece_strips(u, p, q); }

  Plate plate(double tolerance, double warp = 0, bool mirrored = false) const {
    const std::vector<PieceStrip> list = strips();
    EXPECT_THAT(find_obstacles(list), ::testing::SizeIs(0));
    return unroll_plate(list, {tolerance, ruling_marks(u, list, 6), warp, mirrored});
  }

  Point point(const Rows& row, const Q& t) const {
    int k = 1;
    while (k < u.pieces() && (definitely(u.piece_empty(k)) || u.piece_end(k) < t)) ++k;
    const Vec<Q, 4> x = curve_point<Q, Vec<Q, 4>>(u, row, k, t);
    return {(x[1] / x[0]).to_double(), (x[2] / x[0]).to_double(), (x[3] / x[0]).to_double()};
  }
  Point c(const Q& t) const { return point(p, t); }
  Point d(const Q& t) const { return point(q, t); }
  Point c(double t) const { return point(p, t); }
  Point d(double t) const { return point(q, t); }
  /// By de Boor's algorithm in doubles.
  Point point(const Rows& row, double t) const {
    std::vector<double> knots;
    for (const Q& x : u.list()) knots.push_back(x.to_double());
    std::vector<Vec<double, 4>> control;
    for (const auto& x : row)
      control.push_back(Vec<double, 4>(x[0].to_double(), x[1].to_double(), x[2].to_double(), x[3].to_double()));
    int k = 1;
    const KnotList<double> list(u.degree(), knots);
    while (k < list.pieces() && list.piece_end(k) < t) ++k;
    const Vec<double, 4> x = curve_point<double, Vec<double, 4>>(list, control, k, t);
    return {x[1] / x[0], x[2] / x[0], x[3] / x[0]};
  }
};

inline Rows rows(const std::vector<std::array<double, 3>>& points, const std::vector<double>& weights = {}) {
  Rows result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Q w = weights.empty() ? Q(1) : Q::from_double(weights[i]);
    result.push_back(
        {w, w * Q::from_double(points[i][0]), w * Q::from_double(points[i][1]), w * Q::from_double(points[i][2])});
  }
  return result;
}

inline Surface bezier(Rows p, Rows q) {
  const int n = static_cast<int>(p.size()) - 1;
  return {bezier_knots<Q>(n), std::move(p), std::move(q)};
}

inline Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline double distance(const Point& a, const Point& b) { return std::sqrt(dot(minus(a, b), minus(a, b))); }
inline double distance(const PlatePoint& a, const PlatePoint& b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// r + k r', k = 1, 2, of the twisted cubic.
inline Surface tangent_surface() {
  Surface surface = bezier(Rows(4), Rows(4));
  for (int k = 1; k <= 2; ++k) {
    Rows& x = k == 1 ? surface.p : surface.q;
    for (int i = 0; i <= 3; ++i) {
      x[static_cast<std::size_t>(i)] = {Q(1), Q(k) + ratio<Q>(i, 3), ratio<Q>(2 * k * i, 3) + ratio<Q>(i * (i - 1), 6),
                                        Q(k) * ratio<Q>(i * (i - 1), 2) + ratio<Q>(i * (i - 1) * (i - 2), 6)};
    }
  }
  return surface;
}

}  // namespace torse::test
