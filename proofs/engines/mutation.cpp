// Mutation: is a claim sharp? Each of its own wrong variants must fail on some rational input. And each single
// operation of its equations, corrupted by a random amount at 64 random points modulo a random prime, must either make
// an equation fail (killed), or leave every side of every equation as it was (equivalent: up to the small probability
// of the modular engine the operation has no influence, such as a check of the input). Sides that change alike have
// survived: they share code.
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "torse/proofs/engines/cases.hpp"
#include "torse/proofs/engines/judge.hpp"
#include "torse/proofs/sources.hpp"
#include "torse/proofs/table.hpp"

namespace torse::proofs {

namespace {

/// Whether some input of one of the sizes refutes the wrong variant.
bool killed(const ClaimCase<Rational>& claim, const std::vector<Size>& sizes, int mutant, const Plan& plan) {
  for (int draw = 0; draw < 12; ++draw) {
    for (const Size size : sizes) {
      FractionSource<Rational> source(seed_of(plan.seed, claim.info->id, static_cast<std::uint64_t>(draw)),
                                      static_cast<Temper>(draw % tempers));
      const Verdict verdict = run_once(claim, source, size, Mutant(mutant));
      if (verdict.admitted && !verdict.agrees) return true;
    }
  }
  return false;
}

/// The same inputs again and again: the i-th parameter is made once.
template <class S>
class Replay {
 public:
  explicit Replay(std::function<S()> fresh) : fresh_(std::move(fresh)) {}
  FieldSource<Faulty<S>> source() {
    return FieldSource<Faulty<S>>([this](int i) {
      while (static_cast<int>(values_.size()) <= i) values_.push_back(fresh_());
      return Faulty<S>(values_[static_cast<std::size_t>(i)]);
    });
  }

 private:
  std::function<S()> fresh_;
  std::vector<S> values_;
};

/// The lanes (or the one value) that two results differ in.
bool differ(const Rational& a, const Rational& b, LaneMask) { return a != b; }
bool differ(const Batch& a, const Batch& b, LaneMask valid) {
  const Batch rest = a - b;
  return ((rest.nonzero() | rest.undefined()) & valid) != 0;
}

LaneMask admitted(const NonZero<Faulty<Rational>>&) { return ~LaneMask{0}; }
LaneMask admitted(const NonZero<Faulty<Batch>>& nonzero) {
  LaneMask valid = ~LaneMask{0};
  for (const auto& factors : nonzero) {
    for (const Faulty<Batch>& factor : factors) valid &= factor.value().nonzero();
  }
  return valid;
}

/// The equations of the replayed input with operation `index` corrupted (none: as they are) and the number of
/// operations.
template <class S>
struct FaultyRun {
  Sample<Faulty<S>> sample;
  LaneMask valid = 0;
  std::int64_t operations = 0;
  bool threw = false;
};

template <class S>
FaultyRun<S> run_with_fault(const ClaimCase<Faulty<S>>& claim, Size size, Replay<S>& inputs,
                            std::optional<std::int64_t> index, const S& error) {
  FaultyRun<S> run;
  std::optional<FaultScope<S>> scope;
  FieldSource<Faulty<S>> source = inputs.source();
  try {
    claim.run(source, size, Mutant(), run.sample, [&](const NonZero<Faulty<S>>& nonzero) {
      run.valid = admitted(nonzero);
      if (index) {
        scope.emplace(*index, error);
      } else {
        scope.emplace();
      }
      return true;
    });
  } catch (const Error&) {
    run.threw = true;
  }
  if (scope) run.operations = scope->operations();
  return run;
}

/// Corrupts every operation of one input in turn; survivors are named by their index. None where the equations cannot
/// be looked at as they are: then every corrupted run would end alike.
template <class S>
std::optional<Score> score_faults(const ClaimCase<Faulty<S>>& claim, Size size, Replay<S> inputs, const S& error,
                                  std::vector<std::string>& survivors) {
  Score score;
  const FaultyRun<S> clean = run_with_fault<S>(claim, size, inputs, std::nullopt, error);
  const auto& truth = clean.sample.equations.list();
  if (clean.threw || clean.valid == 0 || truth.empty()) return std::nullopt;
  for (std::int64_t index = 0; index < clean.operations; ++index) {
    const FaultyRun<S> run = run_with_fault<S>(claim, size, inputs, index, error);
    const auto& found = run.sample.equations.list();
    bool fails = run.threw || found.size() != truth.size();
    bool moves = false;
    for (std::size_t i = 0; !fails && i < found.size(); ++i) {
      fails = differ(found[i].lhs.value(), found[i].rhs.value(), clean.valid);
      moves = moves || differ(found[i].lhs.value(), truth[i].lhs.value(), clean.valid);
    }
    if (fails) {
      ++score.killed;
    } else if (moves) {
      ++score.survived;
      survivors.push_back("operation " + std::to_string(index) + " of " + std::to_string(clean.operations) + " at " +
                          size_text(size));
    } else {
      ++score.equivalent;
    }
  }
  return score;
}

std::vector<Size> fault_sizes(Effort effort) {
  std::vector<Size> sizes{{2, 2}};
  if (effort != Effort::quick) sizes.push_back({3, 2});
  if (effort == Effort::deep) sizes.push_back({4, 4});
  return sizes;
}

}  // namespace

Finding judge_mutation(const ClaimCase<Rational>& claim, const FaultyCases& faulty, const Plan& plan) {
  const ClaimInfo& info = *claim.info;
  Finding finding = open_finding(info, "mutation", plan);
  const std::vector<Size> sizes = sizes_for(info, {{2, 2}, {3, 3}, {1, 1}, {2, 1}, {4, 2}});
  for (int mutant = 1; mutant <= static_cast<int>(info.mutants.size()); ++mutant) {
    if (killed(claim, sizes, mutant, plan)) {
      ++finding.mutants.killed;
    } else {
      ++finding.mutants.survived;
      finding.survivors.push_back("mutant " + std::to_string(mutant) + ": " +
                                  std::string(info.mutants[static_cast<std::size_t>(mutant - 1)]));
    }
  }
  std::vector<Size> instances = sizes_for(info, fault_sizes(plan.effort));
  if (instances.empty()) instances = sizes_for(info, {{1, 1}, {1, 2}, {3, 1}});
  if (instances.empty()) return gave_up(std::move(finding), no_size);
  for (const Size size : instances) {
    Rng rng(seed_of(plan.seed, finding.claim + "/faults"));
    std::optional<Score> faults;
    if (info.kind == Kind::example) {
      faults = score_faults<Rational>(faulty.rational, size,
                                      Replay<Rational>([&] { return ratio<Rational>(rng.between(1, 99), 7); }),
                                      from_int<Rational>(1), finding.survivors);
    } else {
      const Modulus modulus = random_prime(rng);
      faults = score_faults<Batch>(faulty.batch, size, Replay<Batch>([&] { return Batch::draw(modulus, rng); }),
                                   Batch::draw(modulus, rng), finding.survivors);
    }
    if (!faults) return gave_up(std::move(finding), size_text(size) + ": nothing to corrupt");
    finding.faults += *faults;
    finding.sizes.push_back(size);
    if (info.kind == Kind::example) break;
  }
  finding.status = finding.mutants.survived + finding.faults.survived == 0 ? Status::supported : Status::undecided;
  finding.detail = finding.survivors.empty() ? "no survivor" : "survived: " + finding.survivors.front();
  return finding;
}

Finding run_mutation(std::size_t index, const Plan& plan) {
  return judge_mutation(claim_cases<Rational>()[index],
                        {claim_cases<Faulty<Rational>>()[index], claim_cases<Faulty<Batch>>()[index]}, plan);
}

}  // namespace torse::proofs
