// Claims about two numbers x and y, for the engines to judge.
//   Given            what such a claim is told          SmallClaim       its hypotheses and what it asserts
//   judged_by_all    what every engine says of it, in ledger order
#pragma once

#include <utility>
#include <vector>

#include "torse/exact/rational/rational.hpp"
#include "torse/proofs/engines/cases.hpp"

namespace torse::proofs {

/// One input of a small claim.
template <class S>
struct Given {
  S x;
  S y;
  Size size;
  Mutant mutant;
};

/// No hypotheses.
struct Always {
  template <class S>
  NonZero<S> operator()(const Given<S>&) const {
    return {};
  }
};

/// nonzero(Given<S>) gives the hypotheses, residual(Given<S>, Equations<S>&) asserts. It has to outlive its cases.
template <class Hypotheses, class Residual>
struct SmallClaim {
  ClaimInfo info;
  Hypotheses nonzero;
  Residual residual;

  template <class S>
  ClaimCase<S> over() const {
    const auto drawn = [](Source<S>& from, Size size, Mutant mutant) {
      S x = from.scalar();
      return Given<S>{std::move(x), from.scalar(), size, mutant};
    };
    ClaimCase<S> entry;
    entry.info = &info;
    entry.points = PointKind::space;
    entry.run = [this, drawn](Source<S>& from, Size size, Mutant mutant, Sample<S>& sample,
                              const typename ClaimCase<S>::Begin& begin) {
      const Given<S> in = drawn(from, size, mutant);
      sample.nonzero = nonzero(in);
      if (begin(sample.nonzero)) residual(in, sample.equations);
    };
    entry.draw = [drawn](Source<S>& from, Size size) { static_cast<void>(drawn(from, size, Mutant())); };
    entry.failures = [] { return std::vector<FailureSample<S>>(); };
    return entry;
  }
};

template <class Hypotheses, class Residual>
SmallClaim(ClaimInfo, Hypotheses, Residual) -> SmallClaim<Hypotheses, Residual>;

/// Facts of a claim for 1 <= n <= max_degree and 1 <= N <= max_pieces.
inline ClaimInfo facts(int max_degree, int max_pieces) {
  ClaimInfo info;
  info.id = "TEST.1";
  info.max_degree = max_degree;
  info.max_pieces = max_pieces;
  return info;
}

inline Plan quick_plan() {
  Plan plan;
  plan.effort = Effort::quick;
  return plan;
}

template <class Claim>
Finding symbolic(const Claim& claim) {
  return judge_symbolic(claim.template over<RationalFunction>(), quick_plan());
}

template <class Claim>
Finding modular(const Claim& claim) {
  return judge_modular(claim.template over<Batch>(), claim.template over<Degree>(), quick_plan());
}

template <class Claim>
Finding rational(const Claim& claim) {
  return judge_rational(claim.template over<Rational>(), quick_plan());
}

template <class Claim>
Finding ball(const Claim& claim) {
  return judge_ball(claim.template over<Box>(), quick_plan());
}

template <class Claim>
Finding numeric(const Claim& claim) {
  return judge_numeric(claim.template over<Rational>(),
                       {claim.template over<float>(), claim.template over<double>(), claim.template over<long double>(),
                        claim.template over<BigFloat<113>>()},
                       quick_plan());
}

template <class Claim>
Finding mutation(const Claim& claim) {
  return judge_mutation(claim.template over<Rational>(),
                        {claim.template over<Faulty<Rational>>(), claim.template over<Faulty<Batch>>()}, quick_plan());
}

template <class Claim>
std::vector<Finding> judged_by_all(const Claim& claim) {
  return {symbolic(claim), modular(claim), rational(claim), ball(claim), numeric(claim), mutation(claim)};
}

}  // namespace torse::proofs
