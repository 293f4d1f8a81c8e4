// The fast exact decision of developability over Q.
//   find_witness_over_q      the same answer as find_witness
#pragma once

#include <optional>
#include <span>

#include "torse/developable/condition.hpp"
#include "torse/exact/rational/rational.hpp"

namespace torse {

/// What find_witness says over Rational, many times faster: the first piece, Bernstein coefficient and its value where
/// the determinant does not vanish; none proves that the surface is developable. D = 3: points of a polynomial surface,
/// D = 4: homogeneous rows; L+1 of them in each row, or InvalidInput naming "points" is thrown.
///
/// A piece whose rows obey a constant relation is developable (relation.hpp). Another one is iff its determinant
/// vanishes at enough integer parameters (evaluation.hpp); where it does not, the exact coefficients up to the first
/// that is not zero give the witness.
template <int D>
std::optional<DevelopabilityWitness<Rational>> find_witness_over_q(const KnotList<Rational>& u,
                                                                   std::span<const Vec<Rational, D>> c,
                                                                   std::span<const Vec<Rational, D>> d);

}  // namespace torse
