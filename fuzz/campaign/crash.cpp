// Signal handlers: nothing but write, sigaction and raise is called in them.
#include "torse/fuzz/campaign/crash.hpp"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/common_interface_defs.h>
#endif

namespace torse::fuzz {
namespace {

constexpr std::array<int, 5> signals{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
constexpr std::size_t stack_size = std::size_t{1} << 16U;

thread_local std::array<char, 256> at_work{};
std::array<struct sigaction, signals.size()> before{};

void say(const char* text) {
  if (write(STDERR_FILENO, text, std::strlen(text)) < 0) return;
}

void say_unit() {
  if (at_work[0] == '\0') return;
  say("torse: error: crashed in ");
  say(at_work.data());
  say("\n");
}

void on_signal(int signal, siginfo_t* info, void*) {
  say_unit();
  const auto place = static_cast<std::size_t>(std::find(signals.begin(), signals.end(), signal) - signals.begin());
  sigaction(signal, &before[place], nullptr);
  // A fault comes again where the handler returns to; a signal that was sent does not.
  if (info->si_code <= 0) raise(signal);
}

}  // namespace

UnitAtWork::UnitAtWork(const std::string& name) {
  const std::size_t size = std::min(name.size(), at_work.size() - 1);
  name.copy(at_work.data(), size);
  at_work[size] = '\0';
}

UnitAtWork::~UnitAtWork() { at_work[0] = '\0'; }

SignalStack::SignalStack() : memory_(std::make_unique<std::byte[]>(stack_size)) {
  stack_t stack{};
  stack.ss_sp = memory_.get();
  stack.ss_size = stack_size;
  sigaltstack(&stack, nullptr);
}

SignalStack::~SignalStack() {
  stack_t none{};
  none.ss_flags = SS_DISABLE;
  sigaltstack(&none, nullptr);
}

void report_crashes() {
#ifdef __SANITIZE_ADDRESS__
  __sanitizer_set_death_callback(say_unit);
#endif
  for (std::size_t i = 0; i < signals.size(); ++i) {
    struct sigaction action {};
    action.sa_sigaction = on_signal;
    action.sa_flags = SA_SIGINFO | SA_ONSTACK;
    sigemptyset(&action.sa_mask);
    sigaction(signals[i], &action, &before[i]);
  }
}

}  // namespace torse::fuzz
