// Random primes: a claim that were false would have a nonzero numerator f over the integers. It goes unnoticed at 64
// random points modulo a random prime p of [2^61, 2^62) only if p divides every coefficient of f (at most h/61 such
// primes, for coefficients of h bits) or all points are zeros of f (Schwartz-Zippel: each with probability at most deg
// f / (p - deg g), given that the hypotheses' product g is not zero there). Degree bounds both by running the same
// code.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "torse/proofs/engines/cases.hpp"
#include "torse/proofs/sources.hpp"
#include "torse/proofs/table.hpp"

namespace torse::proofs {

namespace {

std::vector<Size> wanted(Effort effort) {
  std::vector<Size> sizes = grid(3, 3);
  for (const Size size : {Size{5, 8}, Size{8, 4}}) sizes.push_back(size);
  if (effort != Effort::quick) {
    for (const Size size :
         {Size{1, 64}, Size{4, 4}, Size{4, 16}, Size{5, 1}, Size{6, 6}, Size{7, 10}, Size{8, 1}, Size{8, 64}}) {
      sizes.push_back(size);
    }
  }
  if (effort == Effort::deep) {
    for (const Size size : {Size{3, 200}, Size{10, 20}, Size{16, 4}}) sizes.push_back(size);
  }
  return sizes;
}

/// Bounds for the numerators of all equations and for the product of all hypotheses.
struct Bounds {
  double degree = 0;
  double bits = 0;
  double hypothesis_degree = 0;
};

Bounds bounds_of(const ClaimCase<Degree>& claim, Size size, Mutant mutant) {
  FieldSource<Degree> source([](int) { return Degree::input(); });
  Sample<Degree> sample;
  claim.run(source, size, mutant, sample, [](const NonZero<Degree>&) { return true; });
  Bounds bounds;
  for (const Equation<Degree>& equation : sample.equations.list()) {
    const Degree rest = equation.lhs - equation.rhs;
    bounds.degree = std::max(bounds.degree, static_cast<double>(rest.numerator_degree()));
    bounds.bits = std::max(bounds.bits, static_cast<double>(rest.numerator_bits()));
  }
  for (const auto& factors : sample.nonzero) {
    for (const Degree& factor : factors) bounds.hypothesis_degree += static_cast<double>(factor.numerator_degree());
  }
  return bounds;
}

/// log2 of the probability that one prime with `lanes` valid points lets a false claim pass.
double error_log2(const Bounds& bounds, int lanes) {
  const double bad_prime = bounds.bits / 61 / static_cast<double>(prime_count_lower_bound);
  const double point = bounds.degree / (std::ldexp(1.0, 61) - bounds.hypothesis_degree);
  if (point >= 1 || bad_prime >= 1) return 0;
  const double points = point > 0 ? lanes * std::log2(point) : -std::numeric_limits<double>::infinity();
  return std::log2(bad_prime + std::exp2(points));
}

/// What one prime says of a claim.
struct Trial {
  LaneMask valid = ~LaneMask{0};
  LaneMask disagree = 0;
  bool asserted = false;
};

Trial try_prime(const ClaimCase<Batch>& claim, Size size, Mutant mutant, Rng& rng) {
  const Modulus modulus = random_prime(rng);
  FieldSource<Batch> source([&](int) { return Batch::draw(modulus, rng); });
  Sample<Batch> sample;
  Trial trial;
  claim.run(source, size, mutant, sample, [&](const NonZero<Batch>& nonzero) {
    for (const auto& factors : nonzero) {
      for (const Batch& factor : factors) trial.valid &= factor.nonzero();
    }
    return true;
  });
  for (const Equation<Batch>& equation : sample.equations.list()) {
    const Batch rest = equation.lhs - equation.rhs;
    trial.disagree |= (rest.nonzero() | rest.undefined()) & trial.valid;
    trial.asserted = true;
  }
  return trial;
}

/// What the sizes of a claim have shown so far.
struct Total {
  double error = 0;  ///< the sum of the probabilities of error
  Bounds worst;
};

/// Runs one size, prime after prime, until log2 of the probability of error is at most `target`. Whether it has come so
/// far; otherwise the finding says why.
bool run_size(const ClaimCase<Batch>& claim, const ClaimCase<Degree>& degrees, Size size, const Plan& plan,
              double target, Total& total, Finding& finding) {
  const Bounds bounds = bounds_of(degrees, size, Mutant(plan.mutant));
  Rng rng(seed_of(plan.seed, finding.claim + "/modular/" + std::to_string(size.n) + "/" + std::to_string(size.pieces)));
  double error = 0;
  int empty = 0;
  while (error > target) {
    const Trial trial = try_prime(claim, size, Mutant(plan.mutant), rng);
    const int lanes = std::popcount(trial.valid);
    if (!trial.asserted || lanes == 0 || error_log2(bounds, lanes) >= 0) {
      if (++empty < 10) continue;
      finding.status = Status::gave_up;
      finding.detail =
          size_text(size) + (trial.asserted ? ": no valid point or no useful degree bound" : ": nothing asserted");
      return false;
    }
    finding.trials += lanes;
    finding.discards += Batch::lanes - lanes;
    if (trial.disagree != 0) {
      finding.status = Status::refuted;
      finding.detail =
          size_text(size) + ": differs modulo a prime at lane " + std::to_string(std::countr_zero(trial.disagree));
      finding.sizes = {size};
      return false;
    }
    error += error_log2(bounds, lanes);
  }
  total.error += std::exp2(error);
  if (bounds.degree >= total.worst.degree) total.worst = bounds;
  finding.sizes.push_back(size);
  return true;
}

}  // namespace

Finding judge_modular(const ClaimCase<Batch>& claim, const ClaimCase<Degree>& degrees, const Plan& plan) {
  Finding finding = open_finding(*claim.info, "modular", plan);
  if (claim.info->kind == Kind::example) return finding;
  const double target = plan.effort == Effort::quick ? -60 : plan.effort == Effort::standard ? -110 : -250;
  Total total;
  for (const Size size : sizes_for(*claim.info, wanted(plan.effort))) {
    try {
      if (!run_size(claim, degrees, size, plan, target, total, finding)) return finding;
    } catch (const Error& error) {
      return gave_up(std::move(finding), size_text(size) + ": threw: " + error.what());
    }
  }
  if (finding.sizes.empty()) return gave_up(std::move(finding), no_size);
  finding.status = Status::supported;
  finding.error_log2 = std::log2(total.error);
  char text[160];
  std::snprintf(text, sizeof text, "error < 2^%.0f; largest numerator: degree %.3g, %.3g bits",
                std::ceil(*finding.error_log2), total.worst.degree, total.worst.bits);
  finding.detail = text;
  return finding;
}

Finding run_modular(std::size_t index, const Plan& plan) {
  return judge_modular(claim_cases<Batch>()[index], claim_cases<Degree>()[index], plan);
}

}  // namespace torse::proofs
