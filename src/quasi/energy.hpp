// The energies of BZZ19 that measure how far a ruling is from developable.
//   developability      E1 (BZZ19.6), a determinant
//   NormalEnergy, normal_energy    E2 (BZZ19.7, 8), with a normal as a variable of its own
//   unit_penalty        (|N|^2 - 1)^2, which keeps the normal from vanishing
#pragma once

#include "torse/algebra/determinant.hpp"
#include "torse/algebra/point.hpp"

namespace torse::quasi {

/// E1 = [C1(t) - C2(T), C1'(t), C2'(T)] (BZZ19.6): 0 iff the tangent planes at both ends of the ruling agree, or one is
/// not defined.
template <Ring S>
S developability(const Vec<S, 3>& c1, const Vec<S, 3>& c1_tangent, const Vec<S, 3>& c2, const Vec<S, 3>& c2_tangent) {
  return det3(difference(c1, c2), c1_tangent, c2_tangent);
}

/// The three products that BZZ19.7 makes zero.
template <class S>
struct NormalEnergy {
  S with_first;   ///< N . C1'(t)
  S with_second;  ///< N . C2'(T)
  S with_ruling;  ///< N . (C1(t) - C2(T))

  /// E2 (BZZ19.8).
  S value() const { return with_first * with_first + with_second * with_second + with_ruling * with_ruling; }
};

/// The products of BZZ19.7.
template <Ring S>
NormalEnergy<S> normal_energy(const Vec<S, 3>& normal, const Vec<S, 3>& c1, const Vec<S, 3>& c1_tangent,
                              const Vec<S, 3>& c2, const Vec<S, 3>& c2_tangent) {
  return {dot(normal, c1_tangent), dot(normal, c2_tangent), dot(normal, difference(c1, c2))};
}

/// (|N|^2 - 1)^2 (BZZ19, section 3.3, F_Reg).
template <Ring S>
S unit_penalty(const Vec<S, 3>& normal) {
  const S excess = dot(normal, normal) - from_int<S>(1);
  return excess * excess;
}

}  // namespace torse::quasi
