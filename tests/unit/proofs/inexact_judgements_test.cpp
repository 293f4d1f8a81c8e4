// What balls, floating point and corrupted operations say of small claims.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "unit/proofs/small_claim.hpp"

namespace torse::proofs {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

TEST(Ball, InequalitiesThatAreFalseAreRefuted) {
  const SmallClaim claim{facts(1, 1), Always(), []<class S>(const Given<S>& in, Equations<S>& equations) {
                           equations.positive(-(in.x * in.x) - from_int<S>(1));
                         }};
  const Finding finding = ball(claim);
  EXPECT_EQ(finding.status, Status::refuted);
  EXPECT_THAT(finding.detail, EndsWith("is not positive"));
}

TEST(Ball, InequalitiesOnBoxesAreCounted) {
  const SmallClaim true_one{facts(1, 1), Always(), []<class S>(const Given<S>& in, Equations<S>& equations) {
                              equations.positive(in.x * in.x + from_int<S>(1));
                            }};
  const SmallClaim open_one{facts(1, 1), Always(),
                            []<class S>(const Given<S>& in, Equations<S>& e) { e.positive(in.x - in.x); }};
  EXPECT_EQ(ball(true_one).status, Status::bounded);
  EXPECT_THAT(ball(true_one).detail, StartsWith("positive on 4 boxes, undecided on 0;"));
  EXPECT_THAT(ball(open_one).detail, StartsWith("positive on 0 boxes, undecided on 4;"));
}

TEST(Ball, EqualNumbersDifferByNothing) {
  const SmallClaim claim{facts(1, 1), Always(),
                         []<class S>(const Given<S>&, Equations<S>& e) { e.equal(from_int<S>(2), from_int<S>(2)); }};
  EXPECT_THAT(ball(claim).detail, EndsWith(" boxes, widest difference 0"));
  const SmallClaim both{facts(1, 1), Always(), []<class S>(const Given<S>&, Equations<S>& e) {
                          e.equal(from_int<S>(2), from_int<S>(2));
                          e.positive(from_int<S>(1));
                        }};
  EXPECT_EQ(ball(both).detail, "positive on 4 boxes, undecided on 0; widest difference 0");
}

TEST(Ball, ARefutationNamesBothSides) {
  const SmallClaim claim{facts(1, 1), Always(),
                         []<class S>(const Given<S>&, Equations<S>& e) { e.equal(from_int<S>(2), from_int<S>(3)); }};
  const Finding finding = ball(claim);
  EXPECT_EQ(finding.status, Status::refuted);
  EXPECT_THAT(finding.detail, HasSubstr(" against "));
}

TEST(Ball, GivesUpWhereNoDifferenceIsBounded) {
  const auto ratio = []<class S>(const Given<S>& in) { return in.x / (in.y - in.y); };
  const SmallClaim nowhere{facts(1, 1), Always(), [ratio]<class S>(const Given<S>& in, Equations<S>& equations) {
                             equations.equal(ratio(in), from_int<S>(1));
                           }};
  const SmallClaim somewhere{facts(1, 1), Always(), [ratio]<class S>(const Given<S>& in, Equations<S>& equations) {
                               equations.equal(ratio(in), from_int<S>(1));
                               equations.equal(in.x, in.x);
                             }};
  EXPECT_EQ(ball(nowhere).status, Status::gave_up);
  EXPECT_EQ(ball(nowhere).detail, "no difference is bounded");
  EXPECT_EQ(ball(somewhere).status, Status::bounded);
}

TEST(Numeric, TheErrorOfAThirdIsAQuarterOfAnUlp) {
  // 3 m = 2^(p+1) +- 1 for the p bits m of 1/3: a relative error of 2^-(p+1), a quarter of 2^(1-p).
  const SmallClaim claim{facts(1, 1), Always(), []<class S>(const Given<S>&, Equations<S>& equations) {
                           const S third = from_int<S>(1) / from_int<S>(3);
                           equations.equal(third, third);
                         }};
  EXPECT_EQ(numeric(claim).status, Status::bounded);
  EXPECT_EQ(numeric(claim).detail, "float 0.25 ulp, double 0.25 ulp, long double 0.25 ulp, 113 bits 0.25 ulp");
}

TEST(Numeric, WhatIsNotFiniteIsCounted) {
  const SmallClaim claim{facts(1, 1), Always(), []<class S>(const Given<S>&, Equations<S>& equations) {
                           S power = from_int<S>(2);  // 2^128, beyond float
                           for (int i = 0; i < 7; ++i) power = power * power;
                           equations.equal(power, power);
                         }};
  EXPECT_EQ(numeric(claim).detail, "float 0 ulp (8 not finite), double 0 ulp, long double 0 ulp, 113 bits 0 ulp");
}

/// Two operations that make the first equation fail, one that moves both sides of the second alike, one for nothing.
template <class S>
void shared_code(const Given<S>& in, Equations<S>& equations) {
  equations.equal(in.x + in.y, in.y + in.x);
  const S product = in.x * in.y;
  equations.equal(product, product);
  static_cast<void>(in.x - in.y);
}

TEST(Mutation, SidesThatMoveAlikeHaveSurvived) {
  SmallClaim claim{facts(2, 2), Always(), []<class S>(const Given<S>& in, Equations<S>& e) { shared_code(in, e); }};
  for (const Kind kind : {Kind::identity, Kind::example}) {
    claim.info.kind = kind;
    const Finding finding = mutation(claim);
    EXPECT_EQ(finding.status, Status::undecided);
    EXPECT_EQ(finding.faults.killed, 2);
    EXPECT_EQ(finding.faults.survived, 1);
    EXPECT_EQ(finding.faults.equivalent, 1);
    EXPECT_THAT(finding.survivors, ElementsAre("operation 2 of 4 at n=2, N=2"));
    EXPECT_EQ(finding.detail, "survived: operation 2 of 4 at n=2, N=2");
  }
}

TEST(Mutation, WrongVariantsThatAreRightSurvive) {
  SmallClaim claim{facts(2, 2), Always(), []<class S>(const Given<S>& in, Equations<S>& equations) {
                     equations.equal(in.x + in.y, in.mutant.is(1) ? in.x - in.y : in.y + in.x);
                   }};
  claim.info.mutants = {"the difference", "nothing"};
  const Finding finding = mutation(claim);
  EXPECT_EQ(finding.status, Status::undecided);
  EXPECT_EQ(finding.mutants.killed, 1);
  EXPECT_EQ(finding.mutants.survived, 1);
  EXPECT_THAT(finding.survivors, ElementsAre("mutant 2: nothing"));
}

TEST(Mutation, GivesUpWhereTheClaimThrowsAsItIs) {
  const SmallClaim claim{facts(2, 2), Always(), []<class S>(const Given<S>& in, Equations<S>& equations) {
                           equations.equal(in.x + in.y, in.y + in.x);
                           throw InvalidInput("place", "wrong");
                         }};
  const Finding finding = mutation(claim);
  EXPECT_EQ(finding.status, Status::gave_up);
  EXPECT_EQ(finding.faults.killed, 0);
}

TEST(Mutation, GivesUpWhereNoLaneIsAdmitted) {
  const SmallClaim claim{facts(2, 2), []<class S>(const Given<S>& in) { return NonZero<S>{{in.x - in.x}}; },
                         []<class S>(const Given<S>& in, Equations<S>& e) { e.equal(in.x + in.y, in.y + in.x); }};
  const Finding finding = mutation(claim);
  EXPECT_EQ(finding.status, Status::gave_up);
  EXPECT_EQ(finding.detail, "n=2, N=2: nothing to corrupt");
  EXPECT_EQ(finding.faults.equivalent, 0);
}

}  // namespace
}  // namespace torse::proofs
