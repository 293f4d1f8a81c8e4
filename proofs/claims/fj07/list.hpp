// The claims of FJ07 (Fernandez-Jambrina 2007) in ledger order.
#pragma once

#include "torse/proofs/claims/fj07/aumann.hpp"
#include "torse/proofs/claims/fj07/blossoms.hpp"
#include "torse/proofs/claims/fj07/cells.hpp"
#include "torse/proofs/claims/fj07/classes.hpp"
#include "torse/proofs/claims/fj07/cones.hpp"
#include "torse/proofs/claims/fj07/corollary2.hpp"
#include "torse/proofs/claims/fj07/developability.hpp"
#include "torse/proofs/claims/fj07/interpolation.hpp"
#include "torse/proofs/claims/fj07/linear_net.hpp"
#include "torse/proofs/claims/fj07/pieces.hpp"
#include "torse/proofs/claims/fj07/restriction.hpp"
#include "torse/proofs/table.hpp"

namespace torse::proofs::fj07 {

using Claims = ClaimList<Eq1, Eq2, Eq3, Eq4, Eq5, Eq6, Eq7, Eq8, Eq9, Theorem1, Eq10, Eq11, Eq12, Corollary1, Eq13,
                         Eq13Rulings, Corollary2, Eq14, Eq15, Eq16, Eq17, Eq18, Eq19, Corollary3, Eq20, Eq21>;

}  // namespace torse::proofs::fj07
