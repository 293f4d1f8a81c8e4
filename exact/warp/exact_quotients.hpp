// Quotients of forms with rational coefficients, for the exact stage of the largest warp angle.
//   with_integers      a multiple of a vector of forms that needs no fractions
//   nowhere_above      whether a quotient stays below a limit or attains it
//   scale_for, scaled  a power of 4 that keeps tiny quotients within the range of doubles
#pragma once

#include <vector>

#include "torse/developable/warp.hpp"
#include "torse/exact/rational/rational.hpp"

namespace torse {

/// A positive multiple with integer coefficients: products of these need no reduction of fractions.
FormVector<Rational> with_integers(FormVector<Rational> v);

/// Whether N <= limit D for all s, t >= 0, where D > 0: by the signs of the difference between its roots. It settles
/// limits that are attained.
bool nowhere_above(const SineForms<Rational>& forms, const Rational& limit);

/// The exponent e of a power of 4 such that 4^e times the quotients are near 1 at most: 0 unless they are so small that
/// sin^2 underflows, or all zero. It looks at the lengths of the longest coefficients alone.
long scale_for(const std::vector<SineForms<Rational>>& forms);

/// 4^exponent times a quotient.
SineForms<Rational> scaled(const SineForms<Rational>& forms, long exponent);

}  // namespace torse
