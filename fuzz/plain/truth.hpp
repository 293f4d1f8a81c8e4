// Verdicts on ruled surfaces by their definitions, evaluated at parameters in fractions: no polynomial identities, no
// blossoms.
//   twist                the determinant of p, p', q, q' at a parameter         refuted     somewhere it is not 0
//   holds_by_samples     it is 0 at enough parameters to be 0 everywhere
//   ClassTruth           a class and the point common to all rulings            class_of    of a developable surface
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "torse/fuzz/plain/pieces.hpp"

namespace torse::fuzz::plain {

/// Two boundary curves as homogeneous rows, over the same breaks.
struct Strip {
  Pieces<4> p;
  Pieces<4> q;
};

/// The strip of two control rows; points of space have weight 1.
Strip strip_of(const KnotList<Rational>& u, const std::vector<Vec<Rational, 4>>& p,
               const std::vector<Vec<Rational, 4>>& q);
Strip strip_of(const KnotList<Rational>& u, const std::vector<Vec<Rational, 3>>& c,
               const std::vector<Vec<Rational, 3>>& d);

/// det(p, p', q, q') at t on piece j: 0 on all of them iff the surface is developable. For weights 1 it is [c', d-c,
/// d'].
Rational twist(const Strip& strip, int j, const Rational& t);

/// Whether the determinant differs from 0 at one of a few parameters: that proves that the surface is not developable.
bool refuted(const Strip& strip, int samples = 3);

/// Whether it is 0 at more parameters of each piece than its degree, which proves that the surface is developable.
bool holds_by_samples(const Strip& strip);

/// What all rulings have in common.
struct ClassTruth {
  std::string_view name;
  /// The only point on all rulings, a homogeneous row; none for planes and tangent surfaces.
  std::optional<Vec<Rational, 4>> common{};
};

/// The smallest class of a developable surface: plane (all points in one), cone or cylinder (all rulings through one
/// finite or infinite point), tangent. `p` and `q` are the control rows. A point that is known to lie on all rulings
/// saves work. Rulings of length zero pass through every point; a surface that has no others and is not planar is a
/// cylinder, and so is one whose others all lie on one line.
ClassTruth class_of(const KnotList<Rational>& u, const std::vector<Vec<Rational, 4>>& p,
                    const std::vector<Vec<Rational, 4>>& q, bool common_point_known = false);

}  // namespace torse::fuzz::plain
