// The steps of snapping a mapping to the knots of the second rail.
//   exponent_of           of a number that is not zero
//   last_below            the last short dyadic parameter at which an increasing mapping is not above a value
//   weights_at            sigma at one of its knots as a linear form in the coefficients
//   fit_coefficients      one coefficient changed for each value that sigma is to have at a knot
#pragma once

#include <vector>

#include "torse/algebra/free_module.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/quasi/mapping.hpp"

namespace torse::quasi {

/// A parameter and the value that sigma is to have there.
struct Crossing {
  Rational t;
  Rational value;
};

/// e with 2^(e-1) < |x| < 2^(e+1) for an x that is not zero.
long exponent_of(const Rational& x);

/// The last multiple of a power of two at which sigma, which does not decrease, is at most `value`; the begin of the
/// piece that passes the value where there is none in it. The power is about `share` of that piece. The value is not
/// below the first value of sigma, and below the last.
Rational last_below(const Mapping<Rational>& sigma, const Rational& value, const Rational& share);

/// sigma(t) at the knot t inside the domain: the coefficients with their basis functions there, as generators.
Form<Rational> weights_at(const KnotList<Rational>& u, const Rational& t);

/// Changes one coefficient of sigma for each crossing, a different one, such that sigma(t) is the value there. The
/// crossings, one or more, are at knots inside the domain, in increasing order; neither the first nor the last
/// coefficient of a clamped mapping changes. Among the coefficients of a crossing one is taken that has weight and room
/// up or down to its neighbour; the equations of the crossings have a totally positive matrix and thus a solution
/// (Schoenberg, Whitney).
void fit_coefficients(Mapping<Rational>& sigma, const std::vector<Crossing>& crossings);

}  // namespace torse::quasi
