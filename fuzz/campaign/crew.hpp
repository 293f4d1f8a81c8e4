// The leader's side of the other processes.
//   Crew      hands units to them and takes their results
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "torse/fuzz/campaign/messages.hpp"
#include "torse/fuzz/campaign/ranks.hpp"

namespace torse::fuzz {

/// The processes that rank 0 leads: none where `ranks` is null.
class Crew {
 public:
  Crew(Ranks* ranks, const Plan& plan, const std::string& build);
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;
  /// Tells those who still work to stop, waits for them and drops what they bring. Where one of them has not been
  /// understood, all end with this process instead.
  ~Crew();

  /// Takes all messages that have come and answers them with units of the schedule, or with none if `stop`. Throws
  /// Error for a process that gives up or that follows another plan.
  void serve(Schedule& schedule, bool stop, std::vector<UnitResult>& results);
  /// How many processes still work; 0 once one of them has not been understood.
  int at_work() const { return understood_ ? at_work_ : 0; }

 private:
  Report understand(int from, const std::string& bytes);

  Ranks* ranks_;
  const Plan& plan_;
  std::uint64_t plan_number_;
  int at_work_;
  bool understood_ = true;
};

}  // namespace torse::fuzz
