// Points of the search: scalar products, and short exact points and directions near them.
//   inner, real_point, largest_coordinate
//   rounded_point        to multiples of a power of two
//   simple_direction     simple fractions in about the same proportion
#pragma once

#include "torse/algebra/point.hpp"
#include "torse/exact/repair/real.hpp"

namespace torse::repair {

/// x . y.
template <int D>
Real inner(const Vec<Real, D>& x, const Vec<Real, D>& y) {
  Real sum;
  for (int j = 0; j < D; ++j) sum += x[j] * y[j];
  return sum;
}

/// The point rounded to Real.
template <int D>
Vec<Real, D> real_point(const Vec<Rational, D>& x) {
  Vec<Real, D> result;
  for (int j = 0; j < D; ++j) result[j] = Real::from_rational(x[j]);
  return result;
}

/// The index of the largest coordinate in absolute value.
template <int D>
int largest_coordinate(const Vec<Real, D>& x) {
  int largest = 0;
  for (int j = 1; j < D; ++j) {
    if (magnitude(x[j]) > magnitude(x[largest])) largest = j;
  }
  return largest;
}

/// Every coordinate rounded to a multiple of 2^exponent.
template <int D>
Vec<Rational, D> rounded_point(const Vec<Real, D>& x, long exponent) {
  Vec<Rational, D> result;
  for (int j = 0; j < D; ++j) result[j] = rounded(x[j], exponent);
  return result;
}

/// Simple fractions in the proportion of the coordinates; the largest is 1, the others move by at most `tolerance`.
template <int D>
Vec<Rational, D> simple_direction(const Vec<Real, D>& x, const Real& tolerance) {
  const int largest = largest_coordinate<D>(x);
  Vec<Rational, D> result;
  for (int j = 0; j < D; ++j) {
    result[j] = j == largest ? Rational(1) : simplest_near(x[j] / x[largest], tolerance);
  }
  return result;
}

}  // namespace torse::repair
