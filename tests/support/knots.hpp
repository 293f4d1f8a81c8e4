// Knot lists for tests, written as integers.
#pragma once

#include <utility>
#include <vector>

#include "torse/exact/rational/rational.hpp"
#include "torse/spline/knots.hpp"

namespace torse::test {

inline KnotList<Rational> knots(int degree, const std::vector<int>& list) {
  std::vector<Rational> u;
  for (int knot : list) u.push_back(Rational(knot));
  return KnotList<Rational>(degree, std::move(u));
}

}  // namespace torse::test
