// A piece between two neighbouring breaks, where its factors keep their signs; for .cpp files only.
//   Stretch        its polynomials, oriented, as balls, and their values
//   stretches      those of a piece
#pragma once

#include <vector>

#include "torse/exact/unroll/analytic.hpp"
#include "torse/exact/unroll/strip.hpp"

namespace torse {

/// The part of a piece from tau = from() to to().
class Stretch {
 public:
  /// `breaking`: a factor may vanish inside, namely in the interval of an irrational root.
  Stretch(const StripForms<Rational>& forms, Rational from, Rational to, bool breaking);

  const Rational& from() const { return from_; }
  const Rational& to() const { return to_; }
  bool breaking() const { return breaking_; }
  /// The precision that its polynomials need: their coefficients in tau lose up to two bits for each degree.
  slong bits() const { return bits_; }

  /// Values at a complex ball.
  Strip<DiscBall> at(const arb::Complex& tau) const;
  /// Taylor series around `middle`, complete; of what strip_rates does not need (spin2, fold), zero.
  Strip<arb::RealPoly> around(const arb::Real& middle) const;
  /// |D - C| at a parameter.
  arb::Real ruling(const Rational& tau) const;

 private:
  Rational from_;
  Rational to_;
  bool breaking_;
  slong bits_ = 0;
  Strip<arb::RealPoly> terms_{};
  Strip<arb::RealPoly> for_rates_{};
};

/// A piece cut at its breaks and at those of the parameters `marks` (the file's) that lie in it, in order.
std::vector<Stretch> stretches(const PieceStrip& strip, const std::vector<Rational>& marks);

}  // namespace torse
