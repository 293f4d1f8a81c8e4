// What the tests of campaigns share.
//   Digits        a property of decimal digits that 7 refutes          Hall      processes as threads, with mail boxes
//   run_of        a run of a build                                     unit_of   a made-up result
#pragma once

#include <deque>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "support/program.hpp"
#include "torse/fuzz/campaign/campaign.hpp"
#include "torse/fuzz/campaign/compare.hpp"
#include "torse/fuzz/property.hpp"

namespace torse::fuzz::test {

/// A number below 10^6 is drawn. False: "it is not below 20000"; a multiple of 10 is no case.
struct Digits {
  struct In {
    int x = 0;
    template <class Self, class Visitor>
    static void fields(Self& in, Visitor& visit) {
      visit("x", in.x);
    }
  };
  static const PropertyInfo& info() {
    static const PropertyInfo info{"test.digits", "false", 20, {}};
    return info;
  }
  static In draw(Choices& choices, const Scale&, Labels& labels) {
    const int x = choices.between(0, 999999);
    if (x % 10 == 0) throw Discard("a multiple of 10");
    labels.add("last", x % 10);
    return {x};
  }
  static void check(const In& in, Labels&) { require(in.x >= 20000, "too small"); }
};

/// The same numbers without a failure.
struct Numbers : Digits {
  static const PropertyInfo& info() {
    static const PropertyInfo info{"test.numbers", "true", 30, {}};
    return info;
  }
  static void check(const In& in, Labels&) { require(in.x % 10 != 0, "a multiple of 10"); }
};

inline Plan plan_of(Seeds seeds) {
  return {{&property<Digits>(), &property<Numbers>()}, proofs::Effort::quick, seeds, {}};
}

inline RunInfo run_of(const std::string& token, const std::string& build) {
  return {token, "2026-01-02T03:04:05Z", "1.2.3", build, "options", 0};
}

/// A result with so many failing cases of ten.
inline UnitResult unit_of(const std::string& name, std::uint64_t seed, std::uint64_t failed) {
  UnitResult result{{name, "quick"}, seed, {}, 1000};
  result.tally.cases = 10;
  result.tally.failed = failed;
  result.tally.discarded = 1;
  result.tally.labels.add("key", "value", 9);
  result.tally.discards.add("reason", "none", 1);
  if (failed > 0) result.tally.failures.push_back({seed, 3, "message", "{\"torse\": 1}\n"});
  return result;
}

/// Puts units into a database by one run.
inline void put_all(Store& store, const RunInfo& run, const std::vector<UnitResult>& results) {
  Transaction transaction(store.database());
  const std::int64_t number = store.put_run(run);
  for (const UnitResult& result : results) store.put(result, number);
  transaction.commit();
}

/// Whether two databases hold the same.
inline bool equal(Store& a, Store& b) {
  for (const Difference& difference : compare(a, b)) {
    if (!difference.equal()) return false;
  }
  return true;
}

/// Processes that are threads: messages lie in boxes until they are received.
class Hall {
 public:
  explicit Hall(int size) : boxes_(static_cast<std::size_t>(size)), finished_(boxes_.size(), false) {}

  class Seat final : public Ranks {
   public:
    Seat(Hall& hall, int rank) : hall_(hall), rank_(rank) {}
    int rank() const noexcept override { return rank_; }
    int size() const noexcept override { return static_cast<int>(hall_.boxes_.size()); }
    void send(int to, const std::string& bytes) noexcept override {
      const std::lock_guard lock(hall_.mutex_);
      hall_.boxes_[static_cast<std::size_t>(to)].emplace_back(rank_, bytes);
    }
    int receive(std::string& bytes) noexcept override {
      const std::lock_guard lock(hall_.mutex_);
      auto& box = hall_.boxes_[static_cast<std::size_t>(rank_)];
      if (box.empty()) return -1;
      const int from = box.front().first;
      bytes = box.front().second;
      box.pop_front();
      return from;
    }
    void finish() noexcept override {
      const std::lock_guard lock(hall_.mutex_);
      hall_.finished_[static_cast<std::size_t>(rank_)] = true;
    }

   private:
    Hall& hall_;
    int rank_;
  };

  Seat seat(int rank) { return {*this, rank}; }
  /// Whether everybody has finished and nobody has left a message unread.
  bool in_order() const {
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      if (!finished_[i] || !boxes_[i].empty()) return false;
    }
    return true;
  }

 private:
  std::mutex mutex_;
  std::vector<std::deque<std::pair<int, std::string>>> boxes_;
  std::vector<bool> finished_;
};

}  // namespace torse::fuzz::test
