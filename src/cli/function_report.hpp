// Polynomials and rational functions of t as reports show them: with integer coefficients.
//   integer_coefficients      a common multiple of polynomials with integer coefficients of content 1
//   coefficients_json         such a list as JSON       function_json, function_text     of a rational function
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "torse/algebra/polynomial_fraction.hpp"
#include "torse/exact/rational/rational.hpp"

namespace torse::cli {

using RationalPolynomial = Polynomial<Rational>;
using RationalFunctionOfT = PolynomialFraction<Rational>;

/// The polynomials times one positive rational number, so that all coefficients are integers without a common divisor.
/// All zero stays so.
std::vector<RationalPolynomial> integer_coefficients(const std::vector<RationalPolynomial>& polynomials);

/// The integer coefficients of 1, t, t^2, ..., [0] for zero. An integer beyond 2^53 in absolute value is a string.
nlohmann::ordered_json coefficients_json(const RationalPolynomial& f);

/// {"num": [...], "den": [...]}, reduced, content 1, leading coefficient of den positive; null for none.
nlohmann::ordered_json function_json(const std::optional<RationalFunctionOfT>& f);

/// "(9t^2 - 3t - 32)/(-18t + 9)"; a long one is described by its degrees.
std::string function_text(const RationalFunctionOfT& f);

}  // namespace torse::cli
