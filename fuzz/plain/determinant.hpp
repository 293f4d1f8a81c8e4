// The determinant that decides a piece, expanded in powers.
//   in_unit_interval       a polynomial over [a, b] in the parameter from 0 to 1
//   twist_polynomial       det(p, p', q, q') of a piece
//   bernstein_coefficients of a polynomial on [0, 1]
#pragma once

#include <vector>

#include "torse/fuzz/plain/truth.hpp"

namespace torse::fuzz::plain {

/// f(a + (b - a) x) as a polynomial in x.
Poly in_unit_interval(const Poly& f, const Rational& a, const Rational& b);

/// det(p, dp/dx, q, dq/dx) of piece j with x from 0 to 1 on it: (b - a)^2 times `twist`. Every product is multiplied
/// out, so that trailing coefficients may be 0.
Poly twist_polynomial(const Strip& strip, int j);

/// The coefficients b_0, ..., b_d of f = sum_i b_i C(d, i) x^i (1-x)^(d-i): b_i = sum_j C(i, j) / C(d, j) a_j. Powers
/// of x above d have coefficient 0 in f.
std::vector<Rational> bernstein_coefficients(const Poly& f, int degree);

}  // namespace torse::fuzz::plain
