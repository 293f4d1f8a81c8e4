// Whether the rulings of a strip leave each other to the same side.
//   RulingTangents    Bernstein coefficients of rulings and of the rails' tangents
//   common_side       a direction that sees this
//   on_one_side       whether it does
#pragma once

#include <span>
#include <vector>

#include "torse/algebra/point.hpp"
#include "torse/scalar/builtin.hpp"
#include "torse/scalar/truth.hpp"

namespace torse {

/// On a part of a strip: w = d - c, a ~ c' and b ~ d', by Bernstein coefficients of any degrees, up to positive
/// factors.
template <Field S>
struct RulingTangents {
  std::vector<Vec<S, 3>> w;
  std::vector<Vec<S, 3>> a;
  std::vector<Vec<S, 3>> b;
};

/// A unit vector e with e . (w(s) x a(t)) >= 0 and e . (w(s) x b(t)) >= 0 for s <= t, by coefficients that are above 0
/// or so small that rounding may have made them; where there is none or none is found, some unit vector, 0 where the
/// normals cancel, NaN where all are zero. That of the largest least product with unit vectors is nearest to 0 in their
/// hull: Wolfe's algorithm goes there. The parts are one behind the other.
Vec<double, 3> common_side(std::span<const RulingTangents<double>> parts);

/// Whether all e . (w(s) x a(t)) and e . (w(s) x b(t)) with s <= t have coefficients of at least 0, and those of no
/// part by itself are all 0, as where both rails run along their ruling; `no` for one below 0, `unknown` where rounding
/// hides a sign. The coefficients are those of w_j x a_i for a part and one behind it; within a part, where rails may
/// begin along a ruling (an edge of regression), those of s = r t by Bernstein polynomials of r and t. If so, no two of
/// the rulings s < t cross, apart from points of a rail: c(t) - c(s), the integral of c', and d(t) - d(s) are on one
/// side of the plane of e and the ruling s. Were both on it, so would be all of the part of s, or of t.
template <Field S>
Truth on_one_side(std::span<const RulingTangents<S>> parts, const Vec<S, 3>& e);

}  // namespace torse
