// The rulings of a surface in the plane, enclosed; for .cpp files only.
//   Station        a ruling: its ends in the plane, and how long the rails are up to there
//   develop        a chain of stations, close enough for polylines of a tolerance
//   sagitta        how far an arc of given length may be from its chord
#pragma once

#include <vector>

#include "torse/exact/unroll/arb_types.hpp"
#include "torse/exact/unroll/strip.hpp"

namespace torse {

/// The ruling at the parameter t. P is the image of C(t) and Q that of D(t), as complex numbers; the first ruling
/// starts at 0 and points to i.
struct Station {
  Rational t;
  arb::Complex p;
  arb::Complex q;
  arb::Real length_c;  ///< of the rail C from the first station to here
  arb::Real length_d;
  arb::Real area;  ///< of the strip from the first station to here
};

/// An upper bound of the distance between a curve of this length and the chord between its ends: it lies within the
/// ellipse whose foci are the ends and whose long axis is the length, and the short half axis of that is half of
/// sqrt(length^2 - chord^2).
double sagitta(const arb::Real& length, const arb::Complex& chord);

/// The development from the first to the last ruling. The strips have no obstacle (strip.hpp). Between two neighbours
/// each rail is within `tolerance` of its chord. All parameters in `marks` (in the domain) have a station. Throws
/// InvalidInput naming "tolerance" where that takes more than `most` stations.
std::vector<Station> develop(const std::vector<PieceStrip>& strips, const std::vector<Rational>& marks,
                             double tolerance, std::size_t most);

}  // namespace torse
