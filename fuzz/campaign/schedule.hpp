// Which units are still to be run. Every property gets the same share of the time.
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

  /// Up to `count` units, fewer only if none are left: each is the next missing seed of the property that has taken the
  /// least time, by what its units have taken so far.
  std::vector<Unit> take(std::size_t count);
  /// Says what a unit of a property has taken.
  void spent(std::size_t property, std::int64_t microseconds);
  bool empty() const { return open_ == 0; }
  /// How many are left, or 2^64 - 1 if there are more.
  std::uint64_t left() const;

 private:
  /// Seeds from first to last by steps of the number of shards.
  struct Run {
    std::uint64_t first = 0;
    std::uint64_t count = 0;
  };
  struct Share {
    std::vector<Run> missing;  ///< the nearest seeds at the back
    double microseconds = 0;
    double given = 0;
    double ended = 0;

    /// The time of the units that were given, the running ones at the mean of those that have ended.
    double time() const;
  };
  std::uint64_t step_;
  std::vector<Share> shares_;  ///< of each property
  std::size_t open_ = 0;       ///< the properties with missing seeds
};

}  // namespace torse::fuzz
