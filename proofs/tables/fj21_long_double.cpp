#include "torse/proofs/claims/fj21/list.hpp"
#include "torse/proofs/models.hpp"
#include "torse/scalar/builtin.hpp"

namespace torse::proofs {

template <class S>
std::vector<ClaimCase<S>> fj21_cases() {
  return fj21::Claims::cases<S>();
}

template std::vector<ClaimCase<long double>> fj21_cases<long double>();

}  // namespace torse::proofs
