// Which units are still to be run, in turns: each property's next missing seed, so that all get on alike.
//   Unit          a property of the plan and a seed            Schedule     hands them out
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "torse/fuzz/campaign/store.hpp"

namespace torse::fuzz {

/// A unit of work.
struct Unit {
  std::size_t property = 0;  ///< its place in the plan
  std::uint64_t seed = 0;

  friend bool operator==(const Unit&, const Unit&) = default;
};

/// The units of a plan that are not settled, each handed out once.
class Schedule {
 public:
  /// `settled` has the seeds of each property that need not be run.
  Schedule(const Plan& plan, const std::vector<SeedSet>& settled);

  /// Up to `count` units; fewer only if none are left.
  std::vector<Unit> take(std::size_t count);
  bool empty() const { return open_ == 0; }
  /// How many are left, or 2^64 - 1 if there are more.
  std::uint64_t left() const;

 private:
  /// Seeds from first to last by steps of the number of shards.
  struct Run {
    std::uint64_t first = 0;
    std::uint64_t count = 0;
  };
  std::uint64_t step_;
  std::vector<std::vector<Run>> missing_;  ///< of each property, the nearest seeds at the back
  std::size_t open_ = 0;                   ///< the properties with missing seeds
  std::size_t turn_ = 0;
};

}  // namespace torse::fuzz
