// A run of the ledger as JSON (the contract of docs/formats.md), and its comparison with an earlier one.
#pragma once

#include <string>
#include <vector>

#include "torse/proofs/runner.hpp"

namespace torse::proofs {

/// {"torse": 1, "effort", "seed", "claims": [...]}: one object per claim with the status that may be said of it, the
/// engine that earned it, and every engine's finding under "engines". "as_printed" is false where the status holds only
/// under a hypothesis that the paper does not state; its failure without it is among the stored ones.
std::string json_report(const std::vector<Entry>& entries, const Plan& plan);

/// What of a run does not change from one machine to the next: a claim a line, with status, engine, sizes and scores.
/// It is the file proofs/ledger.json, and a baseline.
std::string ledger(const std::vector<Entry>& entries, const Plan& plan);

/// What a run is about: all claims in all engines, those that were chosen, or a part of such a run.
enum class Extent { whole, selected, shard };

/// What got worse since the earlier report or ledger `baseline` (JSON text): claims that lost their status, or that a
/// whole run has no more. What chosen engines say of a claim is all that counts; in a shard, of which other engines may
/// be a part, a status below the earlier one counts where the engine that had earned that ran, or where it is a
/// refutation. Throws Error with the reason if `baseline` is not such a report.
std::vector<std::string> regressions(const std::string& baseline, const std::vector<Entry>& entries, Extent extent);

/// "1<=n<=4, 1<=N<=4" for a full grid, otherwise the sizes themselves.
std::string sizes_text(const std::vector<Size>& sizes);

/// "quick", "standard", "deep".
std::string_view effort_name(Effort effort);

/// The command that runs one finding again.
std::string replay_command(const Finding& finding, const Plan& plan);

}  // namespace torse::proofs
