// The step of Newton's method for mappings that must not decrease: a quadratic model over ordered coefficients.
//   BandedMatrix       symmetric, with entries near its diagonal only
//   MonotoneModel      the minimum of a quadratic function over 0 <= x_0 <= x_1 <= ... <= 1
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "torse/quasi/search.hpp"

namespace torse::quasi {

/// A symmetric n x n matrix whose entries (i, j) with |i - j| > width are 0.
class BandedMatrix {
 public:
  BandedMatrix(std::size_t size, std::size_t width) : size_(size), width_(width), entries_((width + 1) * size, 0) {}

  std::size_t size() const { return size_; }
  std::size_t width() const { return width_; }
  /// The entry (i, i + k), k <= width.
  double& at(std::size_t i, std::size_t k) { return entries_[k * size_ + i]; }
  double at(std::size_t i, std::size_t k) const { return entries_[k * size_ + i]; }

  void clear(std::size_t size) {
    size_ = size;
    entries_.assign((width_ + 1) * size, 0);
  }
  /// With x + damping (x + 1e-6 l) + 1e-12 l in place of each diagonal entry x, l being the largest one. A matrix that
  /// is not negative and not 0 becomes positive definite.
  BandedMatrix damped(double damping) const;
  /// The product with x.
  void multiply(std::span<const double> x, std::span<double> y) const;
  /// b becomes the solution of A x = b and the matrix its factors L D L^T. A must be positive definite.
  void solve(std::span<double> b);

 private:
  std::size_t size_;
  std::size_t width_;
  std::vector<double> entries_;
};

/// min 1/2 (x - b)^T H (x - b) + g^T (x - b) over 0 <= x_0 <= x_1 <= ... <= x_{n-1} <= 1, with x_0 = 0 and x_{n-1} = 1
/// for fixed ends. Neighbours that are held equal are tied into one unknown. Which ones are is found by the primal-dual
/// active set method and kept for the next call, since near the end of a descent it does not change any more.
class MonotoneModel {
 public:
  MonotoneModel(std::size_t size, std::size_t width, Ends ends);

  /// Takes a positive definite H and a b that obeys the constraints. The result obeys them whatever happens: where H is
  /// so nearly singular that the solution is not finite, it is b.
  std::vector<double> minimize(const BandedMatrix& h, std::span<const double> g, std::span<const double> b);

 private:
  void solve_tied(const BandedMatrix& h, std::span<const double> target);
  bool untie(std::span<const double> force);
  bool tie();

  Ends ends_;
  std::vector<char> tied_;          // tied_[i]: x_{i-1} = x_i, where x_{-1} = 0 and x_n = 1
  std::vector<std::size_t> group_;  // the unknown that x_i belongs to
  BandedMatrix reduced_;
  std::vector<double> unknowns_;
  std::vector<double> x_;
};

}  // namespace torse::quasi
