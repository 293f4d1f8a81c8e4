#include "torse/exact/bigfloat/bigfloat.hpp"
#include "torse/proofs/claims/fj21/list.hpp"
#include "torse/proofs/models.hpp"

namespace torse::proofs {

template <class S>
std::vector<ClaimCase<S>> fj21_cases() {
  return fj21::Claims::cases<S>();
}

template std::vector<ClaimCase<BigFloat<113>>> fj21_cases<BigFloat<113>>();

}  // namespace torse::proofs
