// Krawczyk's test: whether a system of as many equations as unknowns has a zero near a point.
//   IntervalMatrix, IntervalVector
//   Krawczyk         the box about the point and the test
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <limits>

#include "torse/algebra/eigen.hpp"
#include "torse/scalar/interval.hpp"

namespace torse {

using IntervalMatrix = Eigen::Matrix<Interval, Eigen::Dynamic, Eigen::Dynamic>;
using IntervalVector = Eigen::Matrix<Interval, Eigen::Dynamic, 1>;

/// For a smooth f of as many coordinates as variables. With any matrix Y, f has exactly one zero in the box x + [-r, r]
/// where -Y f(x) + (1 - Y f'(box)) [-r, r] is inside [-r, r].
class Krawczyk {
 public:
  /// `inverse` is Y, best near the inverse of the slopes at x; `value` contains f(x).
  Krawczyk(const Eigen::MatrixXd& inverse, const IntervalVector& value)
      : inverse_(inverse.unaryExpr(&Interval::point)),
        moves_(inverse_.lazyProduct(value)),
        box_(moves_.unaryExpr(&Krawczyk::reach)) {}

  /// [-r, r]: r is twice what Newton's method would still move, and a little more for a value that is 0.
  const IntervalVector& box() const { return box_; }

  /// Whether f has one zero in x + [-r, r], given all its slopes there.
  bool has_zero(const IntervalMatrix& slopes) const {
    const Eigen::Index n = box_.size();
    const IntervalMatrix rest = IntervalMatrix::Identity(n, n) - inverse_.lazyProduct(slopes);
    const IntervalVector image = rest.lazyProduct(box_) - moves_;
    for (Eigen::Index i = 0; i < n; ++i) {
      if (!(box_[i].lower() < image[i].lower() && image[i].upper() < box_[i].upper())) return false;
    }
    return true;
  }

 private:
  static Interval reach(const Interval& move) {
    const double r = 2 * std::max(-move.lower(), move.upper()) + std::numeric_limits<double>::epsilon();
    return Interval::hull(-r, r);
  }

  IntervalMatrix inverse_;
  IntervalVector moves_;
  IntervalVector box_;
};

}  // namespace torse
