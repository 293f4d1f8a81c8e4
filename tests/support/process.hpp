// Programs that are killed while they run.
//   Process           a started program: signals, its end          processes_with     those that have a word and a
//   variable CampaignRuns      a folder with databases of torse campaign, and the units in them
#pragma once

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <ios>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "support/program.hpp"
#include "torse/fuzz/campaign/store.hpp"
#include "torse/io/document.hpp"

namespace torse::testing {

/// A program with more environment variables than this one has, and its output in a file.
class Process {
 public:
  Process(const std::vector<std::string>& words, const std::map<std::string, std::string>& variables,
          const std::filesystem::path& output)
      : output_(output) {
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    std::vector<std::string> texts;
    for (const auto& [name, value] : variables) texts.push_back(name + "=" + value);
    std::vector<char*> environment;
    for (char** variable = environ; *variable != nullptr; ++variable) {
      const std::string name = std::string(*variable).substr(0, std::string(*variable).find('='));
      if (variables.count(name) == 0 && name.rfind("GTEST_", 0) != 0) environment.push_back(*variable);
    }
    for (std::string& text : texts) environment.push_back(text.data());
    environment.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, 1, output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_adddup2(&files, 1, 2);
    if (posix_spawnp(&id_, arguments[0], &files, nullptr, arguments.data(), environment.data()) != 0) id_ = -1;
    posix_spawn_file_actions_destroy(&files);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process() {
    if (id_ <= 0) return;
    ::kill(id_, SIGKILL);
    wait();
  }

  /// Only while it has not been waited for.
  void send(int signal) const { ::kill(id_, signal); }
  /// Whether it still runs.
  bool runs() {
    if (id_ > 0 && waitpid(id_, &status_, WNOHANG) == id_) id_ = 0;
    return id_ > 0;
  }
  /// Waits for its end: the exit code, or 128 + the signal.
  int wait() {
    if (id_ > 0) waitpid(id_, &status_, 0);
    id_ = 0;
    return WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_);
  }
  std::string output() const { return slurp(output_); }

 private:
  std::filesystem::path output_;
  pid_t id_ = -1;
  int status_ = 0;
};

/// The numbers of the processes whose command line has this word and whose environment has this text.
inline std::vector<pid_t> processes_with(const std::string& word, const std::string& variable) {
  std::vector<pid_t> list;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator("/proc", ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    std::string words(1, '\0');
    std::string variables(1, '\0');
    try {
      words += slurp(entry.path() / "cmdline");
      variables += slurp(entry.path() / "environ");
    } catch (const std::ios_base::failure&) {  // it has ended in between
      continue;
    }
    const auto has = [](const std::string& text, const std::string& part) {
      return text.find('\0' + part + '\0') != std::string::npos;
    };
    if (has(words, word) && (variable.empty() || has(variables, variable))) list.push_back(std::stoi(name));
  }
  return list;
}

/// Waits for something, a minute at most.
template <class Condition>
bool wait_for(const Condition& condition) {
  for (int i = 0; i < 12000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

/// Databases of campaigns of one property.
class CampaignRuns {
 public:
  static constexpr const char* property = "text.number";

  std::string file(const std::string& name) const { return (scratch_ / name).string(); }
  const Scratch& scratch() const { return scratch_; }

  /// The words of a run.
  std::vector<std::string> run(const std::string& name, const std::string& seeds, const std::string& jobs) const {
    return {TORSE_PROGRAM_PATH, "campaign", "run",        "--db",   file(name), "--seeds", seeds,
            "--effort",         "quick",    "--property", property, "--jobs",   jobs};
  }
  /// The units in a database, 0 while it is none.
  std::uint64_t units(const std::string& name) const {
    try {
      fuzz::Store store(file(name), fuzz::Database::Open::existing);
      return store.unit_count({property, "quick"}, fuzz::all_seeds);
    } catch (const FileError&) {
      return 0;
    }
  }
  /// The greatest seed in a database.
  std::uint64_t last_seed(const std::string& name) const {
    fuzz::Store store(file(name), fuzz::Database::Open::existing);
    return static_cast<std::uint64_t>(store.database().number("SELECT max(seed) FROM unit"));
  }
  /// SQLite's own check of the whole file.
  bool sound(const std::string& name) const {
    fuzz::Store store(file(name), fuzz::Database::Open::existing);
    fuzz::Statement check = store.database().prepare("PRAGMA integrity_check");
    return check.step() && check.text(0) == "ok";
  }

 private:
  Scratch scratch_;
};

}  // namespace torse::testing
