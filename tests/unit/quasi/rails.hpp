// Rails for tests: in rational numbers, whose doubles are exact, and as polynomials in T.
//   ExactCurve, drawn_curve    homogeneous rows with small dyadic coordinates and weights
//   in_doubles                 the rail of an exact curve
//   Polynomials                three coordinates in powers of T: plus, times, derivative, compose
//   rail_of                    the Bezier curve of polynomials over [0, 1]
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "torse/algebra/polynomial.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/quasi/rail.hpp"

namespace torse::test {

using Q = Rational;
using ExactCurve = Spline<Q, Vec<Q, 4>>;

/// A multiple of 1/16 in [-1, 1].
inline Q sixteenths(std::mt19937_64& rng) { return ratio<Q>(static_cast<int>(rng() % 33) - 16, 16); }

/// A curve with random points; of weight 1, or with weights 1/2, 5/8, ..., 3/2 times `sign`.
inline ExactCurve drawn_curve(const KnotList<Q>& u, bool rational, std::uint64_t seed, int sign = 1) {
  std::mt19937_64 rng(seed);
  std::vector<Vec<Q, 4>> rows;
  for (int i = 0; i <= u.last(); ++i) {
    const Q w = rational ? ratio<Q>(sign * (4 + static_cast<int>(rng() % 9)), 8) : Q(1);
    Vec<Q, 4> row;
    row[0] = w;
    for (int j = 1; j < 4; ++j) row[j] = w * sixteenths(rng);
    rows.push_back(row);
  }
  return ExactCurve(u, rows);
}

inline Spline<double, Vec<double, 4>> rounded(const ExactCurve& curve) {
  std::vector<double> knots;
  for (const Q& knot : curve.knots.list()) knots.push_back(knot.to_double());
  std::vector<Vec<double, 4>> rows;
  for (const Vec<Q, 4>& row : curve.control) {
    rows.emplace_back(row[0].to_double(), row[1].to_double(), row[2].to_double(), row[3].to_double());
  }
  return {KnotList<double>(curve.knots.degree(), knots), rows};
}

inline quasi::Rail in_doubles(const ExactCurve& curve) { return quasi::Rail(rounded(curve)); }

/// Three polynomials, or as many functions of T.
using Polynomials = std::array<Polynomial<Q>, 3>;

/// From the coefficients of 1, T, T^2, ..., in hundredths.
inline Polynomial<Q> hundredths(const std::vector<int>& list) {
  std::vector<Q> a;
  for (const int x : list) a.push_back(ratio<Q>(x, 100));
  return Polynomial<Q>(std::move(a));
}

inline Polynomials plus(const Polynomials& f, const Polynomials& g) { return {f[0] + g[0], f[1] + g[1], f[2] + g[2]}; }

inline Polynomials times(const Polynomial<Q>& a, const Polynomials& f) { return {a * f[0], a * f[1], a * f[2]}; }

inline Polynomials derivative(const Polynomials& f) {
  return {f[0].derivative(), f[1].derivative(), f[2].derivative()};
}

inline Polynomials compose(const Polynomials& f, const Polynomial<Q>& g) {
  return {f[0].compose(g), f[1].compose(g), f[2].compose(g)};
}

/// Its Bezier points: the blossom of T^k at i ones of n is C(i, k) / C(n, k).
inline quasi::Rail rail_of(const Polynomials& f) {
  int degree = 1;
  for (const Polynomial<Q>& x : f) degree = std::max(degree, x.degree());
  std::vector<Vec<double, 4>> rows;
  for (int i = 0; i <= degree; ++i) {
    Vec<double, 4> row(1, 0, 0, 0);
    for (std::size_t j = 0; j < 3; ++j) {
      Q sum(0);
      Q share(1);
      for (int k = 0; k <= std::min(i, f[j].degree()); ++k) {
        sum += share * f[j][k];
        share *= ratio<Q>(i - k, std::max(degree - k, 1));
      }
      row[static_cast<int>(j) + 1] = sum.to_double();
    }
    rows.push_back(row);
  }
  return quasi::Rail(Spline<double, Vec<double, 4>>(bezier_knots<double>(degree), rows));
}

}  // namespace torse::test
