// A ruled surface (1-v) c(u) + v d(u) between two B-spline curves over one knot list.
//   RuledSpline           knots and two control rows
//   standard_parameter    FJ21.4.1, from the parameter of the homogeneous ruling to that of the affine one
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "torse/spline/curve.hpp"

namespace torse {

/// Control rows c_0..c_L and d_0..d_L over one knot list. P = Vec<S, 3> for polynomial surfaces, Vec<S, 4> (homogeneous
/// rows w (1, c)) for rational ones.
template <Field S, Point<S> P>
struct RuledSpline {
  KnotList<S> knots;
  std::vector<P> c;
  std::vector<P> d;

  /// Throws InvalidInput naming "c.points" or "d.points" for a row whose length does not fit the knots.
  RuledSpline(KnotList<S> u, std::vector<P> first, std::vector<P> second)
      : knots(std::move(u)), c(std::move(first)), d(std::move(second)) {
    check(c, "c.points");
    check(d, "d.points");
  }

  std::span<const P> c_row() const { return c; }
  std::span<const P> d_row() const { return d; }

 private:
  void check(const std::vector<P>& row, const char* place) const {
    if (static_cast<int>(row.size()) != knots.last() + 1) {
      throw InvalidInput(place, "expected " + std::to_string(knots.last() + 1) + " control points, found " +
                                    std::to_string(row.size()));
    }
  }
};

/// V = v omega / ((1-v) w + v omega): the point (1-v) p + v q of the ruling between the rows p = w (1, c) and q = omega
/// (1, d) is (1-V) c + V d (after FJ21.4.1). With w and omega exchanged it is the inverse. Throws DivisionByZero (exact
/// fields) for a point at infinity.
template <Field S>
S standard_parameter(const S& v, const S& w, const S& omega) {
  const S right = v * omega;
  return right / ((from_int<S>(1) - v) * w + right);
}

}  // namespace torse
