// The same surface, or its image under a map, by other control nets: what it is does not change, however it is written.
//   refine         further knots or a higher degree
//   disguise       none, one or two of: further knots, a higher degree, a part of the domain, another parameter, the
//   rows exchanged or mixed, a map of space; for rational nets also Moebius parameters and factors
#pragma once

#include "torse/fuzz/draw/classes.hpp"

namespace torse::fuzz {

/// Rewrites a draft by way of the polynomials of its pieces (plain/pieces.hpp) and notes how in draft.disguise, words
/// joined by '+'. A rewriting that would give a control point the weight 0 where there may be none is left out.
/// A developable surface stays developable; its class stays but for cones and cylinders under projective maps, which
/// may become one another, and for parts of the domain, which may be in a smaller class. Of a twisted surface a part
/// may be developable. Constant functions go along or are forgotten.
void disguise(Choices& choices, const Scale& scale, Weights weights, Draft& draft);

/// The same net with further knots or a higher degree, once or twice.
void refine(Choices& choices, const Scale& scale, Weights weights, Draft& draft);

/// Whether no weight is other than it may be.
bool fits(const Draft& draft, Weights weights);

}  // namespace torse::fuzz
