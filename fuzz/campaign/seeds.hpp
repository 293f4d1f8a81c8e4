// Seeds.
//   Seeds        a range of seeds, as on the command line          SeedSet      any seeds, as intervals
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace torse::fuzz {

/// The seeds from `first` to `last`.
struct Seeds {
  /// SQLite's integers end there; a range up to it is one without an end.
  static constexpr std::uint64_t most = std::numeric_limits<std::int64_t>::max();

  std::uint64_t first = 1;
  std::uint64_t last = most;

  bool endless() const { return last == most; }
  /// "1..100", "7" or "1.." for a range without an end.
  std::string text() const;
  /// Throws Error for a text that is none of these.
  static Seeds from_text(const std::string& text);

  friend bool operator==(const Seeds&, const Seeds&) = default;
};

/// Every seed.
inline constexpr Seeds all_seeds{0, Seeds::most};

/// A set of seeds that was filled in ascending order.
class SeedSet {
 public:
  SeedSet() = default;
  explicit SeedSet(const Seeds& seeds) : intervals_{seeds} {}

  /// Adds a seed that is greater than all others.
  void add(std::uint64_t seed);
  bool empty() const { return intervals_.empty(); }
  std::uint64_t count() const;
  /// Disjoint and ascending, none next to another.
  const std::vector<Seeds>& intervals() const { return intervals_; }
  /// "1..5, 7", with "..." for the intervals beyond the first ten.
  std::string text() const;

  friend bool operator==(const SeedSet&, const SeedSet&) = default;

 private:
  std::vector<Seeds> intervals_;
};

}  // namespace torse::fuzz
