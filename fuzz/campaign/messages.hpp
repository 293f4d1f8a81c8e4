// What the processes of a campaign tell each other, as bytes. Each answers: a Report is answered by Orders, the last
// Report of a process by nothing.
//   Report      of a process to the leader           Orders      units for it
//   plan_number, to_bytes, report_plan, report_from, orders_from
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "torse/fuzz/campaign/schedule.hpp"

namespace torse::fuzz {

/// What a process has done and how much it wants to be given.
struct Report {
  std::uint64_t plan = 0;  ///< plan_number of its plan and program
  std::uint64_t wanted = 0;
  bool last = false;  ///< nothing is left there, and no answer is expected
  std::string error;  ///< why it gives up; then it is the last one
  std::vector<UnitResult> results;
};

/// A number that differs, but for chance, where the plans or the programs do.
std::uint64_t plan_number(const Plan& plan, const std::string& build);

/// The results are of properties of the plan.
std::string to_bytes(const Report& report, const Plan& plan);
/// `units` empty: nothing is left to hand out.
std::string to_bytes(const std::vector<Unit>& units);
/// The number of the plan that a report begins with. These throw Error for bytes that were not written by to_bytes.
std::uint64_t report_plan(const std::string& bytes);
/// The results' properties are those of the plan.
Report report_from(const std::string& bytes, const Plan& plan);
std::vector<Unit> orders_from(const std::string& bytes, const Plan& plan);

}  // namespace torse::fuzz
