// The ends of the pieces of a mapping over [0, 1].
//   even_breaks        evenly spaced
//   means_by_piece     the means over pieces of what is known at parameters
//   moved_breaks       where the pieces share the warp evenly
#pragma once

#include <vector>

namespace torse::quasi {

/// 0, 1 / pieces, ..., 1 for up to 10^6 pieces, the inner ones rounded to multiples of 2^-24: short numbers, so that
/// the exact surface has short ones too.
std::vector<double> even_breaks(int pieces);

/// For each piece the mean of the values whose parameters lie in it, its begin included, its end not, but in the last
/// one; 0 for a piece without any. Takes parameters within [0, 1], as many as values.
std::vector<double> means_by_piece(const std::vector<double>& breaks, const std::vector<double>& parameters,
                                   const std::vector<double>& values);

/// As many pieces, such that each has the same part of the warp: with e the mean warp of a piece, relative to the
/// largest one, the pieces are spread with density e^(1/(degree+1)), the rule for approximation of that degree, and a
/// tenth more, so that none gets too long. No new piece is shorter than 1 / (11 pieces): their ends differ as multiples
/// of 2^-24 too, as which they come.
std::vector<double> moved_breaks(const std::vector<double>& breaks, const std::vector<double>& warp, int degree);

}  // namespace torse::quasi
