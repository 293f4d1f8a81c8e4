// What a campaign is to run.
//   Series, Shard, Plan             properties, effort, seeds, and which part of them
//   UnitResult                      what a unit of work came to; a unit is a property and a seed
//   shard_of_environment            the part that GoogleTest's variables name
#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <vector>

#include "torse/fuzz/campaign/seeds.hpp"
#include "torse/fuzz/run.hpp"

namespace torse::fuzz {

/// The units of a property at an effort: one for each seed.
struct Series {
  std::string property;
  std::string effort;

  friend auto operator<=>(const Series&, const Series&) = default;  // NOLINT(modernize-use-nullptr): Clang 14 errs
};

/// One of `total` parts, from 0.
struct Shard {
  std::uint64_t index = 0;
  std::uint64_t total = 1;
};

/// Every property with every seed, as far as they are in the shard: those where seed + number of the property is the
/// shard's index modulo `total`.
struct Plan {
  std::vector<const Property*> properties;
  proofs::Effort effort = proofs::Effort::standard;
  Seeds seeds;
  Shard shard;

  Series series(std::size_t property) const;
  /// The place of a property of the plan.
  std::size_t place(const Series& series) const;
  /// The properties, their batches and the effort, in words: what two processes must agree on.
  std::string text() const;
};

/// What a unit came to: fuzz::run_seed of its property, effort and seed, and the processor time that this took.
struct UnitResult {
  Series series;
  std::uint64_t seed = 0;
  Tally tally;
  std::int64_t microseconds = 0;
};

/// "text.number, seed 5, standard effort".
std::string unit_name(const Series& series, std::uint64_t seed);

/// The part that GTEST_TOTAL_SHARDS and GTEST_SHARD_INDEX name, all where neither is set; touches the file that
/// GTEST_SHARD_STATUS_FILE names. Throws Error for values that make no sense.
Shard shard_of_environment();

}  // namespace torse::fuzz
