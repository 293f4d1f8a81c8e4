// Databases side by side.
//   merge            the units of several in one              Merged       how many
//   compare          what two differ in                       Difference   the same for one series
#pragma once

#include <cstdint>
#include <vector>

#include "torse/fuzz/campaign/store.hpp"

namespace torse::fuzz {

/// The units of a merge: new in the result, or there already.
struct Merged {
  std::uint64_t added = 0;
  std::uint64_t known = 0;
};

/// Puts all units of `from` into a store, in one transaction. Throws FileError, naming units, where two databases
/// contradict each other; then nothing is stored.
Merged merge(Store& into, const std::vector<std::string>& from);

/// How the units of a series in B differ from those in A, by everything but the time they took.
struct Difference {
  Series series;
  std::uint64_t same = 0;
  SeedSet only_in_a;
  SeedSet only_in_b;
  SeedSet broken;   ///< hold in A, fail in B
  SeedSet fixed;    ///< fail in A, hold in B
  SeedSet changed;  ///< the same verdict, but other cases
  Tally a;          ///< the sums of the broken, fixed and changed ones
  Tally b;

  bool verdicts_differ() const { return !broken.empty() || !fixed.empty(); }
  bool equal() const { return !verdicts_differ() && only_in_a.empty() && only_in_b.empty() && changed.empty(); }
};

/// For every series of A or B.
std::vector<Difference> compare(Store& a, Store& b);

}  // namespace torse::fuzz
