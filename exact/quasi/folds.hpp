// Whether a ruled surface folds over between its rails: exactly, for every parameter.
//   RulingPlace      a ruling
//   find_fold        one where it does, by the sign of m . n
#pragma once

#include <optional>
#include <span>

#include "torse/algebra/eigen.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/spline/knots.hpp"

namespace torse {

/// A ruling: its parameter in the knot list and the piece it is taken from.
struct RulingPlace {
  int piece;
  Rational parameter;
};

/// A ruling with m . n < 0, none iff m . n >= 0 on the whole surface, with the normals m = c' x (d - c) and
/// n = d' x (d - c) at the two ends of a ruling. Along the ruling the surface's normal is (1-v) m + v n up to length.
/// Where m . n > 0 it never vanishes and turns by less than 90 degrees: the ruling is regular, and no edge of
/// regression meets it between the rails. Where m . n < 0 it turns by more; a developable ruling, whose normals are
/// parallel, has its singular point between the rails then. D = 3: points of a polynomial surface, D = 4: homogeneous
/// rows with weights of one sign.
template <int D>
std::optional<RulingPlace> find_fold(const KnotList<Rational>& u, std::span<const Vec<Rational, D>> c,
                                     std::span<const Vec<Rational, D>> d);

}  // namespace torse
