// The doubles of an input as exact elements of another arithmetic.
//   lift              a double as a double, a RunningError or a Rational        lift_point, lift_row, lift_knots
//   require_within    exact results are within the bounds of computed ones, which are what double computes
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <utility>
#include <vector>

#include "torse/exact/instrumented/running_error.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/fuzz/property.hpp"
#include "torse/spline/knots.hpp"

namespace torse::fuzz {

template <class S>
S lift(double x) {
  if constexpr (std::same_as<S, double>) {
    return x;
  } else {
    return S::from_double(x);
  }
}

template <class S, int D>
Vec<S, D> lift_point(const Vec<double, D>& x) {
  Vec<S, D> lifted;
  for (int j = 0; j < D; ++j) lifted[j] = lift<S>(x[j]);
  return lifted;
}

template <class S, int D>
std::vector<Vec<S, D>> lift_row(const std::vector<Vec<double, D>>& row) {
  std::vector<Vec<S, D>> lifted;
  lifted.reserve(row.size());
  for (const Vec<double, D>& x : row) lifted.push_back(lift_point<S, D>(x));
  return lifted;
}

template <class S>
KnotList<S> lift_knots(int degree, const std::vector<double>& knots) {
  std::vector<S> list;
  list.reserve(knots.size());
  for (const double knot : knots) list.push_back(lift<S>(knot));
  return KnotList<S>(degree, std::move(list));
}

/// Whether every bound is finite.
template <int D>
bool all_known(const std::vector<Vec<RunningError, D>>& row) {
  return std::ranges::all_of(row, [](const Vec<RunningError, D>& x) {
    return std::all_of(x.data(), x.data() + D, [](const RunningError& y) { return std::isfinite(y.bound()); });
  });
}

/// Throws Failed unless the values are those of `rounded`, bit for bit.
template <int D>
void require_same(const std::vector<Vec<RunningError, D>>& computed, const std::vector<Vec<double, D>>& rounded) {
  require(computed.size() == rounded.size(), "a row of another length in doubles");
  for (std::size_t i = 0; i < computed.size(); ++i) {
    for (int j = 0; j < D; ++j) {
      const double x = computed[i][j].value();
      require(x == rounded[i][j] || (std::isnan(x) && std::isnan(rounded[i][j])), "not what double computes");
    }
  }
}

/// Throws Failed unless the exact row is within the bounds, which are finite.
template <int D>
void require_within(const std::vector<Vec<RunningError, D>>& computed, const std::vector<Vec<Rational, D>>& exact) {
  require(computed.size() == exact.size(), "a row of another length in fractions");
  for (std::size_t i = 0; i < computed.size(); ++i) {
    for (int j = 0; j < D; ++j) {
      const Rational error = exact[i][j] - Rational::from_double(computed[i][j].value());
      const Rational bound = Rational::from_double(computed[i][j].bound());
      require(error <= bound && -error <= bound, "farther from the exact result than its bound");
    }
  }
}

}  // namespace torse::fuzz
