// The warp angle of one ruling, and how it changes while the ruling's end moves along its rail.
//   RulingTerms, ruling_terms    the products that the angle is made of, with two derivatives
//   RulingAngle, ruling_angle    the angle itself
#pragma once

#include "torse/algebra/determinant.hpp"
#include "torse/quasi/rail.hpp"

namespace torse::quasi {

/// A value with its first and second derivative by T.
template <class S>
struct Taylor {
  S value;
  S first;
  S second;
};

/// For the ruling from c with the tangent a to d(T) with w = d - c and b = d': the normals are m = a x w and n = b x w.
template <class S>
struct RulingTerms {
  Taylor<S> cosine;  ///< m . n
  Taylor<S> volume;  ///< [a, w, b]
  Taylor<S> square;  ///< w . w
};

/// The products and their derivatives by T, from d' = b, d'' = e and d''' = f. In any commutative ring.
template <Ring S>
RulingTerms<S> ruling_terms(const Vec<S, 3>& a, const Vec<S, 3>& w, const Vec<S, 3>& b, const Vec<S, 3>& e,
                            const Vec<S, 3>& f) {
  const S two = from_int<S>(2);
  const Vec<S, 3> m = cross(a, w);
  const Vec<S, 3> m1 = cross(a, b);
  const Vec<S, 3> m2 = cross(a, e);
  const Vec<S, 3> n = cross(b, w);
  const Vec<S, 3> n1 = cross(e, w);
  const Vec<S, 3> n2 = sum(cross(f, w), cross(e, b));
  return {.cosine = {dot(m, n), dot(m1, n) + dot(m, n1), dot(m2, n) + two * dot(m1, n1) + dot(m, n2)},
          .volume = {dot(m, b), dot(m, e), dot(m1, e) + dot(m, f)},
          .square = {dot(w, w), two * dot(w, b), two * (dot(b, b) + dot(w, e))}};
}

/// Which angle a fit makes small.
enum class AngleKind {
  planes,  ///< that of the tangent planes, 0 to 90 degrees: the warp angle
  sides    ///< that of the oriented normals, 0 to 180 degrees: beyond 90 the surface folds over between the rails
};

/// The angle with a sign, in radians, and its derivatives by T. Where a normal vanishes it is not defined: 0, 0, 0.
struct RulingAngle {
  Taylor<double> angle;
  bool folded;  ///< m . n < 0: the normal turns by more than 90 degrees along the ruling
};

/// tan = |w| [a, w, b] / (m . n) (BZZ19, section 5; docs/decisions/0004-warp-angle.md).
RulingAngle ruling_angle(const RulingTerms<double>& terms, AngleKind kind);

/// The same from the jets of the rails.
RulingAngle ruling_angle(const RailJet& c, const RailJet& d, AngleKind kind);

}  // namespace torse::quasi
