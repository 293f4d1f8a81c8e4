// Running a campaign: units that are missing in a database are run and stored.
//   Work, Advance, Ran      how, how far, what came of it
//   run_campaign            by the threads of this process, and those of other processes that it leads
//   follow                  what the other processes do
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "torse/fuzz/campaign/ranks.hpp"
#include "torse/fuzz/campaign/store.hpp"

namespace torse::fuzz {

/// How the units are run.
struct Work {
  unsigned jobs = 1;  ///< threads of this process
  /// After this time no more units are begun.
  std::optional<std::chrono::duration<double>> time{};
  /// Called once, when so much more time has passed and units have not ended, with their names.
  std::function<void(const std::string&)> overdue{};
  std::chrono::duration<double> grace = std::chrono::minutes(1);
};

/// How far a run is.
struct Advance {
  std::uint64_t units = 0;  ///< stored in this run
  std::uint64_t left = 0;   ///< when it began, 2^64 - 1 for more
  std::uint64_t cases = 0;
  std::uint64_t failed = 0;
};

/// What came of a run.
struct Ran {
  Advance advance;
  bool complete = false;  ///< no unit of the plan is missing now
  double seconds = 0;
};

/// Runs the units of the plan that the database does not hold, in any order, and stores them in transactions of a fifth
/// of a second's work: what one of them has stored stays, and nothing is stored twice. `advanced` is called after each.
/// `ranks` are the processes that follow, or null. Throws FileError where storing fails, and Error for a unit that
/// cannot be run or that came out otherwise before; what was finished until then is stored.
Ran run_campaign(Store& store, const Plan& plan, const RunInfo& run, const Work& work,
                 const std::function<void(const Advance&)>& advanced, Ranks* ranks);

/// Runs units for rank 0 until there are no more. Throws Error.
void follow(Ranks& ranks, const Plan& plan, const std::string& build, unsigned jobs);

}  // namespace torse::fuzz
