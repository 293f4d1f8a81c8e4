// A ruled surface in doubles, where a crossing of its rulings is looked for by Newton's method.
//   RoundedStrip        points and tangents, crossing_near
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "torse/exact/quasi/self_intersection.hpp"
#include "torse/scalar/builtin.hpp"
#include "torse/spline/insertion.hpp"

namespace torse {

/// The surface between two rows of points (D = 3) or homogeneous rows (D = 4).
class RoundedStrip {
 public:
  template <int D>
  RoundedStrip(const KnotList<Rational>& u, std::span<const Vec<Rational, D>> c, std::span<const Vec<Rational, D>> d) {
    for (const int k : u.proper_pieces()) {
      begins_.push_back(u.piece_begin(k).to_double());
      lengths_.push_back(Rational(u.piece_end(k) - u.piece_begin(k)).to_double());
      c_.push_back(rounded<D>(bezier_points(u, c, k)));
      d_.push_back(rounded<D>(bezier_points(u, d, k)));
      for (const Rows* rows : {&c_.back(), &d_.back()}) {
        for (const auto& row : *rows) size_ = std::max(size_, row.tail<3>().norm() / std::abs(row[0]));
      }
    }
  }

  /// Parameters are the number of a piece and the share of it.
  std::optional<RulingCrossing> crossing_near(double s, double t) const {
    Eigen::Vector4d x(s, 0.5, t, 0.5);
    for (int step = 0; step < 30; ++step) {
      const auto [first, by_s, by_v] = point(x[0], x[1]);
      const auto [second, by_t, by_w] = point(x[2], x[3]);
      const Direction gap = first - second;
      if (!gap.allFinite()) return std::nullopt;
      if (gap.norm() <= 1e-13 * size_) break;
      Eigen::Matrix<double, 3, 4> jacobian;
      jacobian << by_s, by_v, -by_t, -by_w;
      x -= jacobian.completeOrthogonalDecomposition().solve(gap);
    }
    const double gap = (std::get<0>(point(x[0], x[1])) - std::get<0>(point(x[2], x[3]))).norm();
    const double last = static_cast<double>(c_.size());
    const bool inside =
        x[0] >= 0 && x[0] <= last && x[2] >= 0 && x[2] <= last && x[1] >= 0 && x[1] <= 1 && x[3] >= 0 && x[3] <= 1;
    if (!inside || !(gap <= 1e-12 * size_) || std::abs(x[0] - x[2]) < 1e-3) return std::nullopt;
    return RulingCrossing{parameter(x[0]), x[1], parameter(x[2]), x[3], gap};
  }

 private:
  using Direction = Vec<double, 3>;
  using Rows = std::vector<Vec<double, 4>>;

  template <int D>
  static Rows rounded(const std::vector<Vec<Rational, D>>& points) {
    Rows rows;
    for (const Vec<Rational, D>& x : points) {
      Vec<double, 4> row(1, 0, 0, 0);
      for (int k = 0; k < D; ++k) row[k + 4 - D] = x[k].to_double();
      rows.push_back(row);
    }
    return rows;
  }

  std::size_t piece(double s) const {
    return static_cast<std::size_t>(std::clamp(s, 0.0, static_cast<double>(c_.size()) - 1));
  }
  double parameter(double s) const {
    return begins_[piece(s)] + (s - static_cast<double>(piece(s))) * lengths_[piece(s)];
  }

  /// A point of a Bezier curve and its derivative by the share.
  static std::pair<Direction, Direction> curve(Rows row, double share) {
    Vec<double, 4> slope = Vec<double, 4>::Zero();
    const double degree = static_cast<double>(row.size() - 1);
    for (std::size_t size = row.size(); size > 1; --size) {
      if (size == 2) slope = degree * (row[1] - row[0]);
      for (std::size_t i = 0; i + 1 < size; ++i) row[i] = (1 - share) * row[i] + share * row[i + 1];
    }
    const Direction point = row[0].tail<3>() / row[0][0];
    return {point, (slope.tail<3>() - slope[0] * point) / row[0][0]};
  }

  /// The surface's point and its derivatives by the parameter and along the ruling.
  std::tuple<Direction, Direction, Direction> point(double s, double v) const {
    const double share = s - static_cast<double>(piece(s));
    const auto [c, by_c] = curve(c_[piece(s)], share);
    const auto [d, by_d] = curve(d_[piece(s)], share);
    return {(1 - v) * c + v * d, (1 - v) * by_c + v * by_d, d - c};
  }

  std::vector<double> begins_;
  std::vector<double> lengths_;
  std::vector<Rows> c_;
  std::vector<Rows> d_;
  double size_ = 0;
};

}  // namespace torse
