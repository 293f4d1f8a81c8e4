// The point of a hull nearest to 0, and so a direction that sees all points of a set on one side.
//   nearest_in_hull    by Wolfe's algorithm, in doubles
#pragma once

#include <functional>

#include "torse/algebra/eigen.hpp"

namespace torse {

/// A point x of the hull of some points in space such that the least product of x and one of them is above good *
/// |x|^2, 0 < good < 1: all of them are on the side of x, and near 1 it is the one nearest to 0, whose least product is
/// |x|^2. 0 where the hull contains 0. All of this but for rounding: what depends on it is asked of the points again.
/// `lowest` gives the point with the least product with a direction.
/// Wolfe, Finding the nearest point in a polytope, Mathematical Programming 11 (1976).
Vec<double, 3> nearest_in_hull(const std::function<Vec<double, 3>(const Vec<double, 3>&)>& lowest, double good);

}  // namespace torse
