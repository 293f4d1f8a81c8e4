// The constants of a family at which its nearest net is nearest of all.
//   Projector<D>             a family
//   Descent<D>, descend      Levenberg and Marquardt's method on the projected distance
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "torse/exact/repair/projection.hpp"

namespace torse::repair {

/// A local minimum, or how far the steps went.
template <int D>
struct Descent {
  std::vector<Real> theta;         ///< the constants; the largest of each group is 1
  std::vector<std::size_t> fixed;  ///< which ones are 1: constants matter up to a common factor of a group
  Projection<D> nearest;           ///< the nearest net for them
  bool converged = false;          ///< a further step would change the squared distance by less than a part in 2^20
};

/// Squared distances below this count for zero: the rounding errors of 256 bits.
Real negligible_distance();

/// The nearest net of a family for given constants, or nothing.
template <int D>
using Projector = std::function<std::optional<Projection<D>>(const std::vector<Real>& theta)>;

/// Descends from `theta`, at most 100 steps; no more than 10 where the squared distance is then still 2^20 times
/// `rival`, that of another net. A group are `group` constants that follow each other. Nothing where there is no
/// projection at the start.
template <int D>
std::optional<Descent<D>> descend(const Projector<D>& projector, std::vector<Real> theta, std::size_t group,
                                  const Real& rival);

}  // namespace torse::repair
