// What a run has covered: how often each label was met.
//   Labels         of one case          Distribution      of a run: key -> value -> number of cases
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace torse::fuzz {

/// The labels of one case, such as ("class", "cone"). Keys are string literals.
class Labels {
 public:
  void add(std::string_view key, std::string value) { list_.emplace_back(key, std::move(value)); }
  void add(std::string_view key, int value) { add(key, std::to_string(value)); }

  const std::vector<std::pair<std::string_view, std::string>>& list() const { return list_; }

 private:
  std::vector<std::pair<std::string_view, std::string>> list_;
};

/// Counts of the cases that had a label.
class Distribution {
 public:
  using Counts = std::map<std::string, std::map<std::string, std::uint64_t>>;

  void add(const Labels& labels) {
    for (const auto& [key, value] : labels.list()) ++counts_[std::string(key)][value];
  }
  void add(const std::string& key, const std::string& value, std::uint64_t count) { counts_[key][value] += count; }
  void add(const Distribution& other) {
    for (const auto& [key, values] : other.counts_) {
      for (const auto& [value, count] : values) add(key, value, count);
    }
  }

  const Counts& counts() const { return counts_; }
  /// How many cases had this label.
  std::uint64_t count(const std::string& key, const std::string& value) const {
    const auto at = counts_.find(key);
    if (at == counts_.end()) return 0;
    const auto entry = at->second.find(value);
    return entry == at->second.end() ? 0 : entry->second;
  }

  /// How many labels with this key there were.
  std::uint64_t count(const std::string& key) const {
    const auto at = counts_.find(key);
    std::uint64_t sum = 0;
    if (at == counts_.end()) return sum;
    for (const auto& [value, count] : at->second) sum += count;
    return sum;
  }

  friend bool operator==(const Distribution&, const Distribution&) = default;

 private:
  Counts counts_;
};

}  // namespace torse::fuzz
