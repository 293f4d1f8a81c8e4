// The explicit list of all claims: no registration, nothing for a linker to drop.
#include "torse/proofs/claims/bzz19/list.hpp"
#include "torse/proofs/claims/fj07/list.hpp"
#include "torse/proofs/claims/fj21/list.hpp"
#include "torse/proofs/claims/zw06/list.hpp"
#include "torse/proofs/table.hpp"

namespace torse::proofs {

const std::vector<const ClaimInfo*>& all_claims() {
  static const std::vector<const ClaimInfo*> all = [] {
    std::vector<const ClaimInfo*> list = fj07::Claims::infos();
    for (const ClaimInfo* info : zw06::Claims::infos()) list.push_back(info);
    for (const ClaimInfo* info : fj21::Claims::infos()) list.push_back(info);
    for (const ClaimInfo* info : bzz19::Claims::infos()) list.push_back(info);
    return list;
  }();
  return all;
}

}  // namespace torse::proofs
