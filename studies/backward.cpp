#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "torse/studies/measure.hpp"

namespace torse::studies {

std::optional<double> least_perturbation(const std::vector<std::vector<double>>& weighed,
                                         const std::vector<double>& errors) {
  const double size = std::abs(*std::ranges::max_element(errors, {}, [](double x) { return std::abs(x); }));
  if (size == 0) return 0;
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(weighed.size()), static_cast<Eigen::Index>(weighed.front().size()));
  Eigen::VectorXd right(matrix.rows());
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    const std::vector<double>& row = weighed[static_cast<std::size_t>(i)];
    double largest = 0;
    for (const double x : row) largest = std::max(largest, std::abs(x));
    const double scale = largest > 0 ? 1 / largest : 1;
    for (Eigen::Index k = 0; k < matrix.cols(); ++k) matrix(i, k) = scale * row[static_cast<std::size_t>(k)];
    right(i) = scale * errors[static_cast<std::size_t>(i)];
  }
  const Eigen::VectorXd e = matrix.completeOrthogonalDecomposition().solve(right);
  constexpr double explained = 1e-6;
  const double rest = (matrix * e - right).norm();
  if (!(rest <= explained * right.norm())) return std::nullopt;
  return e.cwiseAbs().maxCoeff();
}

}  // namespace torse::studies
