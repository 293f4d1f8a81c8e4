#include "torse/fuzz/campaign/compare.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <optional>

#include "torse/io/document.hpp"

namespace torse::fuzz {
namespace {

/// How many units an error names.
constexpr std::size_t named = 10;

void merge_one(Store& into, Store& from, Merged& merged, std::vector<std::string>& contradictions) {
  std::map<std::int64_t, std::int64_t> numbers;
  for (const auto& [number, run] : from.runs()) numbers[number] = into.put_run(run);
  for (const Series& series : from.series()) {
    Units units(from, series, all_seeds);
    while (const auto unit = units.next()) {
      switch (into.put(unit->result, numbers[unit->run])) {
        case Put::added:
          ++merged.added;
          break;
        case Put::known:
          ++merged.known;
          break;
        case Put::contradiction:
          contradictions.push_back(unit_name(series, unit->result.seed));
      }
      if (contradictions.size() == named) return;
    }
  }
}

void take_apart(Difference& difference, const Tally& a, const Tally& b, std::uint64_t seed) {
  if (a == b) {
    ++difference.same;
    return;
  }
  const bool holds_in_a = a.failed == 0;
  const bool holds_in_b = b.failed == 0;
  (holds_in_a == holds_in_b ? difference.changed : holds_in_a ? difference.broken : difference.fixed).add(seed);
  difference.a.add(a);
  difference.b.add(b);
}

Difference compare_series(Store& a, Store& b, const Series& series) {
  Difference difference;
  difference.series = series;
  Units units_a(a, series, all_seeds);
  Units units_b(b, series, all_seeds);
  std::optional<StoredUnit> in_a = units_a.next();
  std::optional<StoredUnit> in_b = units_b.next();
  while (in_a || in_b) {
    if (!in_b || (in_a && in_a->result.seed < in_b->result.seed)) {
      difference.only_in_a.add(in_a->result.seed);
      in_a = units_a.next();
    } else if (!in_a || in_b->result.seed < in_a->result.seed) {
      difference.only_in_b.add(in_b->result.seed);
      in_b = units_b.next();
    } else {
      take_apart(difference, in_a->result.tally, in_b->result.tally, in_a->result.seed);
      in_a = units_a.next();
      in_b = units_b.next();
    }
  }
  return difference;
}

}  // namespace

Merged merge(Store& into, const std::vector<std::string>& from) {
  Merged merged;
  Transaction transaction(into.database());
  for (const std::string& file : from) {
    std::error_code ignored;
    if (std::filesystem::equivalent(into.file(), file, ignored)) {
      throw FileError(file, "expected another database than the one to merge into");
    }
    Store source(file, Database::Open::existing);
    std::vector<std::string> contradictions;
    merge_one(into, source, merged, contradictions);
    if (contradictions.empty()) continue;
    std::string list;
    for (const std::string& name : contradictions) list += (list.empty() ? "" : "; ") + name;
    throw FileError(file, "contradicts what was merged before: " + list +
                              (contradictions.size() == named ? "; there may be more" : ""));
  }
  transaction.commit();
  return merged;
}

std::vector<Difference> compare(Store& a, Store& b) {
  const std::vector<Series> in_a = a.series();
  const std::vector<Series> in_b = b.series();
  std::vector<Series> all;
  std::set_union(in_a.begin(), in_a.end(), in_b.begin(), in_b.end(), std::back_inserter(all));
  std::vector<Difference> list;
  list.reserve(all.size());
  for (const Series& series : all) list.push_back(compare_series(a, b, series));
  return list;
}

}  // namespace torse::fuzz
