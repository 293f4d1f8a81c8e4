// Rational functions over Q: every knot, parameter and control point an indeterminate. A sum that is the zero function
// proves the claim for its size, under the hypotheses that the factors of nonzero() do not vanish.
#include <string>
#include <utility>
#include <vector>

#include "torse/exact/symbolic/rational_function.hpp"
#include "torse/proofs/engines/cases.hpp"
#include "torse/proofs/engines/judge.hpp"
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

Finding judge_symbolic(const ClaimCase<RationalFunction>& claim, const Plan& plan) {
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
      finding.detail =
          size_text(size) + ": " + (verdict.admitted ? verdict.reason : "a hypothesis vanishes identically");
      finding.sizes = {size};
      return finding;
    }
    finding.sizes.push_back(size);
  }
  if (finding.sizes.empty()) return gave_up(std::move(finding), no_size);
  finding.status = Status::proved;
  finding.detail = claim.points == PointKind::space
                       ? "every parameter and coordinate an indeterminate"
                       : "every parameter an indeterminate, every control point a generator";
  return finding;
}

Finding run_symbolic(std::size_t index, const Plan& plan) {
  return judge_symbolic(claim_cases<RationalFunction>()[index], plan);
}

}  // namespace torse::proofs
