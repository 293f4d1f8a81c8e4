// Symmetric equations whose matrix has entries near its diagonal only.
//   BandedFactors      Cholesky's factors without square roots
#pragma once

#include <optional>
#include <vector>

#include "torse/algebra/point.hpp"
#include "torse/exact/repair/real.hpp"

namespace torse::repair {

/// A = L D L^T with ones on the diagonal of L.
class BandedFactors {
 public:
  /// Takes the lower half of A: below[r] holds row r from its first entry that is not zero up to column r - 1. Nothing
  /// unless A is positive definite beyond rounding errors.
  static std::optional<BandedFactors> of(std::vector<std::vector<Real>> below, std::vector<Real> diagonal);

  /// The diagonal of D.
  const std::vector<Real>& pivots() const { return pivots_; }

  /// b becomes L^{-1} b; b has a point for each row.
  template <class P>
  void forward(std::vector<P>& b) const {
    for (std::size_t r = 0; r < b.size(); ++r) {
      for (std::size_t s = first(r); s < r; ++s) add_scaled(b[r], -left_of(r, s), b[s]);
    }
  }

  /// b becomes L^{-T} D^{-1} b. After forward, b becomes A^{-1} b.
  template <class P>
  void backward(std::vector<P>& b) const {
    for (std::size_t r = 0; r < b.size(); ++r) divide(b[r], pivots_[r]);
    for (std::size_t r = b.size(); r-- > 0;) {
      for (std::size_t s = first(r); s < r; ++s) add_scaled(b[s], -left_of(r, s), b[r]);
    }
  }

 private:
  std::size_t first(std::size_t r) const { return r - left_[r].size(); }
  const Real& left_of(std::size_t r, std::size_t s) const { return left_[r][s - first(r)]; }

  std::vector<std::vector<Real>> left_;
  std::vector<Real> pivots_;
};

}  // namespace torse::repair
