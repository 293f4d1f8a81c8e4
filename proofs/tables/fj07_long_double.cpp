#include "torse/proofs/claims/fj07/list.hpp"
#include "torse/proofs/models.hpp"
#include "torse/scalar/builtin.hpp"

namespace torse::proofs {

template <class S>
std::vector<ClaimCase<S>> fj07_cases() {
  return fj07::Claims::cases<S>();
}

template std::vector<ClaimCase<long double>> fj07_cases<long double>();

}  // namespace torse::proofs
