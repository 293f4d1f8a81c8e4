// What a subcommand of the program is, and the exit codes.
//   Command          its name, its line in the help, how it defines its options
//   exit_code        0 all hold, 1 refuted, 2 usage or unreadable input, 3 undecided
//   UsageError       a wrong option: exit code 2 with a hint at --help
#pragma once

#include <CLI/App.hpp>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "torse/scalar/errors.hpp"

namespace torse::cli {

/// A subcommand. `define` adds the options to the subcommand's parser and returns the action, which runs when the
/// command line is parsed and returns the exit code.
struct Command {
  std::string_view name;
  std::string_view summary;
  std::function<int()> (*define)(CLI::App& app);
};

namespace exit_code {
inline constexpr int success = 0;
inline constexpr int refuted = 1;
inline constexpr int unusable = 2;
inline constexpr int undecided = 3;

/// That of two runs as one: what cannot be used counts more than what is refuted, and that more than what is undecided.
constexpr int worse(int a, int b) {
  for (const int code : {unusable, refuted, undecided}) {
    if (a == code || b == code) return code;
  }
  return success;
}
}  // namespace exit_code

/// A command line that parses but makes no sense.
class UsageError : public Error {
 public:
  using Error::Error;
};

/// The subcommands, a file each.
std::function<int()> define_campaign(CLI::App& app);
std::function<int()> define_check(CLI::App& app);
std::function<int()> define_construct(CLI::App& app);
std::function<int()> define_convert(CLI::App& app);
std::function<int()> define_example(CLI::App& app);
std::function<int()> define_explain(CLI::App& app);
std::function<int()> define_figures(CLI::App& app);
std::function<int()> define_fit(CLI::App& app);
std::function<int()> define_list(CLI::App& app);
std::function<int()> define_recover(CLI::App& app);
std::function<int()> define_replay(CLI::App& app);
std::function<int()> define_study(CLI::App& app);
std::function<int()> define_unroll(CLI::App& app);
std::function<int()> define_verify(CLI::App& app);

/// Runs the program on these words (without the program's name) and returns its exit code.
int run_program(const std::vector<std::string>& words);

}  // namespace torse::cli
