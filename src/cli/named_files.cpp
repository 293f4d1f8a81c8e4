// Names are compared as the file system sees them.
#include "torse/cli/named_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "torse/cli/command.hpp"
#include "torse/cli/conversion.hpp"
#include "torse/cli/faces.hpp"
#include "torse/cli/html_report.hpp"
#include "torse/io/text.hpp"

namespace torse::cli {
namespace {

namespace fs = std::filesystem;

struct NamedFile {
  std::string option;
  std::string file;
};

bool written(const CLI::Option& option) {
  constexpr std::array<std::string_view, 3> types{"FILE", "OUT", "PATH"};
  return !option.get_positional() && std::ranges::count(types, option.get_type_name()) > 0;
}

/// Whether this word after this option is a file that is read. The name of a study is one if it ends so.
bool read(const CLI::Option& option, const std::string& word) {
  constexpr std::array<std::string_view, 8> options{"FILE", "RAILS", "INPUT", "file", "DB", "A", "B", "--baseline"};
  const std::string name = option.get_name();
  return name == "name" ? word.ends_with(".json") : std::ranges::count(options, name) > 0;
}

/// Options whose files have one format, with the endings it has.
struct OneFormat {
  std::string_view option;
  std::string_view format;
  std::string_view usual;
  std::string_view other{};
};
constexpr std::array<OneFormat, 6> one_format{{{"--json", "JSON", ".json"},
                                               {"--ledger", "JSON", ".json"},
                                               {"--junit", "JUnit's XML", ".xml"},
                                               {"--sarif", "SARIF", ".sarif", ".json"},
                                               {"--csv", "CSV", ".csv"},
                                               {"--svg", "SVG", ".svg"}}};

void require_fitting_name(const OneFormat& own, const std::string& file) {
  const std::string ending = extension_of(file);
  if (ending == own.usual || ending == own.other || !is_written(ending)) return;
  throw UsageError(fmt::format("{}: expected a name for {}, found {}", own.option, own.format, in_quotes(file)));
}

/// An absolute name without links as far as it exists.
fs::path resolved(const std::string& file) {
  std::error_code ignored;
  const fs::path path = fs::absolute(file, ignored);
  const fs::path result = fs::weakly_canonical(path, ignored);
  return result.empty() ? path : result;
}

void require_distinct(const NamedFile& a, const NamedFile& b) {
  if (!same_file(a.file, b.file)) return;
  const std::string options = a.option == b.option ? a.option : a.option + " and " + b.option;
  if (a.file == "-") {
    throw UsageError(a.option == b.option ? options + ": only one can be standard output"
                                          : fmt::format("only one of {} can write to standard output", options));
  }
  throw UsageError(
      fmt::format("{}: expected different files, found {} and {}", options, in_quotes(a.file), in_quotes(b.file)));
}

}  // namespace

bool same_file(const std::string& a, const std::string& b) {
  if (a == "-" || b == "-") return a == b;
  std::error_code ignored;
  if (fs::exists(a, ignored) && fs::exists(b, ignored)) {
    return fs::is_regular_file(a, ignored) && fs::equivalent(a, b, ignored);
  }
  return resolved(a) == resolved(b);
}

void take_one_file_each(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    if (written(*option)) option->allow_extra_args(false);
  }
  for (CLI::App* sub : app.get_subcommands({})) take_one_file_each(*sub);
}

void require_fitting_names(const CLI::App& app) {
  for (const OneFormat& own : one_format) {
    const CLI::Option* option = app.get_option_no_throw(std::string(own.option));
    if (option == nullptr) continue;
    for (const std::string& file : option->results()) require_fitting_name(own, file);
  }
  for (const CLI::App* used : app.get_subcommands()) require_fitting_names(*used);
}

void require_distinct_files(const CLI::App& app) {
  std::vector<NamedFile> inputs;
  std::vector<NamedFile> outputs;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& word : option->results()) {
      if (read(*option, word) && word != "-") inputs.push_back({option->get_name(), word});
      if (!written(*option)) continue;
      const bool page = option->get_type_name() == "PATH";
      const NamedFile output{option->get_name(), page ? page_file(word) : word};
      for (const NamedFile& other : outputs) require_distinct(other, output);
      outputs.push_back(output);
    }
  }
  for (const NamedFile& output : outputs) {
    for (const NamedFile& input : inputs) require_distinct(input, output);
  }
  for (const CLI::App* used : app.get_subcommands()) require_distinct_files(*used);
}

}  // namespace torse::cli
