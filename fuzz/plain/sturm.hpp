// Sturm's theorem.
//   roots_between     the number of distinct real roots in an interval
#pragma once

#include "torse/fuzz/plain/polynomial.hpp"

namespace torse::fuzz::plain {

/// The number of distinct roots x of f with a < x <= b. f is not zero.
int roots_between(const Poly& f, const Rational& a, const Rational& b);

}  // namespace torse::fuzz::plain
