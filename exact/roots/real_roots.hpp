// Real roots of polynomials over Q, isolated exactly.
//   RealRoot        an exact rational root, or an interval around an irrational one
//   real_roots      all of them, in order, each once
#pragma once

#include <vector>

#include "torse/exact/rational/rational.hpp"

namespace torse {

/// A real root of a polynomial. A rational root has lower = upper; an irrational one lies in lower < x < upper, and no
/// other root of the polynomial does.
struct RealRoot {
  Rational lower;
  Rational upper;

  bool rational() const { return lower == upper; }
};

/// The distinct real roots of f(x) = sum_i coefficients[i] x^i in increasing order. Rational roots are recognised
/// exactly. The interval of an irrational root is not wider than 2^-bits times its smaller end in absolute value (so it
/// does not contain 0), and it has no point in common with those of the others, ends included. Throws InvalidInput
/// naming "coefficients" for the zero polynomial (or none).
std::vector<RealRoot> real_roots(const std::vector<Rational>& coefficients, int bits);

}  // namespace torse
