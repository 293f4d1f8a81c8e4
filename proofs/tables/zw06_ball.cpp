#include "torse/exact/ball/ball.hpp"
#include "torse/proofs/claims/zw06/list.hpp"
#include "torse/proofs/models.hpp"

namespace torse::proofs {

template <class S>
std::vector<ClaimCase<S>> zw06_cases() {
  return zw06::Claims::cases<S>();
}

template std::vector<ClaimCase<Ball<128>>> zw06_cases<Ball<128>>();

}  // namespace torse::proofs
