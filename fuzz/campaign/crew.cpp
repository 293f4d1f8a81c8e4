#include "torse/fuzz/campaign/crew.hpp"

#include <chrono>
#include <iterator>
#include <thread>
#include <utility>

#include "torse/scalar/errors.hpp"

namespace torse::fuzz {

Crew::Crew(Ranks* ranks, const Plan& plan, const std::string& build)
    : ranks_(ranks),
      plan_(plan),
      plan_number_(plan_number(plan, build)),
      at_work_(ranks == nullptr ? 0 : ranks->size() - 1) {}

Crew::~Crew() {
  if (ranks_ == nullptr) return;
  Schedule none(plan_, std::vector<SeedSet>(plan_.properties.size(), SeedSet(all_seeds)));
  std::vector<UnitResult> dropped;
  while (at_work() > 0) {
    try {
      serve(none, true, dropped);
    } catch (const Error&) {
      // The error that has led here is the one to be told.
    }
    dropped.clear();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  if (understood_) ranks_->finish();
}

void Crew::serve(Schedule& schedule, bool stop, std::vector<UnitResult>& results) {
  if (ranks_ == nullptr) return;
  std::string bytes;
  for (int from = ranks_->receive(bytes); from >= 0; from = ranks_->receive(bytes)) {
    Report report = understand(from, bytes);
    if (report.last) {
      --at_work_;
    } else {
      ranks_->send(from, to_bytes(stop ? std::vector<Unit>() : schedule.take(report.wanted)));
    }
    results.insert(results.end(), std::make_move_iterator(report.results.begin()),
                   std::make_move_iterator(report.results.end()));
    if (!report.error.empty()) throw Error("process " + std::to_string(from) + ": " + report.error);
  }
}

Report Crew::understand(int from, const std::string& bytes) {
  understood_ = false;
  if (report_plan(bytes) != plan_number_) {
    throw Error("process " + std::to_string(from) + " is another build of torse or has another command line");
  }
  Report report = report_from(bytes, plan_);
  understood_ = true;
  return report;
}

}  // namespace torse::fuzz
