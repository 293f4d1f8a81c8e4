// The nearest net of a family whose constants are known, and how its distance depends on them.
//   Projection<D>, project       least squares under the equations of a BilinearSystem
//   first_constants              constants to start from: algebraic fits
//
// With the equations B(theta) x = 0 for the points x, and K the diagonal matrix of the net's scales, the nearest net is
// x - e with e = K B^T mu, (B K B^T) mu = B x, at the squared distance f = mu . B x. By the envelope theorem the
// derivative of f by the constant theta_m is 2 mu . B_m (x - e), B_m being the coefficients of theta_m. With Y the
// matrix of the columns B_m x, Gauss and Newton's approximation of half the second derivative is Y^T (B K B^T)^{-1} Y.
// B K B^T is banded, so the cost is linear in the number of points.
#pragma once

#include <optional>
#include <vector>

#include "torse/exact/repair/bilinear.hpp"
#include "torse/exact/repair/frame.hpp"
#include "torse/exact/repair/symmetric.hpp"

namespace torse::repair {

template <int D>
struct Projection {
  Real squared;                      ///< f
  std::vector<Vec<Real, D>> change;  ///< e: the nearest net is the net less this
  std::vector<Real> slope;           ///< half the derivative of f by the constants
  Matrix curvature;                  ///< half its second derivative, approximately
};

/// Nothing where the equations are dependent, at which constants f has no derivative.
template <int D>
std::optional<Projection<D>> project(const BilinearSystem<Real>& system, const RealNet<D>& net,
                                     const std::vector<Real>& theta);

/// Vectors of constants in the order of the sum of squares of their equations, the smallest first.
template <int D>
std::vector<std::vector<Real>> first_constants(const BilinearSystem<Real>& system, const RealNet<D>& net);

}  // namespace torse::repair
