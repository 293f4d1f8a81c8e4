// Mappings that pass the knots of the second rail at rational parameters, so that Algorithm 1 of BZZ19 is exact.
//   SnappedMapping        the mapping, those parameters, and how far it is from the one it was made of
//   snapped               by one simple knot and one coefficient for each knot that is passed
#pragma once

#include <vector>

#include "torse/exact/rational/rational.hpp"
#include "torse/quasi/mapping.hpp"

namespace torse {

/// A mapping with a knot at each parameter where it passes a knot of C2.
struct SnappedMapping {
  Mapping<Rational> sigma;
  /// Where it passes the inner knots of C2 that lie between its end values, in order: sigma is exactly that knot there.
  std::vector<Rational> parameters;
  /// |sigma(t) - what it was| is at most this for every t: the largest change of a coefficient over common knots.
  Rational change;
};

/// sigma, which must not decrease, with coefficients changed so little and with such knots that it passes every inner
/// knot of C2 at a knot of its own. The exact parameters sigma^{-1}(T_i) of BZZ19's step 1 are irrational in general:
/// a short dyadic number near each is inserted as a simple knot, or a knot of sigma or C1 is taken that is near enough,
/// and the coefficients are rounded to short dyadic numbers but for one at each knot that makes sigma(phi_i) = T_i. The
/// smoothness at every knot and the order of the coefficients stay as they were.
///
/// The change is at most `tolerance` times the length of the domain of C2. Within half of that, end values are taken to
/// the ends and knots of C2. sigma comes back clamped, and else untouched where it passes no inner knot. Throws
/// InvalidInput naming "sigma" for a mapping that decreases or leaves the domain of C2 by more than that, and
/// "tolerance" unless it is positive; Undecided where nothing is found within the tolerance, as for a knot of C2 that
/// is all but an end value of sigma.
SnappedMapping snapped(const Mapping<Rational>& sigma, const KnotList<Rational>& of_c1, const KnotList<Rational>& of_c2,
                       const Rational& tolerance);

/// The same with the tolerance 2^-40 (9e-13); where nothing is found, as where a knot of C2 is a little further than
/// half of that from an end value of sigma, with 2^-36 and 2^-30, which take the end to the knot.
SnappedMapping snapped(const Mapping<Rational>& sigma, const KnotList<Rational>& of_c1,
                       const KnotList<Rational>& of_c2);

}  // namespace torse
