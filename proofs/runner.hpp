// The runner: claims x engines on all cores, deterministic for a seed, in shards.
//   Selection     which claims and engines          run_all    their findings, in order
//   Entry         one claim's findings together with its overall status
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "torse/proofs/engines/engine.hpp"

namespace torse::proofs {

/// What to run. Empty lists mean all. Task k of the run (claims x engines, in ledger order) belongs to shard k mod
/// `shards`: the shards' union is the whole run.
struct Selection {
  std::vector<std::string> claims;
  std::vector<std::string> papers;
  std::vector<std::string> engines;
  int shard = 0;
  int shards = 1;
};

/// One claim and what was found out about it.
struct Entry {
  const ClaimInfo* info;
  std::vector<Finding> findings;

  /// The strongest thing that may be said: Refuted if any engine refutes; otherwise Proved, Supported, Bounded in this
  /// order; GaveUp or Undecided if nothing else.
  Status status() const;
  /// The finding that earns status(); none if there are no findings. The mutation engine speaks of the tests'
  /// sharpness, not of the claim, and earns a status only where it ran alone.
  const Finding* decisive() const;
  /// The mutation engine's scores, zero where it did not run.
  Score mutants() const;
  Score faults() const;
};

/// Called after each task with the number done and the number of all, from one thread at a time.
using Progress = std::function<void(std::size_t done, std::size_t all, const Finding& latest)>;

/// Runs the selection with `threads` threads. The findings do not depend on their number. An exception of an engine
/// that is not a finding (a defect) is rethrown.
std::vector<Entry> run_all(const Selection& selection, const Plan& plan, unsigned threads, const Progress& progress);

}  // namespace torse::proofs
