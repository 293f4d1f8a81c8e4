// B-spline curves as a knot list with control points, polynomial (points of affine space) or rational (homogeneous
// rows).
//   Spline<S, P>      knots and control net row
//   homogeneous       w_i (1, c_i) from points and weights      dehomogenize   back again
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "torse/spline/blossom.hpp"

namespace torse {

/// A B-spline curve of degree n: control points c_0..c_L over the papers' knot list.
template <Field S, Point<S> P>
struct Spline {
  KnotList<S> knots;
  std::vector<P> control;

  /// Throws InvalidInput naming "points" unless there is one control point for each of 0..L.
  Spline(KnotList<S> u, std::vector<P> c) : knots(std::move(u)), control(std::move(c)) {
    if (static_cast<int>(control.size()) != knots.last() + 1) {
      throw InvalidInput("points", "expected " + std::to_string(knots.last() + 1) + " control points, found " +
                                       std::to_string(control.size()));
    }
  }

  std::span<const P> points() const { return control; }
};

/// Affine control points with their weights.
template <Ring S, int D>
struct WeightedPoints {
  std::vector<Vec<S, D>> points;
  std::vector<S> weights;
};

/// The homogeneous rows p_i = w_i (1, c_i) (FJ21, section 3). Throws InvalidInput naming "weights" for a number of
/// weights that does not match or a weight that is decidedly zero.
template <Ring S, int D>
std::vector<Vec<S, D + 1>> homogeneous(const WeightedPoints<S, D>& net) {
  if (net.weights.size() != net.points.size()) {
    throw InvalidInput(
        "weights", "expected " + std::to_string(net.points.size()) + ", found " + std::to_string(net.weights.size()));
  }
  std::vector<Vec<S, D + 1>> rows(net.points.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (definitely(is_zero(net.weights[i]))) {
      throw InvalidInput("weights[" + std::to_string(i) + "]", "expected a weight that is not zero");
    }
    rows[i][0] = net.weights[i];
    for (int j = 0; j < D; ++j) rows[i][j + 1] = net.weights[i] * net.points[i][j];
  }
  return rows;
}

/// Points and weights of homogeneous rows. Throws InvalidInput naming "weights[i]" for a row whose weight is decidedly
/// zero: a point at infinity has no affine control point.
template <Field S, int E>
WeightedPoints<S, E - 1> dehomogenize(const std::vector<Vec<S, E>>& rows) {
  WeightedPoints<S, E - 1> net;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (definitely(is_zero(rows[i][0]))) {
      throw InvalidInput("weights[" + std::to_string(i) + "]", "is zero: the control point lies at infinity");
    }
    Vec<S, E - 1> point;
    for (int j = 1; j < E; ++j) point[j - 1] = rows[i][j] / rows[i][0];
    net.points.push_back(std::move(point));
    net.weights.push_back(rows[i][0]);
  }
  return net;
}

}  // namespace torse
