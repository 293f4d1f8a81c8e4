// Exact nets of FJ07.13 and FJ21.7.1 near given ones, for known constants.
//   realise_constant_net       by the edges of regression of the segments
#pragma once

#include <optional>
#include <vector>

#include "torse/exact/repair/candidate.hpp"
#include "torse/exact/repair/segments.hpp"

namespace torse::repair {

/// A net whose segments obey FJ21.7.1 with their constants, near `net`, which does so up to rounding errors. The edge
/// of regression r of a segment has degree n + 1 over its knots, with one more at either end (FJ21.T6.1): c_i = sigma
/// r[u_i, ..., u_{i+n-1}, M*], d_i = r[u_i, ..., u_{i+n-1}, L*]. Its points are rounded; the first two of a later
/// segment follow from the control points that it shares. No recursion multiplies denominators. Nothing where L* = M*:
/// such nets have no edge.
template <int D>
std::optional<ExactNet<D>> realise_constant_net(const std::vector<Segment>& segments, const RealNet<D>& net,
                                                const std::vector<RelationConstants>& constants,
                                                const Accuracy& accuracy);

}  // namespace torse::repair
