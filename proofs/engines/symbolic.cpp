// Rational functions over Q: every knot, parameter and control point an indeterminate. A sum that is the zero function
// proves the claim for its size, under the hypotheses that the factors of nonzero() do not vanish.
#include <string>
#include <vector>

#include "torse/exact/symbolic/rational_function.hpp"
#include "torse/proofs/engines/engine.hpp"
#include "torse/proofs/engines/judge.hpp"
#include "torse/proofs/models.hpp"
#include "torse/proofs/sources.hpp"
#include "torse/proofs/table.hpp"

namespace torse::proofs {

namespace {

std::vector<Size> wanted(Effort effort) {
  return effort == Effort::quick ? grid(3, 2) : effort == Effort::standard ? grid(4, 4) : grid(5, 6);
}

/// The number of free parameters that are not points.
int count_parameters(const ClaimCase<RationalFunction>& claim, Size size) {
  FieldSource<RationalFunction> counter([](int i) { return from_int<RationalFunction>(i + 1); });
  claim.draw(counter, size);
  return counter.count();
}

}  // namespace

Finding run_symbolic(std::size_t index, const Plan& plan) {
  const ClaimCase<RationalFunction>& claim = claim_cases<RationalFunction>()[index];
  Finding finding = open_finding(*claim.info, "symbolic", plan);
  if (claim.info->kind == Kind::example) return finding;
  for (const Size size : sizes_for(*claim.info, wanted(plan.effort))) {
    std::vector<std::string> names;
    for (int i = count_parameters(claim, size); i >= 0; --i) names.push_back("x" + std::to_string(names.size()));
    const SymbolicContext context(names);
    FieldSource<RationalFunction> source([&](int i) { return context.variable(i); });
    const Verdict verdict = run_once(claim, source, size, Mutant(plan.mutant));
    ++finding.trials;
    if (!verdict.admitted || !verdict.agrees) {
      finding.status = verdict.admitted ? Status::refuted : Status::gave_up;
      finding.detail = "n=" + std::to_string(size.n) + ", N=" + std::to_string(size.pieces) + ": " +
                       (verdict.admitted ? verdict.reason : "a hypothesis vanishes identically");
      finding.sizes = {size};
      return finding;
    }
    finding.sizes.push_back(size);
  }
  finding.status = Status::proved;
  finding.detail = claim.points == PointKind::space
                       ? "every parameter and coordinate an indeterminate"
                       : "every parameter an indeterminate, every control point a generator";
  return finding;
}

}  // namespace torse::proofs
