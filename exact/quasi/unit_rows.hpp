// Rows of exact numbers brought to a size that doubles have room around.
//   bring_to_one    by a power of two
#pragma once

#include <algorithm>
#include <vector>

#include "torse/algebra/point.hpp"
#include "torse/exact/quasi/crossing.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/exact/repair/real.hpp"

namespace torse {

/// Multiplies all rows by the power of two with which the largest of their first `entries` numbers is between 1/2 and
/// 2, so that products of tiny numbers are no zeros in doubles; rows whose first numbers are all 0 stay as they are.
template <int D>
void bring_to_one(std::vector<Vec<Rational, D>>& rows, int entries) {
  Rational largest(0);
  for (const Vec<Rational, D>& x : rows) {
    for (int k = 0; k < entries; ++k) largest = std::max(largest, x[k].sign() < 0 ? Rational(-x[k]) : Rational(x[k]));
  }
  if (largest.sign() == 0) return;
  const Rational factor = repair::power_of_two(-quasi::exponent_of(largest));
  for (Vec<Rational, D>& x : rows) scale(x, factor);
}

}  // namespace torse
