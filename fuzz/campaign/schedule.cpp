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
    : step_(plan.shard.total), shares_(plan.properties.size()) {
  for (std::size_t p = 0; p < plan.properties.size(); ++p) {
    std::vector<Run>& missing = shares_[p].missing;
    const auto add = [&](std::uint64_t from, std::uint64_t to) {
      const std::uint64_t first = first_of(plan.shard, p, from);
      if (first > to) return;
      missing.push_back({first, (to - first) / step_ + 1});
    };
    std::uint64_t next = plan.seeds.first;
    for (const auto& [from, to] : settled[p].intervals()) {
      if (from > next) add(next, from - 1);
      next = to + 1;
    }
    if (next <= plan.seeds.last) add(next, plan.seeds.last);
    std::reverse(missing.begin(), missing.end());
    if (!missing.empty()) ++open_;
  }
}

double Schedule::Share::time() const {
  constexpr double unknown = 1e6;
  return microseconds + (given - ended) * (ended > 0 ? microseconds / ended : unknown);
}

std::vector<Unit> Schedule::take(std::size_t count) {
  std::vector<Unit> units;
  while (units.size() < count && !empty()) {
    Share* next = nullptr;
    for (Share& share : shares_) {
      if (!share.missing.empty() && (next == nullptr || share.time() < next->time())) next = &share;
    }
    Run& run = next->missing.back();
    units.push_back({static_cast<std::size_t>(next - shares_.data()), run.first});
    ++next->given;
    run.first += step_;
    if (--run.count == 0) next->missing.pop_back();
    if (next->missing.empty()) --open_;
  }
  return units;
}

void Schedule::spent(std::size_t property, std::int64_t microseconds) {
  shares_[property].microseconds += static_cast<double>(microseconds);
  ++shares_[property].ended;
}

std::uint64_t Schedule::left() const {
  constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t sum = 0;
  for (const Share& share : shares_) {
    for (const Run& run : share.missing) sum = run.count > most - sum ? most : sum + run.count;
  }
  return sum;
}

}  // namespace torse::fuzz
