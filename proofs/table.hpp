// The claims of a scalar type, with their types erased: what the engines iterate over.
//   PointOf<C, S>       the point type on which claim C runs over S
//   ClaimCase<S>        one claim over S: run an input, count its free parameters, run its stored failures
//   claim_cases<S>      all claims over S, paper by paper (instantiated in tables/*.cpp)
#pragma once

#include <functional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "torse/proofs/claim.hpp"

namespace torse::proofs {

/// On which points linear and coplanar claims run over S. `coordinates`: vectors of the claim's dimension. `line`: one
/// coordinate for linear claims (each coordinate obeys the same identity). `generators`: a free module for both kinds.
enum class PointModel { coordinates, line, generators };

/// Specialised beside an engine for the scalars that want less than coordinates.
template <class S>
inline constexpr PointModel point_model = PointModel::coordinates;

namespace detail {

template <class C, class S>
auto point_of() {
  if constexpr (C::points == PointKind::linear && point_model<S> == PointModel::line) {
    return std::type_identity<Vec<S, 1>>{};
  } else if constexpr (C::points != PointKind::space && point_model<S> == PointModel::generators) {
    return std::type_identity<Form<S>>{};
  } else {
    return std::type_identity<Vec<S, C::dimension>>{};
  }
}

}  // namespace detail

template <class C, class S>
using PointOf = typename decltype(detail::point_of<C, S>())::type;

/// One evaluated input.
template <class S>
struct Sample {
  NonZero<S> nonzero;
  Equations<S> equations;
};

/// A stored input that violates one hypothesis, evaluated: `error` is what the library threw, if it did.
template <class S>
struct FailureSample {
  std::size_t hypothesis;
  Sample<S> sample;
  std::string error;
};

/// One claim over S.
template <class S>
struct ClaimCase {
  /// Asked between an input's hypotheses and its equations: whether to go on.
  using Begin = std::function<bool(const NonZero<S>&)>;

  const ClaimInfo* info;
  PointKind points;

  /// Draws an input, evaluates its hypotheses and, if `begin` says so, its equations.
  std::function<void(Source<S>&, Size, Mutant, Sample<S>&, const Begin&)> run;
  /// Draws an input and drops it.
  std::function<void(Source<S>&, Size)> draw;
  /// Evaluates the stored failures.
  std::function<std::vector<FailureSample<S>>()> failures;
};

/// The table entry of claim C over S.
template <class C, class S>
ClaimCase<S> make_case() {
  using P = PointOf<C, S>;
  ClaimCase<S> entry;
  entry.info = &C::info();
  entry.points = C::points;
  entry.run = [](Source<S>& from, Size size, Mutant mutant, Sample<S>& sample,
                 const typename ClaimCase<S>::Begin& begin) {
    const auto in = C::template draw<S, P>(from, size);
    sample.nonzero = C::template nonzero<S, P>(in);
    if (begin(sample.nonzero)) C::template residual<S, P>(in, mutant, sample.equations);
  };
  entry.draw = [](Source<S>& from, Size size) { static_cast<void>(C::template draw<S, P>(from, size)); };
  entry.failures = [] {
    std::vector<FailureSample<S>> result;
    if constexpr (ExactField<S> && requires { C::template failures<S, P>(); }) {
      for (const auto& failure : C::template failures<S, P>()) {
        FailureSample<S> evaluated{failure.hypothesis, {}, {}};
        evaluated.sample.nonzero = C::template nonzero<S, P>(failure.in);
        try {
          C::template residual<S, P>(failure.in, Mutant(), evaluated.sample.equations);
        } catch (const Error& error) {
          evaluated.error = error.what();
        }
        result.push_back(std::move(evaluated));
      }
    }
    return result;
  };
  return entry;
}

/// A list of claims.
template <class... C>
struct ClaimList {
  template <class S>
  static std::vector<ClaimCase<S>> cases() {
    return {make_case<C, S>()...};
  }
  static std::vector<const ClaimInfo*> infos() { return {&C::info()...}; }
};

/// The claims of each paper over S. Instantiated for each engine's scalars in tables/.
template <class S>
std::vector<ClaimCase<S>> fj07_cases();
template <class S>
std::vector<ClaimCase<S>> zw06_cases();
template <class S>
std::vector<ClaimCase<S>> fj21_cases();
template <class S>
std::vector<ClaimCase<S>> bzz19_cases();

/// All claims over S in ledger order.
template <class S>
const std::vector<ClaimCase<S>>& claim_cases() {
  static const std::vector<ClaimCase<S>> all = [] {
    std::vector<ClaimCase<S>> cases = fj07_cases<S>();
    for (ClaimCase<S>& entry : zw06_cases<S>()) cases.push_back(std::move(entry));
    for (ClaimCase<S>& entry : fj21_cases<S>()) cases.push_back(std::move(entry));
    for (ClaimCase<S>& entry : bzz19_cases<S>()) cases.push_back(std::move(entry));
    return cases;
  }();
  return all;
}

/// What is known of every claim, in ledger order.
const std::vector<const ClaimInfo*>& all_claims();

}  // namespace torse::proofs
