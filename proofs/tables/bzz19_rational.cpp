#include "torse/proofs/claims/bzz19/list.hpp"
#include "torse/proofs/models.hpp"

namespace torse::proofs {

template <class S>
std::vector<ClaimCase<S>> bzz19_cases() {
  return bzz19::Claims::cases<S>();
}

template std::vector<ClaimCase<Rational>> bzz19_cases<Rational>();

}  // namespace torse::proofs
