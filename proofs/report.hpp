// A run of the ledger as JSON (the contract of docs/formats.md), and its comparison with an earlier one.
#pragma once

#include <string>
#include <vector>

#include "torse/proofs/runner.hpp"

namespace torse::proofs {

/// {"torse": 1, "effort", "seed", "claims": [...]}: one object per claim with the status that may be said of it, the
/// engine that earned it, and every engine's finding under "engines".
std::string json_report(const std::vector<Entry>& entries, const Plan& plan);

/// What got worse since the earlier report `baseline` (JSON text): claims that lost their status. Claims that were not
/// run now are passed over; `complete` tells that all were, so that a missing one counts. Throws Error with the reason
/// if `baseline` is not such a report.
std::vector<std::string> regressions(const std::string& baseline, const std::vector<Entry>& entries, bool complete);

/// "1<=n<=4, 1<=N<=4" for a full grid, otherwise the sizes themselves.
std::string sizes_text(const std::vector<Size>& sizes);

/// "quick", "standard", "deep".
std::string_view effort_name(Effort effort);

/// The command that runs one finding again.
std::string replay_command(const Finding& finding, const Plan& plan);

}  // namespace torse::proofs
