// What the exact engines say of small claims that hold, assert nothing, throw, or are false in a corner.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "unit/proofs/small_claim.hpp"

namespace torse::proofs {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;

template <class S>
void square_of_the_sum(const Given<S>& in, Equations<S>& equations) {
  const S sum = in.x + in.y;
  equations.equal(sum * sum, in.x * in.x + from_int<S>(2) * in.x * in.y + in.y * in.y);
}

std::vector<Status> statuses(const std::vector<Finding>& findings) {
  std::vector<Status> list;
  for (const Finding& finding : findings) list.push_back(finding.status);
  return list;
}

TEST(EveryEngine, AClaimThatHolds) {
  const SmallClaim claim{facts(2, 2), Always(),
                         []<class S>(const Given<S>& in, Equations<S>& e) { square_of_the_sum(in, e); }};
  EXPECT_THAT(statuses(judged_by_all(claim)), ElementsAre(Status::proved, Status::supported, Status::supported,
                                                          Status::bounded, Status::bounded, Status::supported));
}

TEST(EveryEngine, AClaimThatAssertsNothingIsNoSuccess) {
  const SmallClaim claim{facts(2, 2), Always(), []<class S>(const Given<S>&, Equations<S>&) {}};
  EXPECT_THAT(statuses(judged_by_all(claim)), ElementsAre(Status::refuted, Status::gave_up, Status::refuted,
                                                          Status::gave_up, Status::refuted, Status::gave_up));
  EXPECT_THAT(symbolic(claim).detail, EndsWith("the claim asserted nothing"));
  EXPECT_THAT(modular(claim).detail, EndsWith("nothing asserted"));
  EXPECT_EQ(ball(claim).detail, "nothing asserted");
  EXPECT_EQ(mutation(claim).detail, "n=2, N=2: nothing to corrupt");
}

TEST(EveryEngine, AClaimThatAssertsNothingAtOneSize) {
  const SmallClaim claim{facts(2, 1), Always(), []<class S>(const Given<S>& in, Equations<S>& equations) {
                           if (in.size.n == 2) square_of_the_sum(in, equations);
                         }};
  for (const Finding& finding : {symbolic(claim), rational(claim)}) {
    EXPECT_EQ(finding.status, Status::refuted) << finding.engine;
    EXPECT_THAT(finding.sizes, ElementsAre(Size{1, 1})) << finding.engine;
  }
  EXPECT_EQ(modular(claim).status, Status::gave_up);
}

TEST(EveryEngine, AClaimThatThrows) {
  const SmallClaim claim{facts(2, 2), Always(),
                         []<class S>(const Given<S>&, Equations<S>&) { throw InvalidInput("place", "wrong"); }};
  EXPECT_THAT(statuses(judged_by_all(claim)), ElementsAre(Status::refuted, Status::gave_up, Status::refuted,
                                                          Status::gave_up, Status::refuted, Status::gave_up));
  EXPECT_THAT(symbolic(claim).detail, HasSubstr("n=1, N=1: threw: "));
  EXPECT_THAT(modular(claim).detail, HasSubstr("n=1, N=1: threw: "));
  EXPECT_EQ(ball(claim).detail, "no difference is bounded");
  EXPECT_EQ(mutation(claim).detail, "n=2, N=2: nothing to corrupt");
}

TEST(EveryEngine, AClaimNoneOfWhoseSizesIsRun) {
  SmallClaim claim{facts(64, 1), Always(),
                   []<class S>(const Given<S>& in, Equations<S>& e) { square_of_the_sum(in, e); }};
  claim.info.min_degree = 50;
  for (const Finding& finding : judged_by_all(claim)) {
    EXPECT_EQ(finding.status, Status::gave_up) << finding.engine;
    EXPECT_EQ(finding.detail, no_size) << finding.engine;
  }
}

TEST(EveryEngine, HypothesesThatNoInputMeets) {
  const SmallClaim claim{facts(2, 2), []<class S>(const Given<S>& in) { return NonZero<S>{{in.x - in.x}}; },
                         []<class S>(const Given<S>& in, Equations<S>& e) { square_of_the_sum(in, e); }};
  for (const Finding& finding : judged_by_all(claim)) {
    EXPECT_EQ(finding.status, Status::gave_up) << finding.engine;
    EXPECT_EQ(finding.trials, finding.engine == "symbolic" ? 1 : 0) << finding.engine;
  }
  EXPECT_EQ(mutation(claim).detail, "n=2, N=2: nothing to corrupt");
}

/// Inputs that the hypotheses leave out tell nothing of a wrong variant.
TEST(Mutation, AWrongVariantThatNoInputMeetsSurvives) {
  const auto residual = []<class S>(const Given<S>& in, Equations<S>& e) {
    e.equal(in.x, in.mutant.is(1) ? in.y : in.x);
  };
  SmallClaim met{facts(2, 2), Always(), residual};
  met.info.mutants = {"y for x"};
  EXPECT_EQ(mutation(met).mutants.killed, 1);
  SmallClaim unmet{facts(2, 2), []<class S>(const Given<S>& in) { return NonZero<S>{{in.x - in.x}}; }, residual};
  unmet.info.mutants = {"y for x"};
  EXPECT_EQ(mutation(unmet).mutants.killed, 0);
  EXPECT_EQ(mutation(unmet).mutants.survived, 1);
}

TEST(EveryEngine, AClaimThatIsFalseAtOneSize) {
  const SmallClaim claim{facts(3, 2), Always(), []<class S>(const Given<S>& in, Equations<S>& equations) {
                           equations.equal(in.x, in.size == Size{2, 2} ? in.y : in.x);
                         }};
  for (const Finding& finding : {symbolic(claim), modular(claim), rational(claim), ball(claim), numeric(claim)}) {
    EXPECT_EQ(finding.status, Status::refuted) << finding.engine;
    EXPECT_THAT(finding.sizes, ElementsAre(Size{2, 2})) << finding.engine;
  }
}

TEST(Symbolic, AHypothesisThatVanishesAtOneSize) {
  const SmallClaim claim{facts(2, 1),
                         []<class S>(const Given<S>& in) { return NonZero<S>{{from_int<S>(in.size.n - 1) * in.x}}; },
                         []<class S>(const Given<S>& in, Equations<S>& e) { square_of_the_sum(in, e); }};
  const Finding finding = symbolic(claim);
  EXPECT_EQ(finding.status, Status::gave_up);
  EXPECT_EQ(finding.detail, "n=1, N=1: a hypothesis vanishes identically");
}

/// The probability that a random prime of 62 bits divides a given number of `bits` bits.
double of_one_prime(double bits) { return bits / 61 / static_cast<double>(prime_count_lower_bound); }

/// The integral of 1 / log x from 2^61 to 2^62, by Simpson's rule, is near their number (prime number theorem), which
/// prime.hpp names.
TEST(Modular, ThereAreAsManyPrimesAsThat) {
  constexpr int steps = 1000;
  double sum = 0;
  for (int i = 0; i <= steps; ++i) {
    const double x = std::ldexp(1 + static_cast<double>(i) / steps, 61);
    sum += (i == 0 || i == steps ? 1 : i % 2 == 0 ? 2 : 4) / std::log(x);
  }
  const double primes = sum * std::ldexp(1.0, 61) / (3 * steps);
  EXPECT_NEAR(primes / 54042323540385838.0, 1, 1e-6);
  EXPECT_LT(static_cast<double>(prime_count_lower_bound), primes);
  EXPECT_GT(static_cast<double>(prime_count_lower_bound), primes * 0.9);
}

TEST(Modular, TheErrorBoundByHand) {
  // (x + y)^2 and x (x + 2 y) + y^2 have norms 2^2 and 3 + 1, so that no coefficient of the difference exceeds 8 = 2^3.
  // 64 points of degree 2 err with (2/2^61)^64 beside it. The target 2^-60 takes two primes.
  const auto residual = []<class S>(const Given<S>& in, Equations<S>& e) { square_of_the_sum(in, e); };
  const SmallClaim one_size{facts(1, 1), Always(), residual};
  const SmallClaim two_sizes{facts(1, 2), Always(), residual};
  const double expected = 2 * std::log2(of_one_prime(3));
  const Finding one = modular(one_size);
  ASSERT_TRUE(one.error_log2.has_value());
  EXPECT_NEAR(*one.error_log2, expected, 1e-9);
  EXPECT_EQ(one.trials, 128);
  const Finding two = modular(two_sizes);
  ASSERT_TRUE(two.error_log2.has_value());
  EXPECT_NEAR(*two.error_log2, expected + 1, 1e-9);
  // 2 log2(3 / (61 52e15)) = -119.7503, and one more for two sizes.
  EXPECT_EQ(one.detail, "error < 2^-119; largest numerator: degree 2, 3 bits");
  EXPECT_EQ(two.detail, "error < 2^-118; largest numerator: degree 2, 3 bits");
}

TEST(Modular, WhatIsUndefinedDoesNotAgree) {
  const SmallClaim claim{facts(1, 1), Always(), []<class S>(const Given<S>& in, Equations<S>& equations) {
                           const S ratio = in.x / (in.y - in.y);
                           equations.equal(ratio, ratio);
                         }};
  const Finding finding = modular(claim);
  EXPECT_EQ(finding.status, Status::refuted);
  EXPECT_EQ(finding.detail, "n=1, N=1: differs modulo a prime at lane 0");
}

TEST(Rational, AMissingHypothesisIsFoundByEqualInputs) {
  const SmallClaim claim{facts(4, 4), Always(), []<class S>(const Given<S>& in, Equations<S>& equations) {
                           equations.equal((in.x - in.y) / (in.x - in.y), from_int<S>(1));
                         }};
  const Finding finding = rational(claim);
  EXPECT_EQ(finding.status, Status::refuted);
  EXPECT_THAT(finding.detail, HasSubstr("threw: "));
}

/// That inner knots increase: true of all tempers but one.
TEST(Rational, InputsHaveRepeatedInnerKnots) {
  const ClaimInfo info = facts(3, 12);
  ClaimCase<Rational> claim;
  claim.info = &info;
  claim.points = PointKind::space;
  claim.run = [](Source<Rational>& from, Size size, Mutant, Sample<Rational>& sample, const auto& begin) {
    const std::vector<Rational> u = from.knots(size);
    if (!begin(sample.nonzero)) return;
    sample.equations.zero(Rational());
    for (int i = size.n; i < size.last() - 1; ++i) {
      sample.equations.positive(u.at(static_cast<std::size_t>(i) + 1) - u.at(static_cast<std::size_t>(i)));
    }
  };
  claim.failures = [] { return std::vector<FailureSample<Rational>>(); };
  const Finding finding = judge_rational(claim, quick_plan());
  EXPECT_EQ(finding.status, Status::refuted);
  EXPECT_THAT(finding.detail, EndsWith("0 is not positive"));
}

/// What the engine says of x / x = y / y with a stored failure of x != 0 whose hypotheses have these values.
Finding with_failure(std::size_t hypothesis, int x, int y, const std::string& error) {
  const SmallClaim claim{facts(1, 1),
                         []<class S>(const Given<S>& in) {
                           return NonZero<S>{{in.x}, {in.y}};
                         },
                         []<class S>(const Given<S>& in, Equations<S>& e) { e.equal(in.x / in.x, in.y / in.y); }};
  ClaimCase<Rational> entry = claim.over<Rational>();
  entry.failures = [&] {
    FailureSample<Rational> failure{hypothesis, {{{Rational(x)}, {Rational(y)}}, {}}, error};
    if (error.empty()) failure.sample.equations.equal(Rational(1), Rational(1));
    return std::vector<FailureSample<Rational>>{failure};
  };
  return judge_rational(entry, quick_plan());
}

TEST(Rational, AStoredFailureViolatesItsHypothesisAlone) {
  EXPECT_EQ(with_failure(0, 0, 1, "division by zero").status, Status::supported);
  EXPECT_EQ(with_failure(1, 1, 0, "division by zero").status, Status::supported);
  for (const Finding& finding : {with_failure(0, 0, 0, "division by zero"), with_failure(0, 1, 0, "division by zero"),
                                 with_failure(0, 1, 1, "division by zero")}) {
    EXPECT_EQ(finding.status, Status::refuted);
    EXPECT_EQ(finding.detail, "the stored failure of hypothesis 1 does not violate that one alone");
  }
  EXPECT_EQ(with_failure(1, 0, 0, "division by zero").detail,
            "the stored failure of hypothesis 2 does not violate that one alone");
}

TEST(Rational, AStoredFailureAtWhichTheClaimHolds) {
  const Finding finding = with_failure(0, 0, 1, "");
  EXPECT_EQ(finding.status, Status::refuted);
  EXPECT_EQ(finding.detail, "the stored failure of hypothesis 1 is none: the claim holds there");
}

}  // namespace
}  // namespace torse::proofs
