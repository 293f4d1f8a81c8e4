#include "torse/fuzz/choices.hpp"

#include <algorithm>
#include <utility>

namespace torse::fuzz {

Choices Choices::from_seed(std::uint64_t seed) {
  Choices choices;
  choices.random_.emplace(seed);
  return choices;
}

Choices Choices::from_record(Record record) {
  Choices choices;
  choices.given_ = std::move(record);
  return choices;
}

Choices Choices::from_bytes(std::span<const std::uint8_t> bytes) {
  Choices choices;
  choices.bytes_ = bytes;
  return choices;
}

std::uint64_t Choices::below(std::uint64_t bound) {
  if (bound == 1) return 0;
  std::uint64_t drawn = 0;
  if (random_) {
    drawn = random_->below(bound);
  } else if (!bytes_.empty()) {
    for (std::uint64_t left = bound - 1; left > 0 && !bytes_.empty(); left >>= 8U) {
      drawn = drawn << 8U | bytes_.front();
      bytes_ = bytes_.subspan(1);
    }
    drawn %= bound;
  } else if (used_ < given_.size()) {
    drawn = std::min(given_[used_++], bound - 1);
  }
  record_.push_back(drawn);
  return drawn;
}

namespace {

/// Runs of choices up to this length, those that one number or point is drawn from, are tried at every place.
constexpr std::size_t longest_run = 12;

void add_edits(std::vector<Edit>& list, const Record& record, std::size_t chunk, std::size_t stride) {
  for (std::size_t from = 0; from + chunk <= record.size(); from += stride) {
    list.push_back({from, chunk, std::nullopt});
    const auto begin = record.begin() + static_cast<std::ptrdiff_t>(from);
    const bool zero = std::all_of(begin, begin + static_cast<std::ptrdiff_t>(chunk), [](auto x) { return x == 0; });
    if (!zero) list.push_back({from, chunk, 0});
  }
}

}  // namespace

Record trimmed(Record record) {
  while (!record.empty() && record.back() == 0) record.pop_back();
  return record;
}

bool simpler(const Record& a, const Record& b) { return a.size() < b.size() || (a.size() == b.size() && a < b); }

std::vector<Edit> edits(const Record& record) {
  std::vector<Edit> list;
  std::size_t chunk = 1;
  while (2 * chunk <= record.size()) chunk *= 2;
  for (; chunk > longest_run; chunk /= 2) add_edits(list, record, chunk, chunk);
  for (chunk = std::min(longest_run, record.size()); chunk > 0; --chunk) add_edits(list, record, chunk, 1);
  for (std::size_t i = 0; i < record.size(); ++i) {
    if (record[i] > 2) list.push_back({i, 1, record[i] / 2});
    if (record[i] > 1) list.push_back({i, 1, record[i] - 1});
  }
  return list;
}

Record edited(const Record& record, const Edit& edit) {
  const auto begin = record.begin() + static_cast<std::ptrdiff_t>(edit.from);
  Record next(record.begin(), begin);
  if (edit.value) next.resize(edit.from + edit.count, *edit.value);
  next.insert(next.end(), begin + static_cast<std::ptrdiff_t>(edit.count), record.end());
  return next;
}

}  // namespace torse::fuzz
