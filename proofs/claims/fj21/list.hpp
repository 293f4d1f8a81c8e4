// The claims of FJ21 in ledger order.
#pragma once

#include "torse/proofs/claims/fj21/blossoms.hpp"
#include "torse/proofs/claims/fj21/characterisation.hpp"
#include "torse/proofs/claims/fj21/condition.hpp"
#include "torse/proofs/claims/fj21/curves.hpp"
#include "torse/proofs/claims/fj21/example.hpp"
#include "torse/proofs/claims/fj21/factors.hpp"
#include "torse/proofs/claims/fj21/features.hpp"
#include "torse/proofs/claims/fj21/frame.hpp"
#include "torse/proofs/claims/fj21/net.hpp"
#include "torse/proofs/claims/fj21/regression.hpp"
#include "torse/proofs/claims/fj21/splines.hpp"
#include "torse/proofs/claims/fj21/tangent_surface.hpp"
#include "torse/proofs/claims/fj21/witnesses.hpp"
#include "torse/proofs/table.hpp"

namespace torse::proofs::fj21 {

using Claims = ClaimList<Eq2_1, Eq3_1, Eq3_2, P3_1, C3_1, Eq3_3, Eq3_5, T3_1, T3_1_excluded, T3_2, T3_2_pieces, Eq4_1,
                         Eq4_3, Eq4_4, C4_1, W, Eq5_1, Eq5_2, Eq5_3, Eq5_4, K, Eq6, Eq6_1, C6_1, T6_1, T6_1_cone,
                         T6_1_witnesses, Eq7_1, E8>;

}  // namespace torse::proofs::fj21
