// The program torse: parses the command line and runs one subcommand.
#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <limits>
#include <new>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "torse/cli/command.hpp"
#include "torse/cli/named_files.hpp"
#include "torse/cli/suggest.hpp"
#include "torse/cli/terminal.hpp"
#include "torse/cli/version.hpp"
#include "torse/io/text.hpp"

namespace torse::cli {
namespace {

/// A new subcommand is one line here and its declaration in command.hpp.
constexpr Command commands[] = {
    {"verify", "run the papers' claims in every arithmetic", define_verify},
    {"list", "list the claims or the engines", define_list},
    {"explain", "a claim's statement, hypotheses and wrong variants", define_explain},
    {"replay", "run a failing case from its file again", define_replay},
    {"example", "the papers' worked examples, printed beside computed values", define_example},
    {"check", "decide exactly whether ruled surfaces are developable, and their class", define_check},
    {"construct", "make a developable surface through a curve", define_construct},
    {"fit", "the most developable ruled surface between two rails", define_fit},
    {"figures", "the papers' figures as SVG, drawn from computed surfaces", define_figures},
    {"recover", "Lambda, M, sigma, class, edge and singular parameters from the net alone", define_recover},
    {"convert", "write ruled surfaces as STEP, IGES, OBJ, STL, glTF or JSON", define_convert},
    {"campaign", "properties over ranges of seeds, in a database that can be resumed, merged and compared",
     define_campaign},
    {"study", "rounding errors of the formulas, by designs of experiment; where the digits of an input are lost",
     define_study},
    {"unroll", "a developable surface as a flat plate: SVG, DXF, JSON with certified lengths", define_unroll},
};

/// Takes what is written as the program itself writes a number of this type.
template <class T>
CLI::Validator whole_number() {
  const auto complaint = [](const std::string& text) {
    T value{};
    const char* const end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, value);
    if (error == std::errc() && stopped == end && std::to_string(value) == text) return std::string();
    return fmt::format("expected a whole number from {} to {}, found {}", std::numeric_limits<T>::min(),
                       std::numeric_limits<T>::max(), printable(text));
  };
  return {complaint, ""};
}

/// Takes numbers such as 12, -1.5 and 1e3, not nan.
CLI::Validator finite_number() {
  const auto complaint = [](const std::string& text) {
    double value{};
    const char* const end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, value);
    if (error == std::errc() && stopped == end && std::isfinite(value)) return std::string();
    return "expected a number, found " + printable(text);
  };
  return {complaint, ""};
}

/// The subcommand, or subcommand of it, that was parsed last.
const CLI::App& innermost(const CLI::App& app) {
  const std::vector<CLI::App*> used = app.get_subcommands();
  return used.empty() ? app : innermost(*used.back());
}

/// The words in front of the options: "torse campaign run".
std::string words_of(const CLI::App& app) {
  const CLI::App* parent = app.get_parent();
  return (parent == nullptr ? "" : words_of(*parent) + " ") + app.get_name();
}

/// The word that the parser did not expect with the nearest one it knows.
std::string unknown_word(const CLI::App& app) {
  const CLI::App* scope = &innermost(app);
  std::vector<std::string> known;
  for (const CLI::Option* option : scope->get_options()) {
    for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  }
  for (const CLI::App* word : scope->get_subcommands([](const CLI::App*) { return true; })) {
    known.push_back(word->get_name());
  }
  const std::vector<std::string> left = scope->remaining(true);
  const std::string word = left.empty() ? "" : left.front();
  return "unexpected word " + printable(command_line({word})) + suggestion(word.substr(0, word.find('=')), known);
}

int report_usage(const CLI::App& app, const CLI::ParseError& error) {
  const bool unknown = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
  print_error(unknown ? unknown_word(app) : error.what());
  Terminal(stderr).print("try: " + words_of(innermost(app)) + " --help\n");
  return exit_code::unusable;
}

/// Throws UsageError for an option with an empty value, which a shell makes of a variable that is not set: a limit
/// would be dropped without a word.
void require_values(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    if (std::ranges::count(option->results(), std::string()) == 0) continue;
    throw UsageError(option->get_name() + ": expected a value, found an empty one");
  }
  for (const CLI::App* used : app.get_subcommands()) require_values(*used);
}

/// Makes every option of this subcommand, and of those below it, that takes a whole number refuse what is none: the
/// parser would read -1 as the largest number and 010 as 8.
void require_whole_numbers(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    const std::string type = option->get_type_name();
    if (type.starts_with("UINT")) option->transform(whole_number<std::uint64_t>());
    if (type.starts_with("INT")) option->transform(whole_number<int>());
    if (type.starts_with("FLOAT")) option->transform(finite_number());
  }
  for (CLI::App* sub : app.get_subcommands({})) require_whole_numbers(*sub);
}

/// Puts its folder before a file called "[a,b]", which the parser would take for a list of a and b.
void protect_brackets(std::vector<std::string>& words) {
  std::error_code ignored;
  for (std::string& word : words) {
    if (word.starts_with('[') && word.ends_with(']') && std::filesystem::exists(word, ignored)) word = "./" + word;
  }
}

int run(std::vector<std::string> words) {
  CLI::App app("Construct, check and prove developable ruled spline surfaces in exact arithmetic.", "torse");
  app.set_version_flag("--version", std::string("torse ") + version, "print the version");
  app.set_help_flag("-h,--help", "print this help");
  app.footer(
      "Exit codes: 0 all hold, 1 refuted, 2 usage or unreadable input, 3 undecided.\n"
      "Help on a command: torse COMMAND --help");
  app.require_subcommand(0, 1);
  std::vector<std::pair<CLI::App*, std::function<int()>>> actions;
  for (const Command& command : commands) {
    CLI::App* sub = app.add_subcommand(std::string(command.name), std::string(command.summary));
    actions.emplace_back(sub, command.define(*sub));
    require_whole_numbers(*sub);
    take_one_file_each(*sub);
  }
  try {
    protect_brackets(words);
    std::ranges::reverse(words);
    app.parse(std::move(words));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    return report_usage(app, error);
  }
  require_values(app);
  require_distinct_files(app);
  require_fitting_names(app);
  for (const auto& [sub, action] : actions) {
    if (sub->parsed()) return action();
  }
  Terminal(stderr).print(app.help());
  return exit_code::unusable;
}

/// Runs the program; every error becomes one line and an exit code.
int guarded(std::vector<std::string> words) {
  try {
    return run(std::move(words));
  } catch (const Undecided& error) {
    print_error(error.what());
    return exit_code::undecided;
  } catch (const std::bad_alloc&) {
    print_error("out of memory");
  } catch (const std::exception& error) {
    print_error(error.what());
  }
  return exit_code::unusable;
}

}  // namespace

int run_program(const std::vector<std::string>& words) { return guarded(words); }

}  // namespace torse::cli
