// The claims of BZZ19 (Bo, Zheng and Zhang 2019) in ledger order.
#pragma once

#include "torse/proofs/claims/bzz19/condition.hpp"
#include "torse/proofs/claims/bzz19/mapping.hpp"
#include "torse/proofs/claims/bzz19/pieces.hpp"
#include "torse/proofs/claims/bzz19/surface.hpp"
#include "torse/proofs/claims/bzz19/witnesses.hpp"
#include "torse/proofs/table.hpp"

namespace torse::proofs::bzz19 {

using Claims = ClaimList<Eq3, Eq4, Eq5, Witnesses, Eq6, Eq7, Eq8, Eq10, Eq11, Eq12, Eq13, Eq14, Eq15, Eq16, Warp>;

}  // namespace torse::proofs::bzz19
