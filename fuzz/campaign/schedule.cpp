#include "torse/fuzz/campaign/schedule.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace torse::fuzz {
namespace {

/// The least seed from `from` on that a shard has of a property.
std::uint64_t first_of(const Shard& shard, std::size_t property, std::uint64_t from) {
  const std::uint64_t place = (from % shard.total + property % shard.total) % shard.total;
  return from + (shard.index + shard.total - place) % shard.total;
}

}  // namespace

Schedule::Schedule(const Plan& plan, const std::vector<SeedSet>& settled)
    : step_(plan.shard.total), missing_(plan.properties.size()) {
  for (std::size_t p = 0; p < plan.properties.size(); ++p) {
    const auto add = [&](std::uint64_t from, std::uint64_t to) {
      const std::uint64_t first = first_of(plan.shard, p, from);
      if (first > to) return;
      missing_[p].push_back({first, (to - first) / step_ + 1});
    };
    std::uint64_t next = plan.seeds.first;
    for (const auto& [from, to] : settled[p].intervals()) {
      if (from > next) add(next, from - 1);
      next = to + 1;
    }
    if (next <= plan.seeds.last) add(next, plan.seeds.last);
    std::reverse(missing_[p].begin(), missing_[p].end());
    if (!missing_[p].empty()) ++open_;
  }
}

std::vector<Unit> Schedule::take(std::size_t count) {
  std::vector<Unit> units;
  while (units.size() < count && !empty()) {
    const std::size_t property = turn_++ % missing_.size();
    std::vector<Run>& runs = missing_[property];
    if (runs.empty()) continue;
    Run& run = runs.back();
    units.push_back({property, run.first});
    run.first += step_;
    if (--run.count == 0) runs.pop_back();
    if (runs.empty()) --open_;
  }
  return units;
}

std::uint64_t Schedule::left() const {
  constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t sum = 0;
  for (const std::vector<Run>& runs : missing_) {
    for (const Run& run : runs) sum = run.count > most - sum ? most : sum + run.count;
  }
  return sum;
}

}  // namespace torse::fuzz
