// Estimates of work, which the limits of docs/formats.md are about.
//   effort_of, require_effort             of a ruled surface: all commands; most_fit_effort
//   directrix_effort, require_directrix   of the linear system of torse construct directrix
//   branch_effort, require_branches       of the polynomial of torse construct interpolate
#pragma once

#include <string>

#include "torse/exact/rational/rational.hpp"
#include "torse/io/construct_file.hpp"
#include "torse/io/spline_file.hpp"

namespace torse::cli {

/// The sum over all pieces of degree^degree_power bits^bits_power, where a piece's bits are those of the numerators and
/// denominators of the coordinates and weights that act on it.
double effort_of(const RuledFile<Rational>& surface, double degree_power, double bits_power);

/// For the surfaces of torse fit: a quarter of what others may have, since folds and crossings take longer.
inline constexpr int most_fit_effort = 38;

/// Throws FileError where effort_of(surface, 2, 1.5) exceeds 2^most: the exact decision may take some seconds below
/// that. `what` is the surface's name in the error.
void require_effort(const std::string& file, const RuledFile<Rational>& surface, const std::string& what = "a surface",
                    int most = 40);

/// For the N = n + 1 points of c and D = max(deg a, deg b - 1): N^2 min(N, D + 10) (N (p + q) + r)^1.5, p the most bits
/// of a numerator, q and r those of the common denominators of a, b and of c. By Cramer's rule the elimination's
/// numbers have about N (p + q) + r bits; the equations have D + 2 unknowns each, and a point on the right side.
double directrix_effort(const ConstructFile<Rational>& input);

/// Throws InvalidInput naming "c.points" where directrix_effort exceeds 2^38, some seconds.
void require_directrix(const ConstructFile<Rational>& input);

/// For L + 1 control points, between which FJ07.20 makes a polynomial of degree L - 1: L^2 (p + r + L (3 k + l)), p and
/// r the bits of the longest numerator and of the common denominator of points and end rulings, k the same of the
/// knots, l the bits of Lambda, which L factors of FJ07.20-21 hold; knots are weighed as measured.
double branch_effort(const ConstructFile<Rational>& input);

/// Throws InvalidInput naming "c.points" where branch_effort exceeds 2^31, some seconds.
void require_branches(const ConstructFile<Rational>& input);

}  // namespace torse::cli
