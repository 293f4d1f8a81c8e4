// The global start: the best monotone path through a grid of rulings, by dynamic programming.
//   Ends                 what a mapping has to do at the ends of the rails
//   RulingGrid           the warp of all rulings between points of the two rails
//   best_path            the path of least total warp
//   follow_path          a mapping along a path
#pragma once

#include <vector>

#include "torse/quasi/ruling_angle.hpp"

namespace torse::quasi {

/// fixed: sigma(0) = 0 and sigma(1) = 1. free: 0 <= sigma(0), sigma(1) <= 1.
enum class Ends { fixed, free };

/// cost(i, j) >= 0: the angle of the ruling from c(i / columns) to d(j / rows) within half a percent and the rounding
/// errors of single precision; 0 where it is not defined, the largest angle there is where a rail is infinite.
class RulingGrid {
 public:
  RulingGrid(const Rails& rails, int columns, int rows, AngleKind kind);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  /// The costs of column i, rows() + 1 of them.
  const float* column(int i) const { return cost_.data() + static_cast<std::size_t>(i) * height(); }

 private:
  std::size_t height() const { return static_cast<std::size_t>(rows_) + 1; }

  int columns_;
  int rows_;
  std::vector<float> cost_;
};

/// T_0 <= ... <= T_columns in [0, 1] such that the mean cost along the polyline through the points (i, T_i) is least
/// among all paths through points of the grid. A step over k rows costs the mean of the two columns over these rows, so
/// a steep step across rulings of large warp is not free. Takes columns rows^2 / 2 operations.
std::vector<double> best_path(const RulingGrid& grid, Ends ends);

/// The coefficients of a monotone mapping near the polyline through the points (i / columns, path_i): its values at the
/// Greville abscissae (Schoenberg's operator, which keeps the order).
std::vector<double> follow_path(const std::vector<double>& path, const std::vector<double>& greville);

}  // namespace torse::quasi
