// Sturm's theorem.
//   roots_between     the number of distinct real roots in an interval
//   negative_inside   a parameter with a negative value, or that there is none
#pragma once

#include <optional>

#include "torse/fuzz/plain/polynomial.hpp"

namespace torse::fuzz::plain {

/// The number of distinct roots x of f with a < x <= b. f is not zero.
int roots_between(const Poly& f, const Rational& a, const Rational& b);

/// A parameter x with a < x < b and f(x) < 0; nothing means that f >= 0 there, which is proved by the number of roots.
std::optional<Rational> negative_inside(const Poly& f, const Rational& a, const Rational& b);

}  // namespace torse::fuzz::plain
