#include "torse/fuzz/campaign/workers.hpp"

#include <algorithm>
#include <ctime>
#include <utility>

#include "torse/exact/symbolic/thread_cache.hpp"
#include "torse/fuzz/campaign/crash.hpp"
#include "torse/scalar/errors.hpp"

namespace torse::fuzz {
namespace {

using Clock = std::chrono::steady_clock;

/// Work for so long is queued for a thread.
constexpr std::chrono::milliseconds ahead(50);
/// The most units that are queued for a thread.
constexpr std::size_t most_ahead = 4096;

/// The processor time of this thread.
std::int64_t thread_microseconds() {
  std::timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::int64_t{time.tv_sec} * 1000000 + time.tv_nsec / 1000;
}

UnitResult run_unit(const Plan& plan, const Unit& unit) {
  UnitResult result{plan.series(unit.property), unit.seed, {}, 0};
  const UnitAtWork named(unit_name(result.series, unit.seed));
  const std::int64_t start = thread_microseconds();
  try {
    result.tally = run_seed(*plan.properties[unit.property], plan.effort, unit.seed);
  } catch (const std::exception& error) {
    throw Error(unit_name(result.series, unit.seed) + ": " + error.what());
  }
  result.microseconds = thread_microseconds() - start;
  return result;
}

}  // namespace

Workers::Workers(const Plan& plan, unsigned jobs) : plan_(plan), jobs_(std::max(1U, jobs)) {
  for (std::size_t i = 0; i < jobs_; ++i) {
    threads_.emplace_back([this] {
      const SignalStack stack;
      work();
      release_flint_cache();
    });
  }
}

Workers::~Workers() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  more_work_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

std::size_t Workers::wanted() {
  const std::lock_guard lock(mutex_);
  std::size_t each = 1;
  if (finished_ > 0) {
    const auto per_unit = std::max<Clock::duration>(spent_ / finished_, std::chrono::microseconds(1));
    each = std::clamp<std::size_t>(static_cast<std::size_t>(Clock::duration(ahead) / per_unit), 1, most_ahead);
  }
  return jobs_ * each > queue_.size() ? jobs_ * each - queue_.size() : 0;
}

void Workers::give(const std::vector<Unit>& units) {
  if (units.empty()) return;
  {
    const std::lock_guard lock(mutex_);
    queue_.insert(queue_.end(), units.begin(), units.end());
  }
  more_work_.notify_all();
}

bool Workers::drop() {
  const std::lock_guard lock(mutex_);
  const bool any = !queue_.empty();
  queue_.clear();
  return any;
}

std::vector<UnitResult> Workers::take(std::chrono::milliseconds wait) {
  std::unique_lock lock(mutex_);
  more_results_.wait_for(lock, wait, [this] { return !results_.empty() || defect_; });
  if (results_.empty() && defect_) std::rethrow_exception(defect_);
  return std::exchange(results_, {});
}

bool Workers::idle() {
  const std::lock_guard lock(mutex_);
  return queue_.empty() && at_work_.empty() && results_.empty() && !defect_;
}

std::vector<Unit> Workers::at_work() {
  const std::lock_guard lock(mutex_);
  return {at_work_.begin(), at_work_.end()};
}

void Workers::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    more_work_.wait(lock, [this] { return stop_ || !queue_.empty(); });
    if (stop_) return;
    const Unit unit = queue_.front();
    queue_.pop_front();
    const auto place = at_work_.insert(at_work_.end(), unit);
    lock.unlock();
    UnitResult result;
    std::exception_ptr defect;
    const auto start = Clock::now();
    try {
      result = run_unit(plan_, unit);
    } catch (...) {
      defect = std::current_exception();
    }
    lock.lock();
    at_work_.erase(place);
    spent_ += Clock::now() - start;
    ++finished_;
    if (defect) {
      defect_ = defect;
      stop_ = true;
      more_work_.notify_all();
    } else {
      results_.push_back(std::move(result));
    }
    more_results_.notify_one();
  }
}

}  // namespace torse::fuzz
