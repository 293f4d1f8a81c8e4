// Threads that run units.
//   Workers     a queue of units, the threads, and what has come out
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <list>
#include <mutex>
#include <thread>
#include <vector>

#include "torse/fuzz/campaign/schedule.hpp"

namespace torse::fuzz {

/// Threads that run the units of a plan, which must outlive them.
class Workers {
 public:
  Workers(const Plan& plan, unsigned jobs);
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  /// Drops what is queued and waits for the units at work.
  ~Workers();

  /// How many units more make a twentieth of a second of work for every thread, at least one for each.
  std::size_t wanted();
  void give(const std::vector<Unit>& units);
  /// Forgets the units that have not begun; whether there were any.
  bool drop();
  /// What has come out since the last call; waits for the first one so long. Throws Error for a unit that could not be
  /// run.
  std::vector<UnitResult> take(std::chrono::milliseconds wait);
  /// Whether all that was given has been taken.
  bool idle();
  /// The units that have begun and not ended.
  std::vector<Unit> at_work();

 private:
  void work();

  const Plan& plan_;
  const std::size_t jobs_;
  std::mutex mutex_;
  std::condition_variable more_work_;
  std::condition_variable more_results_;
  std::deque<Unit> queue_;
  std::list<Unit> at_work_;
  std::vector<UnitResult> results_;
  std::exception_ptr defect_;
  std::chrono::steady_clock::duration spent_{};
  std::size_t finished_ = 0;
  bool stop_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace torse::fuzz
