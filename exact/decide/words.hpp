// Exact results in words, for terminals and test reports.
//   short_number     an exact number in at most about 24 characters
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

/// "piece 2, u from 1/3 to 1: coefficient 3 of the determinant is -1/7".
std::string describe(const DevelopabilityWitness<Rational>& witness, const KnotList<Rational>& knots);

}  // namespace torse
