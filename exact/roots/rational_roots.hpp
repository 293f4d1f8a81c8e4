// Rational roots, exactly and without real arithmetic.
//   divide_out_rational_roots      finds and removes them
#pragma once

#include <vector>

#include "torse/exact/rational/rational.hpp"
#include "torse/exact/roots/integer_polynomial.hpp"

namespace torse {

/// The rational roots of the square-free polynomial f, which loses them. With p a prime that divides neither the
/// leading coefficient nor the discriminant, every rational root is the only p-adic root over its residue modulo p;
/// Newton's iteration lifts that until the bounds of its numerator (a divisor of the constant coefficient) and
/// denominator (one of the leading coefficient) leave one candidate.
std::vector<Rational> divide_out_rational_roots(IntegerPolynomial& f);

}  // namespace torse
