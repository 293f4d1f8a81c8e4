// The arithmetic of the search for the nearest developable net, and the way from its results to short exact numbers.
//   Real               256 bits: the squared distance of a net from doubles rounded in the last place keeps 100 of them
//   magnitude, power_of_two, exponent_of
//   rounded            to a multiple of a power of two
//   simplest_near      the fraction with the smallest denominator in an interval
#pragma once

#include "torse/exact/bigfloat/bigfloat.hpp"
#include "torse/exact/rational/rational.hpp"

namespace torse::repair {

using Real = BigFloat<256>;

/// |x|.
Real magnitude(const Real& x);

/// 2^exponent.
Rational power_of_two(long exponent);

/// e with 2^(e-1) <= |x| < 2^e; for zero the smallest exponent that MPFR has.
long exponent_of(const Real& x);

/// The multiple of 2^exponent nearest to x, halves upwards. Throws InvalidInput for NaN and infinities.
Rational rounded(const Real& x, long exponent);
Rational rounded(const Rational& x, long exponent);

/// The fraction with the smallest denominator in [x - tolerance, x + tolerance]. Throws InvalidInput for NaN and
/// infinities.
Rational simplest_near(const Real& x, const Real& tolerance);

}  // namespace torse::repair
