// The engines on a claim in hand, of the table or not: run_* of engine.hpp looks a claim up and lets judge_* judge it.
//   Box              the balls of the ball engine
//   RoundedCases     a claim in the numeric engine's arithmetics      FaultyCases     ... in those of the mutation
//   engine judge_symbolic ... judge_mutation
#pragma once

#include "torse/exact/ball/ball.hpp"
#include "torse/exact/bigfloat/bigfloat.hpp"
#include "torse/proofs/engines/engine.hpp"
#include "torse/proofs/models.hpp"
#include "torse/proofs/table.hpp"
#include "torse/scalar/builtin.hpp"

namespace torse::proofs {

using Box = Ball<128>;

/// One claim in four precisions.
struct RoundedCases {
  const ClaimCase<float>& single;
  const ClaimCase<double>& twice;
  const ClaimCase<long double>& extended;
  const ClaimCase<BigFloat<113>>& quad;
};

/// One claim whose operations can be corrupted: over the rationals for an example, otherwise modulo a prime.
struct FaultyCases {
  const ClaimCase<Faulty<Rational>>& rational;
  const ClaimCase<Faulty<Batch>>& batch;
};

/// What an engine finds out about a claim; where it needs several arithmetics, all are of the same claim. A claim that
/// throws an Error of the library once its hypotheses are met is refuted where zero tests are decided, and given up
/// where they are not (modular, ball).
Finding judge_symbolic(const ClaimCase<RationalFunction>& claim, const Plan& plan);
Finding judge_modular(const ClaimCase<Batch>& claim, const ClaimCase<Degree>& degrees, const Plan& plan);
Finding judge_rational(const ClaimCase<Rational>& claim, const Plan& plan);
Finding judge_ball(const ClaimCase<Box>& claim, const Plan& plan);
Finding judge_numeric(const ClaimCase<Rational>& claim, const RoundedCases& rounded, const Plan& plan);
Finding judge_mutation(const ClaimCase<Rational>& claim, const FaultyCases& faulty, const Plan& plan);

}  // namespace torse::proofs
