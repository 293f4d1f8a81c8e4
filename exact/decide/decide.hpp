// The fast exact decision of developability over Q: find_witness by many primes.
//   find_witness_modular      the same answer as find_witness
#pragma once

#include <optional>
#include <span>

#include "torse/developable/condition.hpp"
#include "torse/exact/rational/rational.hpp"

namespace torse {

/// What find_witness says over Rational, several times faster: the first piece, Bernstein coefficient and its value
/// where the determinant does not vanish; none proves that the surface is developable. D = 3: points of a polynomial
/// surface, D = 4: homogeneous rows; L+1 of them in each row, or InvalidInput naming "points" is thrown.
///
/// A piece whose rows obey a constant relation (relation.hpp) is developable. For the others:
/// a coefficient that is not zero modulo a prime is not zero: the exact coefficients up to the first such one give the
/// witness. A determinant that is zero modulo primes whose product exceeds the bound of bound.hpp is zero. Nothing is
/// left to chance: primes that divide a denominator are not counted.
template <int D>
std::optional<DevelopabilityWitness<Rational>> find_witness_modular(const KnotList<Rational>& u,
                                                                    std::span<const Vec<Rational, D>> c,
                                                                    std::span<const Vec<Rational, D>> d);

}  // namespace torse
