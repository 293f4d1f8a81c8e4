// torse replay: a file with a failing case, run again without any random choice of its own. The file is a report of
// torse verify (every finding that failed runs again with its seed), a saved case of a property, a database of torse
// campaign (every case that failed), a surface (checked) or a construction (made, checked).
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "torse/cli/command.hpp"
#include "torse/cli/terminal.hpp"
#include "torse/fuzz/campaign/store.hpp"
#include "torse/fuzz/run.hpp"
#include "torse/io/file.hpp"
#include "torse/io/spline_file.hpp"
#include "torse/io/text.hpp"

namespace torse::cli {
namespace {

using Json = nlohmann::json;

/// Whether a finding of a report is one that fails or decides nothing.
bool failed(const Json& finding) {
  const std::string status = finding.value("status", "");
  return status == "Refuted" || status == "GaveUp" || status == "Undecided" ||
         !finding.value("survivors", Json::array()).empty();
}

/// The commands that run the failed findings of a report again.
std::vector<std::vector<std::string>> commands_of(const std::string& file, const Json& report) {
  std::vector<std::vector<std::string>> commands;
  try {
    for (const Json& claim : report.at("claims")) {
      for (const Json& finding : claim.at("engines")) {
        if (!failed(finding)) continue;
        commands.push_back({"verify", "--claim", claim.at("id").get<std::string>(), "--engine",
                            finding.at("engine").get<std::string>(), "--effort", report.at("effort").get<std::string>(),
                            "--seed", std::to_string(report.at("seed").get<std::uint64_t>())});
      }
    }
  } catch (const Json::exception& error) {
    throw FileError(file, std::string("expected a report of torse verify --json, found ") + error.what());
  }
  return commands;
}

/// Runs the commands in order; the worst exit code wins.
int run_commands(const std::vector<std::vector<std::string>>& commands) {
  const Terminal terminal(stdout);
  int worst = exit_code::success;
  for (const std::vector<std::string>& command : commands) {
    terminal.print(terminal.painted(Paint::dim, "torse " + printable(command_line(command))) + "\n");
    worst = exit_code::worse(worst, run_program(command));
  }
  return worst;
}

/// Runs a saved case: 0 if the property holds, 1 if not, 3 if the input is no case of it.
int run_case(const Document& document) {
  const fuzz::CaseReport report = fuzz::replay_case(document);
  const std::string name = document.root().at("property").string();
  const Terminal terminal(stdout);
  if (report.result == fuzz::CaseResult::held) {
    terminal.print(name + ": holds\n");
    return exit_code::success;
  }
  if (report.result == fuzz::CaseResult::failed) {
    terminal.print(name + ": FAILS: " + printable(report.message) + "\n");
    return exit_code::refuted;
  }
  terminal.print(name + ": no case: " + printable(report.message) + "\n");
  return exit_code::undecided;
}

/// Whether a file can be read again: a pipe cannot.
bool is_regular(const std::string& file) {
  std::error_code ignored;
  return file != "-" && std::filesystem::is_regular_file(file, ignored);
}

bool is_database(const std::string& file) {
  if (!is_regular(file)) return false;
  constexpr std::string_view magic("SQLite format 3", 16);
  std::string begin(magic.size(), ' ');
  std::ifstream(file, std::ios::binary).read(begin.data(), static_cast<std::streamsize>(begin.size()));
  return begin == magic;
}

void put_on_standard_input(const std::string& text) {
  std::FILE* const copy = std::tmpfile();
  if (copy == nullptr) throw Error("there is no place for a copy of the input");
  const bool written = std::fwrite(text.data(), 1, text.size(), copy) == text.size() && std::fflush(copy) == 0 &&
                       dup2(fileno(copy), STDIN_FILENO) == STDIN_FILENO;
  std::fclose(copy);
  if (!written) throw Error("the input cannot be copied");
  std::rewind(stdin);
}

/// The word for a file, which has been read, in a command that reads it again: of a pipe, standard input with its text.
std::string word_of(const std::string& file, const std::string& text) {
  if (is_regular(file)) return file_word(file);
  put_on_standard_input(text);
  return "-";
}

/// Runs the failing cases of a campaign; the worst exit code wins.
int run_database(const std::string& file) {
  fuzz::Store store(file, fuzz::Database::Open::existing);
  const Terminal terminal(stdout);
  int worst = exit_code::success;
  std::size_t count = 0;
  for (const fuzz::Series& series : store.series()) {
    for (const fuzz::Failure& failure : store.failures(series, fuzz::all_seeds)) {
      const std::string name = file + ", " + fuzz::unit_name(series, failure.saved.seed);
      terminal.print(terminal.painted(Paint::dim, printable(name)) + "\n");
      worst = exit_code::worse(worst, run_case(Document(name, failure.saved.text)));
      ++count;
    }
  }
  if (count == 0) terminal.print("nothing failed in this campaign\n");
  return worst;
}

int run_replay(const std::string& file) {
  if (is_database(file)) return run_database(file);
  const std::string text = read_file(file);
  const Json report = Json::parse(text, nullptr, false);
  if (!report.is_discarded() && report.is_object() && report.contains("claims")) {
    const auto commands = commands_of(file, report);
    if (commands.empty()) Terminal(stdout).print("nothing failed in this report\n");
    return run_commands(commands);
  }
  const Document document(file, text);
  const std::string& type = file_type(document);
  if (type == "case") return run_case(document);
  if (type == "ruled") return run_commands({{"check", word_of(file, text)}});
  if (type == "construct") {
    return run_commands({{"construct", document.root().at("method").string(), word_of(file, text), "-o", "-"}});
  }
  document.root().at("type").expected("\"case\", \"ruled\", \"construct\" or a report of torse verify");
}

}  // namespace

std::function<int()> define_replay(CLI::App& app) {
  const auto file = std::make_shared<std::string>();
  app.add_option("FILE", *file,
                 "a report of torse verify, a saved case, a database of torse campaign, a surface or a construction; - "
                 "is standard input, but for a database")
      ->required();
  return [file] { return run_replay(*file); };
}

}  // namespace torse::cli
