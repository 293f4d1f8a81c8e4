// Balls: every input is a box of radius 2^-40 around a dyadic point. An equation whose two sides are apart on the whole
// box is refuted; otherwise the claim is bounded by the widest difference seen. Balls never prove an identity; a value
// that must be positive and is so on a box is proved there.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "torse/proofs/engines/cases.hpp"
#include "torse/proofs/sources.hpp"
#include "torse/proofs/table.hpp"

namespace torse::proofs {

namespace {

Box widened(const Box& point) {
  const double radius = std::ldexp(1.0, -40);
  return Box::interval(point.midpoint() - radius, point.midpoint() + radius);
}

/// What the boxes of a claim have shown so far.
struct Tally {
  double widest = 0;
  long bounded = 0;
  long wide = 0;  ///< differences that are not finite, a division by a ball around zero, and runs that throw
  long positive = 0;
  long unsure = 0;
  std::string refutation;
};

void look_at(const Equations<Box>& equations, Tally& tally) {
  for (const Equation<Box>& equation : equations.list()) {
    const Box rest = equation.lhs - equation.rhs;
    if (!rest.is_finite()) {
      ++tally.wide;
      continue;
    }
    ++tally.bounded;
    if (!rest.contains_zero()) {
      tally.refutation = as_text(equation.lhs) + " against " + as_text(equation.rhs);
    } else {
      tally.widest = std::max(tally.widest, rest.radius());
    }
  }
  for (const Box& value : equations.positives()) {
    const Truth sign = less(from_int<Box>(0), value);
    if (sign == Truth::no) tally.refutation = as_text(value) + " is not positive";
    tally.positive += definitely(sign) ? 1 : 0;
    tally.unsure += sign == Truth::unknown ? 1 : 0;
  }
}

/// "2^-40", or "0" where both sides are the same exact number on every box.
std::string power_text(double width) {
  if (width == 0) return "0";
  char text[32];
  std::snprintf(text, sizeof text, "2^%.0f", std::log2(width));
  return text;
}

/// Why they have shown nothing, or nothing.
std::string why_nothing(const Tally& tally, const Finding& finding) {
  if (finding.sizes.empty()) return no_size;
  if (finding.trials == 0) return "no box meets the hypotheses";
  if (tally.bounded == 0 && tally.wide > 0) return "no difference is bounded";
  return tally.bounded + tally.positive + tally.unsure == 0 ? "nothing asserted" : "";
}

}  // namespace

Finding judge_ball(const ClaimCase<Box>& claim, const Plan& plan) {
  Finding finding = open_finding(*claim.info, "ball", plan);
  if (claim.info->kind == Kind::example) return finding;
  const int trials = plan.effort == Effort::quick ? 4 : plan.effort == Effort::standard ? 12 : 60;
  Tally tally;
  for (const Size size : sizes_for(*claim.info, plan.effort == Effort::quick ? grid(3, 3) : grid(4, 5))) {
    const std::string task = finding.claim + "/ball/" + std::to_string(size.n) + "/" + std::to_string(size.pieces);
    for (int trial = 0; trial < trials; ++trial) {
      DyadicSource<Box> source(seed_of(plan.seed, task, static_cast<std::uint64_t>(trial)), widened);
      Sample<Box> sample;
      bool admitted = true;
      const auto begin = [&](const NonZero<Box>& nonzero) {
        for (const auto& factors : nonzero) {
          for (const Box& factor : factors) admitted = admitted && !possibly(is_zero(factor));
        }
        return admitted;
      };
      try {
        claim.run(source, size, Mutant(plan.mutant), sample, begin);
      } catch (const Error&) {
        ++tally.wide;
      }
      if (!admitted) {
        ++finding.discards;
        continue;
      }
      ++finding.trials;
      look_at(sample.equations, tally);
      if (!tally.refutation.empty()) {
        finding.status = Status::refuted;
        finding.detail = tally.refutation;
        finding.sizes = {size};
        return finding;
      }
    }
    finding.sizes.push_back(size);
  }
  if (const std::string why = why_nothing(tally, finding); !why.empty()) return gave_up(std::move(finding), why);
  char text[160];
  if (tally.positive + tally.unsure > 0) {
    std::snprintf(text, sizeof text, "positive on %ld boxes, undecided on %ld; widest difference %s", tally.positive,
                  tally.unsure, power_text(tally.widest).c_str());
  } else {
    std::snprintf(text, sizeof text, "%ld boxes, widest difference %s", finding.trials,
                  power_text(tally.widest).c_str());
  }
  finding.status = Status::bounded;
  finding.detail = text;
  return finding;
}

Finding run_ball(std::size_t index, const Plan& plan) { return judge_ball(claim_cases<Box>()[index], plan); }

}  // namespace torse::proofs
