#include "torse/exact/ball/ball.hpp"
#include "torse/proofs/claims/bzz19/list.hpp"
#include "torse/proofs/models.hpp"

namespace torse::proofs {

template <class S>
std::vector<ClaimCase<S>> bzz19_cases() {
  return bzz19::Claims::cases<S>();
}

template std::vector<ClaimCase<Ball<128>>> bzz19_cases<Ball<128>>();

}  // namespace torse::proofs
