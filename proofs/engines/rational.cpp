// Exact rationals: generic and hostile inputs. Refuted with the witness, or Supported by so many points. The stored
// failures show that no hypothesis can be dropped.
#include <string>
#include <utility>

#include "torse/exact/rational/rational.hpp"
#include "torse/proofs/engines/cases.hpp"
#include "torse/proofs/engines/judge.hpp"
#include "torse/proofs/sources.hpp"
#include "torse/proofs/table.hpp"

namespace torse::proofs {

namespace {

std::vector<Size> wanted(Effort effort) {
  std::vector<Size> sizes = effort == Effort::quick ? grid(3, 3) : grid(5, 5);
  for (const Size size : {Size{3, 12}, Size{8, 4}}) sizes.push_back(size);
  if (effort == Effort::deep) {
    for (const Size size : {Size{8, 64}, Size{12, 20}, Size{16, 8}, Size{2, 200}}) sizes.push_back(size);
  }
  return sizes;
}

/// Checks the stored failures; returns what is wrong with them, or nothing.
std::string check_failures(const ClaimCase<Rational>& claim) {
  for (const FailureSample<Rational>& failure : claim.failures()) {
    const std::string name = "the stored failure of hypothesis " + std::to_string(failure.hypothesis + 1);
    for (std::size_t h = 0; h < failure.sample.nonzero.size(); ++h) {
      if (holds(failure.sample.nonzero[h]) == (h == failure.hypothesis))
        return name + " does not violate that one alone";
    }
    if (failure.error.empty() && judge(failure.sample.equations).agrees)
      return name + " is none: the claim holds there";
  }
  return {};
}

}  // namespace

Finding judge_rational(const ClaimCase<Rational>& claim, const Plan& plan) {
  Finding finding = open_finding(*claim.info, "rational", plan);
  const int wanted_trials = claim.info->kind == Kind::example ? 1
                            : plan.effort == Effort::quick    ? 8
                            : plan.effort == Effort::standard ? 24
                                                              : 100;
  for (const Size size : sizes_for(*claim.info, wanted(plan.effort))) {
    int accepted = 0;
    for (int draw = 0; accepted < wanted_trials; ++draw) {
      if (draw == 20 * wanted_trials) return gave_up(std::move(finding), "too many inputs violate the hypotheses");
      const std::string task =
          finding.claim + "/rational/" + std::to_string(size.n) + "/" + std::to_string(size.pieces);
      FractionSource<Rational> source(seed_of(plan.seed, task, static_cast<std::uint64_t>(draw)),
                                      static_cast<Temper>(draw % tempers));
      const Verdict verdict = run_once(claim, source, size, Mutant(plan.mutant));
      if (!verdict.admitted) {
        ++finding.discards;
        continue;
      }
      ++accepted;
      ++finding.trials;
      if (!verdict.agrees) {
        finding.status = Status::refuted;
        finding.detail = size_text(size) + ", draw " + std::to_string(draw) + ": " + verdict.reason;
        finding.sizes = {size};
        return finding;
      }
    }
    finding.sizes.push_back(size);
  }
  if (finding.sizes.empty()) return gave_up(std::move(finding), no_size);
  if (const std::string wrong = check_failures(claim); !wrong.empty()) {
    finding.status = Status::refuted;
    finding.detail = wrong;
    return finding;
  }
  const bool example = claim.info->kind == Kind::example;
  finding.status = example ? Status::proved : Status::supported;
  finding.detail = example ? "every printed value recomputed exactly" : std::to_string(finding.trials) + " points";
  return finding;
}

Finding run_rational(std::size_t index, const Plan& plan) {
  return judge_rational(claim_cases<Rational>()[index], plan);
}

}  // namespace torse::proofs
