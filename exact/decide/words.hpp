// Exact results in words, for terminals and test reports.
//   short_number     an exact number in at most about 24 characters
//   decimal_above    a bound in few digits that is still one       decimal_below
//   describe         what refutes developability
#pragma once

#include <string>

#include "torse/developable/condition.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/spline/knots.hpp"

namespace torse {

/// The number itself if it is short, else "about" its value to six digits, or a power of two beyond the range of
/// double.
std::string short_number(const Rational& x);

/// Of the decimal numbers with so many significant digits (at most 15) the nearest to x >= 0 that, read as a double, is
/// not below it, or not above it. As printf writes it with %g.
std::string decimal_above(double x, int digits);
std::string decimal_below(double x, int digits);

/// "piece 2, u from 1/3 to 1: coefficient 3 of the determinant is -1/7".
std::string describe(const DevelopabilityWitness<Rational>& witness, const KnotList<Rational>& knots);

}  // namespace torse
