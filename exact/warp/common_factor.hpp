// The common zeros of three polynomials, and what is left without them.
//   VectorWithZeros, without_common_zeros      a vector of forms divided by its greatest common divisor
//   zeros_in_unit_interval                     where a form vanishes
//   in_lowest_terms                            the same of a quotient
#pragma once

#include <vector>

#include "torse/developable/warp.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/exact/roots/real_roots.hpp"

namespace torse {

/// A vector of forms that vanishes nowhere, for no complex parameter.
struct VectorWithZeros {
  FormVector<Rational> direction;
  BinaryForm<Rational> divisor;  ///< what it was divided by: its zeros are those of the original vector
};

/// Divides by the greatest common divisor. Throws InvalidInput naming "vector" for the zero vector.
VectorWithZeros without_common_zeros(const FormVector<Rational>& v);

/// The parameters t of [0, 1] (s = 1 - t) where the form vanishes, in order, each once. The form is not zero.
std::vector<RealRoot> zeros_in_unit_interval(const BinaryForm<Rational>& form);

/// The same quotient without common factors of its forms. The denominator has no real zero, so that no factor has one
/// either, and stays positive where it was. Close complex zeros of both forms would keep the bounds of a search high
/// until its intervals are as narrow as the distance of the zeros from the real line.
SineForms<Rational> in_lowest_terms(const SineForms<Rational>& forms);

}  // namespace torse
