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

/// On a part of a strip: w = d - c, and a ~ c' and b ~ d', by coefficients of any degree, up to positive factors.
template <Field S>
struct RulingTangents {
  std::vector<Vec<S, 3>> w;
  std::vector<Vec<S, 3>> rails;  ///< those of a, then those of b
};

/// A unit vector e with e . (w_j x t_i) > 0 for all rulings and all tangents of the rails of these parts, zeros left
/// out; where there is none or none is found, some unit vector, 0 where the normals cancel, NaN where all are zero.
/// That of the largest least product with unit vectors is nearest to 0 in their hull: Gilbert's algorithm goes there.
Vec<double, 3> common_side(std::span<const RulingTangents<double>> parts);

/// Whether all e . (w_j x t_i) are at least 0 and those of no part by itself are all 0, as where both rails run along
/// their ruling; `no` for a product below 0, `unknown` where rounding hides a sign. If so, no two of the rulings cross,
/// apart from points of a rail.
template <Field S>
Truth on_one_side(std::span<const RulingTangents<S>> parts, const Vec<S, 3>& e);

}  // namespace torse
