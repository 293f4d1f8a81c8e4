// Whether a ruled surface folds over between its rails: exactly, for every parameter.
//   FoldVerdict         yes, no or unknown, with a ruling that shows it
//   decide_folds        by the sign of m . n
#pragma once

#include <optional>
#include <span>

#include "torse/algebra/eigen.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/scalar/truth.hpp"
#include "torse/spline/knots.hpp"

namespace torse {

/// A ruling: its parameter in the knot list and the piece it is taken from.
struct RulingPlace {
  int piece;
  Rational parameter;
};

/// `folded` is no iff m . n >= 0 on the whole surface, with equality at isolated parameters or on whole pieces where a
/// normal is 0; yes with a witness where m . n < 0; unknown where subdivision did not tell a double zero from two.
struct FoldVerdict {
  Truth folded = Truth::no;
  std::optional<RulingPlace> witness{};
};

/// Decides it with the normals m = c' x (d - c) and n = d' x (d - c) at the two ends of a ruling. Along the ruling the
/// surface's normal is (1-v) m + v n up to length. Where m . n > 0 it never vanishes and turns by less than 90 degrees:
/// the ruling is regular, and no edge of regression meets it between the rails. Where m . n < 0 it turns by more; a
/// developable ruling, whose normals are parallel, has its singular point between the rails then. D = 3: points of a
/// polynomial surface, D = 4: homogeneous rows with weights of one sign.
template <int D>
FoldVerdict decide_folds(const KnotList<Rational>& u, std::span<const Vec<Rational, D>> c,
                         std::span<const Vec<Rational, D>> d);

}  // namespace torse
