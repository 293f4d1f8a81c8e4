// What the exact stage of the largest warp angle may cost, estimated from the lengths of the numbers.
//   exact_work      of making the quotients of some pieces
//   exact_cost      of a step of the search in them
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "torse/exact/rational/rational.hpp"
#include "torse/exact/warp/surface.hpp"

namespace torse {

/// Products of coefficients times their bits. The normals' product a x w x b x w, without its denominators, is as
/// long as four of the longest numerators with the denominators of both rows thrice, and as what the knots and
/// binomials add; the weights double the degree in the control points.
template <int D>
double exact_work(const Surface<Rational, D>& surface, const std::vector<int>& pieces) {
  constexpr double bits_per_degree = 64;
  const int n = surface.knots.degree();
  const double products = std::pow(sine_degree<D>(n) + 1, 2);
  double work = 0;
  for (const int k : pieces) {
    std::size_t numerator = 0;
    std::size_t denominators = 0;
    for (const auto* row : {&surface.c, &surface.d}) {
      for (int i = k - 1; i < k + n; ++i) {
        for (int j = 0; j < D; ++j) {
          const Rational& x = (*row)[static_cast<std::size_t>(i)][j];
          numerator = std::max(numerator, x.numerator_bits());
          denominators += x.denominator_bits();
        }
      }
    }
    const double bits = static_cast<double>(4 * numerator + 3 * denominators) + bits_per_degree * n;
    work += (D - 2) * bits * products;
  }
  return work;
}

/// The cost of a step, one in doubles being 1. Longer numbers cost more.
template <int D>
double exact_cost(const Surface<Rational, D>& surface) {
  std::size_t most = 0;
  for (const auto* row : {&surface.c, &surface.d}) {
    for (const Vec<Rational, D>& x : *row) {
      for (int j = 0; j < D; ++j) most = std::max(most, x[j].numerator_bits() + x[j].denominator_bits());
    }
  }
  return 3000 * std::max(1.0, static_cast<double>(most) / 512);
}

}  // namespace torse
