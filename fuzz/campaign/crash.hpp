// Which unit has ended the process.
//   UnitAtWork         the unit of this thread           report_crashes     lets a crash name it
#pragma once

#include <cstddef>
#include <memory>
#include <string>

namespace torse::fuzz {

/// Names what this thread works at, as long as it lives.
class UnitAtWork {
 public:
  explicit UnitAtWork(const std::string& name);
  UnitAtWork(const UnitAtWork&) = delete;
  UnitAtWork& operator=(const UnitAtWork&) = delete;
  ~UnitAtWork();
};

/// A stack for the signals of this thread, as long as it lives: without it an overflow of the stack is silent.
class SignalStack {
 public:
  SignalStack();
  SignalStack(const SignalStack&) = delete;
  SignalStack& operator=(const SignalStack&) = delete;
  ~SignalStack();

 private:
  std::unique_ptr<std::byte[]> memory_;
};

/// From now on a thread that crashes in a unit says on standard error in which; then happens what would have happened.
void report_crashes();

}  // namespace torse::fuzz
