#include "torse/exact/quasi/nearest_in_hull.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cstddef>
#include <vector>

namespace torse {
namespace {

using Point = Vec<double, 3>;

/// Some of the given points, at most four, and the weights of the point nearest to 0 in their hull.
class Corral {
 public:
  explicit Corral(const Point& point) : points_{point}, weights_{1} {}

  Point nearest() const {
    Point x(0, 0, 0);
    for (std::size_t i = 0; i < points_.size(); ++i) x += weights_[i] * points_[i];
    return x;
  }

  /// Four points are about 0, apart from rounding: there is none nearer.
  bool full() const { return points_.size() == 4; }

  /// Takes in a further point and leaves out those that the nearest one does without.
  void take_in(const Point& point) {
    points_.push_back(point);
    weights_.push_back(0);
    for (;;) {
      const std::vector<double> wanted = nearest_on_plane();
      if (std::ranges::all_of(wanted, [](double weight) { return weight > 0; })) {
        weights_ = wanted;
        return;
      }
      double share = 1;
      std::size_t first = 0;
      for (std::size_t i = 0; i < wanted.size(); ++i) {
        if (wanted[i] > 0) continue;
        const double until = weights_[i] > 0 ? weights_[i] / (weights_[i] - wanted[i]) : 0;
        if (until <= share) {
          share = until;
          first = i;
        }
      }
      for (std::size_t i = 0; i < wanted.size(); ++i) weights_[i] += share * (wanted[i] - weights_[i]);
      points_.erase(points_.begin() + static_cast<std::ptrdiff_t>(first));
      weights_.erase(weights_.begin() + static_cast<std::ptrdiff_t>(first));
    }
  }

 private:
  /// The weights, of sum 1, of the point nearest to 0 on the line, plane or space through the points.
  std::vector<double> nearest_on_plane() const {
    if (points_.size() == 1) return {1};
    Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 3> ways(3, points_.size() - 1);
    for (std::size_t i = 1; i < points_.size(); ++i) ways.col(static_cast<int>(i) - 1) = points_[i] - points_[0];
    const auto shares = ways.completeOrthogonalDecomposition().solve(-points_[0]).eval();
    std::vector<double> weights{1 - shares.sum()};
    weights.insert(weights.end(), shares.begin(), shares.end());
    return weights;
  }

  std::vector<Point> points_;
  std::vector<double> weights_;
};

}  // namespace

Point nearest_in_hull(const std::function<Point(const Point&)>& lowest, double good) {
  Corral corral(lowest(Point::UnitX()));
  for (Point x = corral.nearest();;) {
    const Point worst = lowest(x);
    if (corral.full() || x.dot(worst) > good * x.squaredNorm()) return x;
    corral.take_in(worst);
    const Point nearer = corral.nearest();
    if (!(nearer.squaredNorm() < x.squaredNorm())) return x;  // or one is no number
    x = nearer;
  }
}

}  // namespace torse
