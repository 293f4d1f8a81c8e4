// The a-priori bound of docs/findings.md for FJ07.13.rulings.
//   gamma             k u / (1 - k u)
//   rulings_bound     of each coordinate of each vertex
#pragma once

#include <vector>

#include "torse/exact/rational/rational.hpp"
#include "torse/studies/inputs.hpp"

namespace torse::studies {

/// gamma_k for the unit roundoff u = 2^-precision. Throws InvalidInput for k u >= 1.
Rational gamma(int k, int precision);

/// For net_from from vertex `k` in arithmetic of `precision` bits that neither over- nor underflows: bounds of
/// |computed - exact| for the coordinates of d_0, d_1, ..., three each, with P(a, b) the product of the ratios
/// (M*-u_{i+n})/(M*-u_i), or of their inverses behind k:
///   u |d_N| + (1+u) ( gamma_{5 s + 1} |P| |d_k - c_k| + |L*-M*| sum_i gamma_{5 s_i + 1} |P_i| |c_{i+1}-c_i| / |M*-u_i|
///   ),
/// s and s_i the steps from k, or from the term's own cell, to N. `in` are exact inputs, `d` the exact net. Proved in
/// proofs/coq: rounding_net and rounding_net_down, for doubles rounding_binary64_net and rounding_binary64_net_down.
std::vector<Rational> rulings_bound(const Inputs<Rational>& in, const std::vector<Rational>& d, int k,
                                    const Vec<Rational, 3>& dk, int precision);

}  // namespace torse::studies
