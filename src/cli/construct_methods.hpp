// The methods of `torse construct`.
//   Construction         the surface, with what there is to say about it
//   construct_surface    runs the method of a file
#pragma once

#include <string>
#include <vector>

#include "torse/exact/rational/rational.hpp"
#include "torse/io/construct_file.hpp"

namespace torse::cli {

/// A surface through the given curve, and lines for the person who asked for it.
struct Construction {
  RuledFile<Rational> surface;
  std::vector<std::string> notes{};
};

/// A problem without a solution: the input is well-formed, but no surface fits.
class NoSolution : public Error {
 public:
  using Error::Error;
};

/// Runs the method that the input names; `branch` (from 1) picks among the solutions of interpolate. Throws
/// InvalidInput, its place a member of the input, NoSolution, and UsageError for a branch that is not there.
Construction construct_surface(const ConstructFile<Rational>& input, int branch);

/// FJ07 section 4 and FJ07.20-21: the surface through a clamped curve whose end rulings have the directions va and vb.
/// Parallel directions give a cylinder, meeting end rulings a cone (Lambda is its ratio), skew ones a branch M_0 each.
Construction interpolate(const ConstructFile<Rational>& input, int branch);

/// ZW06: the rulings tau of the Bezier curve c with a' = a tau + b tau'. One solution is written; of a family the one
/// that d0 or v picks (InvalidInput naming "a" says what may be picked if neither does); none is NoSolution with the
/// combination of the equations that contradicts itself.
Construction directrix(const ConstructFile<Rational>& input);

}  // namespace torse::cli
