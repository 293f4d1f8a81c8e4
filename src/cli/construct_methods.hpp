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

}  // namespace torse::cli
