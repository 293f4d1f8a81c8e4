// Eigen's traits for every torse scalar that is a class: this is the only file that specialises them. Vectors only add,
// scale and multiply; Eigen's decompositions are not used on these scalars.
#pragma once

#include <Eigen/Core>
#include <type_traits>

#include "torse/scalar/concepts.hpp"

namespace Eigen {

// Eigen's own arrays have traits of Eigen; they are asked first, as the question whether one is a ring needs its
// traits.
template <class S>
requires(std::is_class_v<S> && !std::is_base_of_v<EigenBase<S>, S> && torse::Ring<S>) struct NumTraits<S>
    : GenericNumTraits<S> {
  using Real = S;
  using NonInteger = S;
  using Literal = S;
  using Nested = S;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 8,
    AddCost = 64,
    MulCost = 64
  };
};

}  // namespace Eigen

namespace torse {

/// A column of D coordinates over S.
template <class S, int D>
using Vec = Eigen::Matrix<S, D, 1>;

}  // namespace torse
