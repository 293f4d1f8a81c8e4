// Polynomials by their coefficients of 1, t, t^2, ...: the second path to everything that the library does with
// control points.
//   Poly          plus, times, scaled, value, derivative
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "torse/exact/rational/rational.hpp"

namespace torse::fuzz::plain {

using Poly = std::vector<Rational>;

inline Poly plus(const Poly& f, const Poly& g) {
  Poly sum(std::max(f.size(), g.size()));
  for (std::size_t i = 0; i < f.size(); ++i) sum[i] += f[i];
  for (std::size_t i = 0; i < g.size(); ++i) sum[i] += g[i];
  return sum;
}

inline Poly times(const Poly& f, const Poly& g) {
  if (f.empty() || g.empty()) return {};
  Poly product(f.size() + g.size() - 1);
  for (std::size_t i = 0; i < f.size(); ++i) {
    for (std::size_t j = 0; j < g.size(); ++j) product[i + j] += f[i] * g[j];
  }
  return product;
}

inline Poly scaled(const Rational& factor, Poly f) {
  for (Rational& a : f) a *= factor;
  return f;
}

inline Rational value(const Poly& f, const Rational& t) {
  Rational sum;
  for (std::size_t i = f.size(); i-- > 0;) sum = sum * t + f[i];
  return sum;
}

inline Poly derivative(const Poly& f) {
  Poly df;
  for (std::size_t i = 1; i < f.size(); ++i) df.push_back(Rational(i) * f[i]);
  return df;
}

}  // namespace torse::fuzz::plain
