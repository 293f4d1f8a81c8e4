// Curves and strips rewritten piece by piece, in polynomials.
//   Substitution       t = (a s + b) / (c s + d)         substituted     a curve of degree n in s, times (c s + d)^n
//   multiplied         a curve times a polynomial        added           two curves over the same breaks
#pragma once

#include "torse/fuzz/plain/pieces.hpp"

namespace torse::fuzz::plain {

/// t = (a s + b) / (c s + d), a d - b c not 0.
struct Substitution {
  Rational a{1};
  Rational b{0};
  Rational c{0};
  Rational d{1};

  /// The s that belongs to t. Not at t = a/c.
  Rational inverse(const Rational& t) const { return (d * t - b) / (a - c * t); }
};

/// The rows times (c s + d)^degree as functions of s, in the order of s. The pole must be outside the domain.
Pieces<4> substituted(const Pieces<4>& curve, int degree, const Substitution& by);

Pieces<4> multiplied(const Poly& factor, const Pieces<4>& curve);
Pieces<4> added(const Pieces<4>& x, const Pieces<4>& y);

/// The curve on [a, b] within its domain.
Pieces<4> trimmed(const Pieces<4>& curve, const Rational& a, const Rational& b);

}  // namespace torse::fuzz::plain
