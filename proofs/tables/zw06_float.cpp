#include "torse/proofs/claims/zw06/list.hpp"
#include "torse/proofs/models.hpp"
#include "torse/scalar/builtin.hpp"

namespace torse::proofs {

template <class S>
std::vector<ClaimCase<S>> zw06_cases() {
  return zw06::Claims::cases<S>();
}

template std::vector<ClaimCase<float>> zw06_cases<float>();

}  // namespace torse::proofs
