// The common zeros of three polynomials, and what is left without them.
//   VectorWithZeros, without_common_zeros      a vector of forms divided by its greatest common divisor
#pragma once

#include <vector>

#include "torse/developable/warp.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/exact/roots/real_roots.hpp"

namespace torse {

/// A vector of forms that vanishes nowhere, for no complex parameter.
struct VectorWithZeros {
  FormVector<Rational> direction;
  std::vector<RealRoot> zeros;  ///< the parameters t of [0, 1] (s = 1 - t) where the original vector vanished, in order
};

/// Divides by the greatest common divisor. Throws InvalidInput naming "vector" for the zero vector.
VectorWithZeros without_common_zeros(const FormVector<Rational>& v);

}  // namespace torse
