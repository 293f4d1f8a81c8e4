// Whether rulings of a strip cross each other: certified by subdivision, or by a crossing as a witness.
//   SelfIntersection          no, yes with a witness, or unknown
//   find_self_intersection    of the whole surface
#pragma once

#include <optional>
#include <span>

#include "torse/algebra/eigen.hpp"
#include "torse/exact/quasi/strip_crossing.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/scalar/truth.hpp"
#include "torse/spline/knots.hpp"

namespace torse {

struct SelfIntersection {
  Truth crosses = Truth::unknown;
  std::optional<RulingCrossing> witness{};
};

/// Looks for crossings of rulings between the rails. `no` is certified, by intervals around exact numbers:
/// - two parts of the strip are apart if a plane separates the hulls of their control points;
/// - within a part, or some behind each other, no two rulings cross if for some direction e both rails leave every
///   ruling to the same side at all later parameters, see on_one_side. Neighbouring rulings may share a point of a rail
///   (the vertex of a cone).
/// `yes` is certified by a crossing near the witness, see CrossingFinder; rulings that slide along themselves do.
/// `unknown` where `most_pairs` pairs of parts did not tell, as for strips that touch themselves or have their edge of
/// regression between the rails. The ends of a strip may meet where both rails close in finite points: those that begin
/// and end at infinity are not closed. D = 3: points of a polynomial surface, D = 4: homogeneous rows. Where a rail's
/// weights have both signs, parts are neither separated nor in order before subdivision has parted these; that never
/// parts them where a rail is infinite.
template <int D>
SelfIntersection find_self_intersection(const KnotList<Rational>& u, std::span<const Vec<Rational, D>> c,
                                        std::span<const Vec<Rational, D>> d, long most_pairs = 20'000);

}  // namespace torse
