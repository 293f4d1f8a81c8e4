#include "torse/exact/ball/ball.hpp"
#include "torse/proofs/claims/fj07/list.hpp"
#include "torse/proofs/models.hpp"

namespace torse::proofs {

template <class S>
std::vector<ClaimCase<S>> fj07_cases() {
  return fj07::Claims::cases<S>();
}

template std::vector<ClaimCase<Ball<128>>> fj07_cases<Ball<128>>();

}  // namespace torse::proofs
