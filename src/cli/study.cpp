// torse study: the rounding errors of the formulas, by designs of experiment.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "torse/cli/build_id.hpp"
#include "torse/cli/claims.hpp"
#include "torse/cli/command.hpp"
#include "torse/cli/html_report.hpp"
#include "torse/cli/named_files.hpp"
#include "torse/cli/study.hpp"
#include "torse/cli/terminal.hpp"
#include "torse/io/file.hpp"
#include "torse/io/text.hpp"

namespace torse::cli {
namespace {

struct StudyOptions {
  std::string name;
  std::string file;
  std::string route = "FJ07.13.rulings";
  std::string effort = "standard";
  std::optional<std::uint64_t> seed;
  std::string shard;
  bool resume = false;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  std::string json;
  std::string csv;
  std::string svg;
  HtmlOption html;
};

void print_list() {
  const Terminal terminal(stdout);
  for (const std::string& name : studies::design_names()) {
    const studies::Design design = studies::built_in_design(name);
    terminal.print(fmt::format("{:<16} {:>5} cases  {}\n", name, design.cases(proofs::Effort::standard), design.title));
  }
  terminal.print("\nroutes:");
  for (const std::string& name : studies::route_names()) terminal.print(" " + name);
  terminal.print("\nscalars:");
  for (const std::string& name : studies::scalar_names()) terminal.print(" \"" + name + "\"");
  terminal.print("\ntests:");
  for (const std::string& name : studies::verdict_names()) terminal.print(" \"" + name + "\"");
  terminal.print("\n");
}

/// A study that is part of the program, or the file of one.
studies::Design find_design(const std::string& name) {
  const std::vector<std::string> names = studies::design_names();
  if (std::ranges::find(names, name) != names.end()) return studies::built_in_design(name);
  if (name.ends_with(".json")) return studies::read_design(name, read_file(name));
  std::vector<std::string> known = names;
  known.insert(known.end(), {"list", "autopsy"});
  require_known("study", {name}, known);
  return {};
}

/// "i/k" with 1 <= i <= k.
void read_shard(const std::string& text, studies::Task& task) {
  if (text.empty()) return;
  const char* const end = text.data() + text.size();
  std::size_t i = 0;
  std::size_t k = 0;
  const auto first = std::from_chars(text.data(), end, i);
  const bool slash = first.ec == std::errc() && first.ptr != end && *first.ptr == '/';
  const auto second = slash ? std::from_chars(first.ptr + 1, end, k) : first;
  if (!slash || second.ec != std::errc() || second.ptr != end || i < 1 || k < i || k > 1'000'000) {
    throw UsageError("--shard: expected i/k with 1 <= i <= k, found " + printable(text));
  }
  task.shard = i - 1;
  task.shards = k;
}

studies::Task task_of(const StudyOptions& options) {
  require_known("--effort", {options.effort}, {"quick", "standard", "deep"});
  studies::Task task;
  task.design = find_design(options.name);
  task.effort = options.effort == "quick"      ? proofs::Effort::quick
                : options.effort == "standard" ? proofs::Effort::standard
                                               : proofs::Effort::deep;
  task.seed = options.seed.value_or(task.design.seed);
  read_shard(options.shard, task);
  return task;
}

/// Throws UsageError where another file to write is the journal, which is removed at the end.
void require_free(const std::string& journal, const StudyOptions& options) {
  const std::string page = options.html.wanted() ? page_file(options.html.path) : "";
  for (const auto& [option, file] : {std::pair{"--json", options.json}, std::pair{"--csv", options.csv},
                                     std::pair{"--svg", options.svg}, std::pair{"--html", page}}) {
    if (file.empty() || !same_file(file, journal)) continue;
    throw UsageError(fmt::format("{}: expected another file than {}, where the cases that are done are kept", option,
                                 in_quotes(journal)));
  }
}

/// The file of results that is written besides the summary; its name with ".part" is the journal's.
std::string journal_file(const StudyOptions& options) {
  for (const std::string& file : {options.json, options.csv}) {
    if (file.empty() || file == "-") continue;
    require_free(file + ".part", options);
    return file + ".part";
  }
  if (options.resume) throw UsageError("--resume needs the file of --json or --csv that the run was to write");
  return "";
}

std::function<void(std::size_t, std::size_t)> progress_line() {
  if (isatty(STDERR_FILENO) == 0) return {};
  return [](std::size_t done, std::size_t all) {
    std::fprintf(stderr, "\r\033[K[%zu/%zu]", done, all);
    if (done == all) std::fputs("\r\033[K", stderr);
  };
}

int run_design(const StudyOptions& options) {
  require_viewer(options.html);
  const studies::Task task = task_of(options);
  const std::string part = journal_file(options);
  std::optional<studies::Journal> journal;
  if (!part.empty()) journal.emplace(part, task, build_id(), options.resume);
  const std::vector<std::string> records =
      studies::run_study(task, options.threads, journal ? &*journal : nullptr, progress_line());

  if (!options.json.empty()) write_file(options.json, study_lines(records));
  if (!options.csv.empty()) write_file(options.csv, study_csv(task, records));
  const StudySummary summary = summary_of(task, records);
  if (!options.svg.empty()) write_file(options.svg, study_svg(task, summary));
  if (options.html.wanted()) {
    write_html(options.html, "Numerical stability", nlohmann::ordered_json::array({study_section(task, summary)}));
  }
  if (journal) journal->remove();
  if (options.json != "-" && options.csv != "-") print_study(Terminal(stdout), task, summary);
  return summary.above_bound > 0 ? exit_code::refuted : exit_code::success;
}

/// Throws UsageError for an option that was given and is not one of these.
void require_only(const CLI::App& app, const std::vector<std::string>& known) {
  for (const CLI::Option* option : app.get_options()) {
    const std::string name = option->get_name();
    if (option->count() == 0 || option->get_positional() || std::ranges::count(known, name) > 0) continue;
    throw UsageError(name + " is for studies: torse study NAME " + name);
  }
}

int run_words(const CLI::App& app, const StudyOptions& options) {
  if (options.name == "autopsy") {
    if (options.file.empty()) throw UsageError("torse study autopsy: expected a file");
    require_only(app, {"--route", "--json"});
    return print_autopsy(options.file, options.route, options.json);
  }
  if (!options.file.empty()) throw UsageError("unexpected word " + printable(command_line({options.file})));
  if (app.count("--route") > 0) throw UsageError("--route is for torse study autopsy");
  if (options.name == "list") {
    require_only(app, {});
    print_list();
    return exit_code::success;
  }
  return run_design(options);
}

}  // namespace

std::function<int()> define_study(CLI::App& app) {
  const auto options = std::make_shared<StudyOptions>();
  app.add_option("name", options->name, "a study, the file of a design, list, or autopsy")
      ->type_name("NAME|DESIGN.json")
      ->required();
  app.add_option("file", options->file, "autopsy: the input of torse construct, or a ruled surface");
  app.add_option("--route", options->route, "autopsy: the route of the methods bspline and bezier, as FJ07.13")
      ->capture_default_str();
  app.add_option("--json", options->json, "write the cases as lines of JSON; - is standard output")->type_name("FILE");
  app.add_option("--csv", options->csv, "write a row for each route, arithmetic and case; - is standard output")
      ->type_name("FILE");
  app.add_option("--svg", options->svg, "draw the errors over what the design varies")->type_name("FILE");
  add_html_option(app, options->html);
  app.add_option("--effort", options->effort, "quick, standard or deep: how often each case is repeated")
      ->capture_default_str();
  app.add_option("--seed", options->seed, "the seed of all inputs, instead of the design's");
  app.add_option("--shard", options->shard, "i/k: the i-th of k parts, whose results are to be joined in this order");
  app.add_flag("--resume", options->resume, "go on where a run that was killed has stopped");
  app.add_option("--threads", options->threads, "how many threads; the results do not depend on it")
      ->check(CLI::Range(1U, 256U))
      ->capture_default_str();
  return [&app, options] { return run_words(app, *options); };
}

}  // namespace torse::cli
