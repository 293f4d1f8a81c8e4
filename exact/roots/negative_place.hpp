// Where a polynomial is negative.
//   negative_place      a rational parameter where it is, found exactly
#pragma once

#include <optional>

#include "torse/algebra/bernstein.hpp"
#include "torse/exact/rational/rational.hpp"

namespace torse {

/// A t in [0, 1] with f(t) < 0, none iff f >= 0 on all of [0, 1]: looked for by halvings, which most polynomials need
/// few of, and then between any two neighbouring real roots.
std::optional<Rational> negative_place(const Bernstein<Rational>& f);

}  // namespace torse
