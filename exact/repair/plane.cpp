// The nearest plane, by total least squares.
#include <utility>

#include "torse/exact/repair/families.hpp"
#include "torse/exact/repair/vectors.hpp"

namespace torse::repair {

Candidate<3> plane_candidate(const RealNet<3>& net) {
  const Vec<Real, 3> centre = mean_point(net, 0, 1);
  Matrix moments = zero_matrix(3);
  Real spread;
  for (const Vec<Real, 3>& x : net.points) {
    const Vec<Real, 3> y = difference(x, centre);
    spread += inner<3>(y, y);
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k) moments[static_cast<std::size_t>(j)][static_cast<std::size_t>(k)] += y[j] * y[k];
    }
  }
  const EigenPair flat = symmetric_eigen(std::move(moments)).front();
  const Vec<Real, 3> normal(flat.vector[0], flat.vector[1], flat.vector[2]);
  Real squared;
  for (const Vec<Real, 3>& x : net.points) {
    const Real height = inner<3>(difference(x, centre), normal);
    squared += height * height;
  }
  const auto realise = [&net, centre, normal, spread, squared]() -> std::optional<ExactNet<3>> {
    const Accuracy accuracy(squared, net.size());
    const int largest = largest_coordinate<3>(normal);
    const Vec<Rational, 3> n = simple_direction<3>(normal, accuracy.tolerance(spread, 3));
    const Vec<Real, 3> near = real_point<3>(n);
    const Rational height = rounded(inner<3>(near, centre), accuracy.exponent() - 1);
    ExactNet<3> result;
    for (Vec<Real, 3> x : net.points) {
      add_scaled(x, (Real::from_rational(height) - inner<3>(near, x)) / inner<3>(near, near), near);
      Vec<Rational, 3> y = rounded_point<3>(x, accuracy.exponent() - 1);
      y[largest] = height;
      for (int j = 0; j < 3; ++j) {
        if (j != largest) y[largest] -= n[j] * y[j];
      }
      result.push_back(std::move(y));
    }
    return result;
  };
  return {.squared = squared, .realise = realise};
}

}  // namespace torse::repair
