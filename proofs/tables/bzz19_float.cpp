#include "torse/proofs/claims/bzz19/list.hpp"
#include "torse/proofs/models.hpp"
#include "torse/scalar/builtin.hpp"

namespace torse::proofs {

template <class S>
std::vector<ClaimCase<S>> bzz19_cases() {
  return bzz19::Claims::cases<S>();
}

template std::vector<ClaimCase<float>> bzz19_cases<float>();

}  // namespace torse::proofs
