// The leader's loop and that of the others.
#include "torse/fuzz/campaign/campaign.hpp"

#include <exception>
#include <iterator>
#include <thread>
#include <utility>
#include <vector>

#include "torse/fuzz/campaign/crew.hpp"
#include "torse/fuzz/campaign/workers.hpp"
#include "torse/io/document.hpp"

namespace torse::fuzz {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

/// The work between two transactions: what a process that is killed may lose.
constexpr milliseconds between_commits(200);
/// Between two looks for results, and for messages, which do not wake a thread.
constexpr milliseconds pause(5);
constexpr milliseconds pause_with_messages(1);

std::vector<SeedSet> settled_seeds(Store& store, const Plan& plan, const std::string& build) {
  std::vector<SeedSet> list;
  for (std::size_t i = 0; i < plan.properties.size(); ++i) {
    list.push_back(store.settled(plan.series(i), plan.seeds, build));
  }
  return list;
}

void append(std::vector<UnitResult>& list, std::vector<UnitResult> more) {
  list.insert(list.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

/// Rank 0, or a process alone.
class Leader {
 public:
  Leader(Store& store, const Plan& plan, const RunInfo& run, const Work& work, Ranks* ranks)
      : store_(store),
        plan_(plan),
        run_(run),
        work_(work),
        messages_(ranks != nullptr),
        start_(Clock::now()),
        schedule_(plan, settled_seeds(store, plan, run.build)),
        crew_(ranks, plan, run.build),
        workers_(plan, work.jobs) {
    advance_.left = schedule_.left();
  }

  Ran lead(const std::function<void(const Advance&)>& advanced) {
    Clock::time_point committed = start_;
    for (bool done = false; !done;) {
      collect();
      done = workers_done_ && crew_.at_work() == 0;
      if (!done && Clock::now() - committed < between_commits) continue;
      commit();
      committed = Clock::now();
      if (advanced) advanced(advance_);
      if (!done) look_for_overdue();
    }
    if (defect_) std::rethrow_exception(defect_);
    return {advance_, schedule_.empty() && !dropped_, seconds()};
  }

 private:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

  /// Results of threads and processes, and new work for them. The first error ends the handing out.
  void collect() {
    const bool stop = defect_ != nullptr || (work_.time && Clock::now() - start_ >= *work_.time);
    const std::size_t known = results_.size();
    try {
      if (stop) {
        dropped_ = workers_.drop() || dropped_;
      } else {
        workers_.give(schedule_.take(workers_.wanted()));
      }
      workers_done_ = defect_ != nullptr || workers_.idle();
      if (!workers_done_) append(results_, workers_.take(messages_ ? pause_with_messages : pause));
      crew_.serve(schedule_, stop, results_);
    } catch (const Error&) {
      if (!defect_) defect_ = std::current_exception();
    }
    for (std::size_t i = known; i < results_.size(); ++i) {
      schedule_.spent(plan_.place(results_[i].series), results_[i].microseconds);
    }
    std::this_thread::sleep_for(messages_ ? pause_with_messages : pause);
  }

  /// What does not end is a finding, too.
  void look_for_overdue() {
    if (!work_.time || !work_.overdue || Clock::now() - start_ < *work_.time + work_.grace) return;
    std::string names;
    for (const Unit& unit : workers_.at_work()) {
      names += (names.empty() ? "" : "; ") + unit_name(plan_.series(unit.property), unit.seed);
    }
    std::exchange(work_.overdue, {})(names.empty() ? "another process" : names);
  }

  void commit() {
    if (results_.empty()) return;
    run_.seconds = seconds();
    Transaction transaction(store_.database());
    const std::int64_t number = store_.put_run(run_);
    Advance next = advance_;
    for (const UnitResult& result : results_) {
      const Put put = store_.put_anew(result, number);
      if (put == Put::contradiction) {
        const bool same = store_.build_of(result.series, result.seed) == run_.build;
        throw FileError(
            store_.file(),
            unit_name(result.series, result.seed) +
                (same ? " has come out otherwise before: its property depends on more than the seed"
                      : " has come out otherwise under another build of torse meanwhile: give each its own database"));
      }
      next.units += put == Put::added ? 1 : 0;
      next.cases += result.tally.cases;
      next.failed += result.tally.failed;
    }
    transaction.commit();
    advance_ = next;
    results_.clear();
  }

  Store& store_;
  const Plan& plan_;
  RunInfo run_;
  Work work_;
  bool messages_;
  Clock::time_point start_;
  Schedule schedule_;
  Advance advance_;
  Crew crew_;
  Workers workers_;
  bool workers_done_ = false;
  bool dropped_ = false;
  std::vector<UnitResult> results_;
  std::exception_ptr defect_;
};

}  // namespace

Ran run_campaign(Store& store, const Plan& plan, const RunInfo& run, const Work& work,
                 const std::function<void(const Advance&)>& advanced, Ranks* ranks) {
  return Leader(store, plan, run, work, ranks).lead(advanced);
}

void follow(Ranks& ranks, const Plan& plan, const std::string& build, unsigned jobs) {
  Workers workers(plan, jobs);
  Report report;
  report.plan = plan_number(plan, build);
  bool asked = false;
  bool more = true;
  std::string bytes;
  while (!report.last) {
    try {
      if (asked && ranks.receive(bytes) >= 0) {
        asked = false;
        const std::vector<Unit> units = orders_from(bytes, plan);
        more = !units.empty();
        workers.give(units);
      }
      if (report.error.empty()) append(report.results, workers.take(pause_with_messages));
    } catch (const std::exception& error) {
      report.error = error.what();
    }
    if (asked) continue;
    report.wanted = more ? workers.wanted() : 0;
    report.last = !report.error.empty() || (!more && workers.idle());
    if (!report.last && report.wanted == 0) continue;
    ranks.send(0, to_bytes(report, plan));
    report.results.clear();
    asked = true;
  }
  ranks.finish();
}

}  // namespace torse::fuzz
