// The claims of ZW06 (Zhang and Wang 2006) in ledger order.
#pragma once

#include "torse/proofs/claims/zw06/aumann.hpp"
#include "torse/proofs/claims/zw06/chords.hpp"
#include "torse/proofs/claims/zw06/cones.hpp"
#include "torse/proofs/claims/zw06/decomposition.hpp"
#include "torse/proofs/claims/zw06/developability.hpp"
#include "torse/proofs/claims/zw06/system.hpp"
#include "torse/proofs/claims/zw06/tangents.hpp"
#include "torse/proofs/table.hpp"

namespace torse::proofs::zw06 {

using Claims =
    ClaimList<Eq5, Eq6, Eq7, Eq8, Eq9, Eq10, Eq11, Eq12, Eq13, Eq14, Eq15, Eq16, Eq17, Eq18, Eq19, Eq20, G, Unique>;

}  // namespace torse::proofs::zw06
