// The real program with its standard error on a terminal.
//   TerminalResult     exit code, standard output, what appeared on the terminal
//   run_on_terminal    with words as they are
#pragma once

#include <fcntl.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/program.hpp"

namespace torse::testing {

struct TerminalResult {
  int exit;
  std::string out;
  std::string screen;
};

/// The master's end of a pseudoterminal.
class Pseudoterminal {
 public:
  Pseudoterminal() : master_(posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)) {
    if (grantpt(master_) != 0 || unlockpt(master_) != 0) throw std::runtime_error("there is no pseudoterminal");
  }
  Pseudoterminal(const Pseudoterminal&) = delete;
  Pseudoterminal& operator=(const Pseudoterminal&) = delete;
  ~Pseudoterminal() { close(master_); }

  std::string name() const { return ptsname(master_); }

  /// All that is written at the other end until nobody has it open.
  std::string read_all() const {
    std::string text;
    char buffer[4096];
    for (;;) {
      const ssize_t count = read(master_, buffer, sizeof buffer);
      if (count > 0) text.append(buffer, static_cast<std::size_t>(count));
      if (count == 0 || (count < 0 && errno != EINTR)) return text;
    }
  }

 private:
  int master_;
};

inline TerminalResult run_on_terminal(const std::vector<std::string>& words) {
  const Scratch scratch;
  const Pseudoterminal terminal;
  std::vector<char*> arguments{const_cast<char*>(TORSE_PROGRAM_PATH)};
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const std::string out = (scratch / "out").string();
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, 1, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_addopen(&files, 2, terminal.name().c_str(), O_RDWR | O_NOCTTY, 0);
  pid_t program = 0;
  const int error = posix_spawn(&program, arguments[0], &files, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (error != 0) throw std::runtime_error("the program cannot be started");
  const std::string screen = terminal.read_all();
  int status = 0;
  waitpid(program, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), slurp(out), screen};
}

}  // namespace torse::testing
