#include "torse/proofs/claims/fj07/list.hpp"
#include "torse/proofs/models.hpp"

namespace torse::proofs {

template <class S>
std::vector<ClaimCase<S>> fj07_cases() {
  return fj07::Claims::cases<S>();
}

template std::vector<ClaimCase<Faulty<Rational>>> fj07_cases<Faulty<Rational>>();

}  // namespace torse::proofs
