// Rails in doubles: quick evaluation of B-spline curves with three derivatives, from Bezier pieces.
//   RailJet          c, c', c'', c''' at a parameter
//   Rail             a curve over [0, 1]
//   Rails            two of them
#pragma once

#include <span>
#include <vector>

#include "torse/scalar/builtin.hpp"
#include "torse/spline/curve.hpp"

namespace torse::quasi {

using Vector = Vec<double, 3>;

/// A point of a curve with its derivatives.
struct RailJet {
  Vector point;
  Vector first;
  Vector second;
  Vector third;
};

/// A polynomial or rational B-spline curve over [0, 1], whatever its domain was. Beyond the ends the polynomials of the
/// first and the last piece go on.
class Rail {
 public:
  /// Takes homogeneous rows w (1, c). Throws InvalidInput naming "points" for numbers that are not finite.
  explicit Rail(const Spline<double, Vec<double, 4>>& curve);

  /// Takes Bezier pieces: the ends of their intervals, 0 first and 1 last, each after the one before, and degree + 1
  /// homogeneous rows for each piece. Throws like the other.
  Rail(int degree, std::vector<double> breaks, std::vector<Vec<double, 4>> control);

  /// The curve and its derivatives at t.
  RailJet operator()(double t) const;

  /// The ends of the Bezier pieces, 0 first and 1 last.
  std::span<const double> breaks() const { return breaks_; }
  int degree() const { return degree_; }

 private:
  int degree_;
  std::vector<double> breaks_;
  std::vector<double> rates_;  // 1 / length of each piece
  // degree + 1 for each piece: points of a polynomial curve, rows of a rational one
  std::vector<Vector> points_;
  std::vector<Vec<double, 4>> rows_;
};

/// The two rails of a strip: the ruling at t joins c(t) and d(sigma(t)).
struct Rails {
  Rail c;
  Rail d;
};

}  // namespace torse::quasi
