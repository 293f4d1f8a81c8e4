// Naive tests of developability beside the exact verdict, on nets that are known to the last bit.
//   verdict_names        the tests
//   Verdicts             what they say of one net
//   judge_case           of a developable net, one coordinate of which may have been moved
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "torse/studies/design.hpp"

namespace torse::studies {

/// "fixed 1e-06", "relative 1e-09", "sampled 1e-09", ... : |[d', c', d-c]| < epsilon at 20 parameters of each piece;
/// the same over the product of the three lengths; the same at the ends and the middle of the pieces only; and
/// "coefficients 1e-09", the largest Bernstein coefficient of the determinant over the product of the largest entries.
std::vector<std::string> verdict_names();

/// The word of each test, and the truth.
struct Verdicts {
  bool developable = false;  ///< by the determinant polynomials over the rationals
  std::vector<bool> said;    ///< of each test, in the order asked for
  std::string net;           ///< the file of the net, hexadecimal numbers
};

/// A net of FJ07.13 with integer coordinates in double, multiplied by the power of two nearest to `scale`; one
/// coordinate of d is moved by `moved` times the net's size.
Verdicts judge_case(const Levels& levels, std::uint64_t seed, const std::vector<std::string>& tests);

}  // namespace torse::studies
