// The factorisation row by row.
#include "torse/exact/repair/banded.hpp"

#include <algorithm>
#include <utility>

namespace torse::repair {

std::optional<BandedFactors> BandedFactors::of(std::vector<std::vector<Real>> below, std::vector<Real> diagonal) {
  const Real rounding = Real::from_rational(power_of_two(32 - Real::precision));
  BandedFactors factors;
  for (std::size_t r = 0; r < diagonal.size(); ++r) {
    std::vector<Real>& row = below[r];
    const std::size_t begin = r - row.size();
    Real pivot = diagonal[r];
    for (std::size_t s = begin; s < r; ++s) {
      Real x = row[s - begin];
      for (std::size_t t = std::max(begin, factors.first(s)); t < s; ++t) {
        x -= row[t - begin] * factors.pivots_[t] * factors.left_of(s, t);
      }
      row[s - begin] = x / factors.pivots_[s];
      pivot -= row[s - begin] * x;
    }
    if (!(pivot > diagonal[r] * rounding)) return std::nullopt;
    factors.left_.push_back(std::move(row));
    factors.pivots_.push_back(pivot);
  }
  return factors;
}

}  // namespace torse::repair
