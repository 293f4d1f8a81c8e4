#include "torse/proofs/claims/fj21/list.hpp"
#include "torse/proofs/models.hpp"
#include "torse/scalar/builtin.hpp"

namespace torse::proofs {

template <class S>
std::vector<ClaimCase<S>> fj21_cases() {
  return fj21::Claims::cases<S>();
}

template std::vector<ClaimCase<float>> fj21_cases<float>();

}  // namespace torse::proofs
