// Where a case comes from: a sequence of bounded choices, each smaller number standing for something simpler.
//   Choices        draws numbers from a seed, from a recorded list or from bytes, and records what it drew
//   Record         the recorded list: the same list gives the same case on every machine and compiler
//   trimmed        the shortest list for the same case
//   simpler        the order in which cases are shrunk
//   Edit, edits    the ways to make a list simpler, the boldest first
//   edited         the list that an edit makes: it stands for a valid case, as every list does
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <vector>

#include "torse/proofs/random.hpp"

namespace torse::fuzz {

/// What was drawn, in order.
using Record = std::vector<std::uint64_t>;

/// A source of choices. Everything that fuzzing makes is a function of what `below` returns, and 0 is its simplest
/// answer, so that any list of numbers stands for a valid case and a smaller one for a simpler case.
class Choices {
 public:
  /// Random choices, the same for a seed everywhere.
  static Choices from_seed(std::uint64_t seed);
  /// The choices of a list, then zeros. A number that is too large counts as the largest allowed one.
  static Choices from_record(Record record);
  /// The choices that bytes stand for, as many bytes each as its bound needs, then zeros: for coverage-guided fuzzing.
  static Choices from_bytes(std::span<const std::uint8_t> bytes);

  /// A number in [0, bound), bound > 0.
  std::uint64_t below(std::uint64_t bound);
  /// A number in [lo, hi]; lo is the simplest.
  int between(int lo, int hi) { return lo + static_cast<int>(below(static_cast<std::uint64_t>(hi - lo) + 1)); }
  /// True once in `times`; false is the simplest.
  bool once_in(std::uint64_t times) { return below(times) == times - 1; }
  /// One of a list; the first is the simplest.
  template <class T>
  T pick(std::initializer_list<T> list) {
    return list.begin()[below(list.size())];
  }

  /// Everything drawn so far.
  const Record& record() const { return record_; }

 private:
  Choices() = default;

  std::optional<proofs::Bounded<proofs::SplitMix>> random_;
  Record given_;
  std::size_t used_ = 0;
  std::span<const std::uint8_t> bytes_;
  Record record_;
};

/// The record without its zeros at the end, which stand for the same case.
Record trimmed(Record record);

/// Whether trimmed record a is shorter than b, or as long and smaller where they first differ.
bool simpler(const Record& a, const Record& b);

/// One way to make a list simpler: the `count` numbers from `from` on are left out, or become `value`.
struct Edit {
  std::size_t from = 0;
  std::size_t count = 1;
  std::optional<std::uint64_t> value;
};

/// Shorter lists first, then smaller numbers; none for an empty list.
std::vector<Edit> edits(const Record& record);

Record edited(const Record& record, const Edit& edit);

}  // namespace torse::fuzz
