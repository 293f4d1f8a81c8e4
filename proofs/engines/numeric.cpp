// Floating-point scalars against exact arithmetic on the same inputs, which are short dyadic numbers: the error of both
// sides of every equation in ulps of the exact value. The exact run decides; a large error alone refutes nothing.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "torse/exact/rational/rational.hpp"
#include "torse/proofs/engines/cases.hpp"
#include "torse/proofs/engines/judge.hpp"
#include "torse/proofs/sources.hpp"
#include "torse/proofs/table.hpp"

namespace torse::proofs {

namespace {

/// The exact value of a finite floating-point number: peeled off in doubles, each the nearest to what remains.
template <class S>
Rational exact_value(S x) {
  if constexpr (std::floating_point<S>) {
    Rational value;
    while (x != 0) {
      const double part = static_cast<double>(x);
      value += Rational::from_double(part);
      x -= static_cast<S>(part);
    }
    return value;
  } else {
    return x.to_rational();
  }
}

template <class S>
bool finite(const S& x) {
  if constexpr (std::floating_point<S>) {
    return std::isfinite(x);
  } else {
    return mpfr_number_p(x.mpfr()) != 0;
  }
}

template <class S>
constexpr int precision = std::numeric_limits<S>::digits;
template <int Bits>
constexpr int precision<BigFloat<Bits>> = Bits;

/// The largest errors seen in one arithmetic.
struct Errors {
  double ulps = 0;     ///< |computed - exact| in units of 2^(1-p) |exact|
  double at_zero = 0;  ///< |computed| where the exact value is zero
  long overflows = 0;  ///< values that are not finite
};

template <class S>
void compare(const S& computed, const Rational& exact, Errors& errors) {
  if (!finite(computed)) {
    ++errors.overflows;
    return;
  }
  const Rational error = exact_value<S>(computed) - exact;
  if (definitely(is_zero(error))) return;
  if (definitely(is_zero(exact))) {
    errors.at_zero = std::max(errors.at_zero, std::abs(error.to_double()));
  } else {
    errors.ulps = std::max(errors.ulps, std::ldexp(std::abs((error / exact).to_double()), precision<S> - 1));
  }
}

/// Runs one input in S beside the exact evaluation of the same input.
template <class S>
void measure(const ClaimCase<S>& claim, Size size, std::uint64_t seed, const Equations<Rational>& exact,
             Errors& errors) {
  DyadicSource<S> source(seed);
  Sample<S> sample;
  try {
    claim.run(source, size, Mutant(), sample, [](const NonZero<S>&) { return true; });
  } catch (const Error&) {
    ++errors.overflows;
    return;
  }
  const auto& rounded = sample.equations.list();
  for (std::size_t i = 0; i < std::min(rounded.size(), exact.list().size()); ++i) {
    compare(rounded[i].lhs, exact.list()[i].lhs, errors);
    compare(rounded[i].rhs, exact.list()[i].rhs, errors);
  }
}

std::string shown(const char* name, const Errors& errors) {
  char text[96];
  std::snprintf(text, sizeof text, "%s %.3g ulp", name, errors.ulps);
  return errors.overflows > 0 ? std::string(text) + " (" + std::to_string(errors.overflows) + " not finite)" : text;
}

}  // namespace

Finding judge_numeric(const ClaimCase<Rational>& claim, const RoundedCases& rounded, const Plan& plan) {
  Finding finding = open_finding(*claim.info, "numeric", plan);
  if (claim.info->kind == Kind::example) return finding;
  const std::vector<Size> wanted = plan.effort == Effort::quick ? grid(3, 3) : grid(4, 8);
  const int trials = plan.effort == Effort::quick ? 4 : plan.effort == Effort::standard ? 12 : 60;
  Errors single;
  Errors twice;
  Errors extended;
  Errors quad;
  for (const Size size : sizes_for(*claim.info, wanted)) {
    const std::string task = finding.claim + "/numeric/" + std::to_string(size.n) + "/" + std::to_string(size.pieces);
    for (int trial = 0; trial < trials; ++trial) {
      const std::uint64_t seed = seed_of(plan.seed, task, static_cast<std::uint64_t>(trial));
      DyadicSource<Rational> source(seed);
      Sample<Rational> sample;
      const Verdict exact = run_once(claim, source, size, Mutant(plan.mutant), sample);
      if (!exact.admitted) {
        ++finding.discards;
        continue;
      }
      ++finding.trials;
      if (!exact.agrees) {
        finding.status = Status::refuted;
        finding.detail = exact.reason;
        finding.sizes = {size};
        return finding;
      }
      measure(rounded.single, size, seed, sample.equations, single);
      measure(rounded.twice, size, seed, sample.equations, twice);
      measure(rounded.extended, size, seed, sample.equations, extended);
      measure(rounded.quad, size, seed, sample.equations, quad);
    }
    finding.sizes.push_back(size);
  }
  if (finding.sizes.empty()) return gave_up(std::move(finding), no_size);
  if (finding.trials == 0) return gave_up(std::move(finding), "no input meets the hypotheses");
  finding.status = Status::bounded;
  finding.detail = shown("float", single) + ", " + shown("double", twice) + ", " + shown("long double", extended) +
                   ", " + shown("113 bits", quad);
  return finding;
}

Finding run_numeric(std::size_t index, const Plan& plan) {
  return judge_numeric(claim_cases<Rational>()[index],
                       {claim_cases<float>()[index], claim_cases<double>()[index], claim_cases<long double>()[index],
                        claim_cases<BigFloat<113>>()[index]},
                       plan);
}

}  // namespace torse::proofs
