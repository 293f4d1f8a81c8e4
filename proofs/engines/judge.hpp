// Judging one evaluated input in an arithmetic whose zero test is decided.
//   holds      whether a hypothesis is met          judge      whether all equations hold
//   run_once   draw, hypotheses, equations, verdict; a typed error of the library counts as disagreement
#pragma once

#include <string>
#include <vector>

#include "torse/proofs/table.hpp"

namespace torse::proofs {

/// Whether no factor of the hypothesis is zero.
template <class S>
bool holds(const std::vector<S>& factors) {
  for (const S& factor : factors) {
    if (definitely(is_zero(factor))) return false;
  }
  return true;
}

/// What an input says about a claim.
struct Verdict {
  bool admitted = false;  ///< the hypotheses are met
  bool agrees = false;    ///< every equation holds
  std::string reason;     ///< why not
};

/// Whether every equation holds and every value that must be positive is.
template <class S>
Verdict judge(const Equations<S>& equations) {
  int position = 0;
  for (const Equation<S>& equation : equations.list()) {
    ++position;
    if (!definitely(equal(equation.lhs, equation.rhs))) {
      return {
          true, false,
          "equation " + std::to_string(position) + ": " + as_text(equation.lhs) + " against " + as_text(equation.rhs)};
    }
  }
  if constexpr (OrderedField<S>) {
    for (const S& value : equations.positives()) {
      if (!definitely(less(from_int<S>(0), value))) return {true, false, as_text(value) + " is not positive"};
    }
  }
  if (equations.list().empty() && equations.positives().empty()) return {true, false, "the claim asserted nothing"};
  return {true, true, {}};
}

/// Draws one input, which becomes `sample`, and judges the claim or a mutant on it.
template <class S>
Verdict run_once(const ClaimCase<S>& claim, Source<S>& source, Size size, Mutant mutant, Sample<S>& sample) {
  Verdict verdict;
  const auto begin = [&](const NonZero<S>& nonzero) {
    verdict.admitted = true;
    for (const std::vector<S>& factors : nonzero) verdict.admitted = verdict.admitted && holds(factors);
    return verdict.admitted;
  };
  try {
    claim.run(source, size, mutant, sample, begin);
  } catch (const Error& error) {
    if (!verdict.admitted) throw;
    verdict.reason = std::string("threw: ") + error.what();
    return verdict;
  }
  return verdict.admitted ? judge(sample.equations) : verdict;
}

template <class S>
Verdict run_once(const ClaimCase<S>& claim, Source<S>& source, Size size, Mutant mutant) {
  Sample<S> sample;
  return run_once(claim, source, size, mutant, sample);
}

}  // namespace torse::proofs
