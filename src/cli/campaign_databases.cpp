// torse campaign show, merge and export.
#include <fmt/format.h>

#include <filesystem>
#include <limits>
#include <memory>

#include "torse/cli/campaign.hpp"
#include "torse/cli/command.hpp"
#include "torse/cli/json_report.hpp"
#include "torse/fuzz/campaign/compare.hpp"
#include "torse/io/text.hpp"

namespace torse::cli {
namespace {

using Json = nlohmann::ordered_json;
using Open = fuzz::Database::Open;
namespace fs = std::filesystem;

std::vector<SeriesReport> all_reports(fuzz::Store& store) {
  std::vector<SeriesReport> reports;
  for (const fuzz::Series& series : store.series()) {
    reports.push_back(series_report(store, series, fuzz::all_seeds));
  }
  return reports;
}

int verdict(const std::vector<SeriesReport>& reports) {
  return std::ranges::any_of(reports, &SeriesReport::failed) ? exit_code::refuted : exit_code::success;
}

Json run_json(const fuzz::RunInfo& run) {
  return {{"started", printable(run.started)},
          {"version", printable(run.version)},
          {"build", printable(run.build)},
          {"options", printable(run.options)},
          {"seconds", run.seconds}};
}

int show(const std::string& database, const std::string& json_file) {
  fuzz::Store store(database, Open::existing);
  const std::vector<SeriesReport> reports = all_reports(store);
  const CaseFiles files{database, ""};
  if (!json_file.empty()) {
    Json json{{"torse", 1}, {"campaign", printable(database)}};
    add_reports(json, reports, files);
    json["runs"] = Json::array();
    for (const auto& [number, run] : store.runs()) json["runs"].push_back(run_json(run));
    write_json(json_file, json);
    if (json_file == "-") return verdict(reports);
  }
  const Terminal terminal(stdout);
  print_reports(terminal, reports);
  print_failures(terminal, reports, files);
  for (const auto& [number, run] : store.runs()) {
    terminal.print(terminal.painted(
                       Paint::dim,
                       fmt::format("run {}: torse {}, build {:.12}, {}, {:.1f} s", printable(run.started),
                                   printable(run.version), printable(run.build), printable(run.options), run.seconds)) +
                   "\n");
  }
  return verdict(reports);
}

/// What a file was before it was made a database.
enum class Before { none, empty, other };

Before before_of(const std::string& file) {
  std::error_code failure;
  if (!fs::exists(file, failure)) return failure ? Before::other : Before::none;
  return fs::file_size(file, failure) == 0 ? Before::empty : Before::other;
}

void restore(const std::string& file, Before before) {
  std::error_code ignored;
  if (before == Before::none) fs::remove(file, ignored);
  if (before == Before::empty) fs::resize_file(file, 0, ignored);
}

int merge(const std::string& into, const std::vector<std::string>& from) {
  const Before before = before_of(into);
  fuzz::Merged merged;
  try {
    for (const std::string& file : from) fuzz::Store(file, Open::existing);
    fuzz::Store store(into, Open::create);
    merged = fuzz::merge(store, from);
  } catch (...) {
    restore(into, before);
    throw;
  }
  Terminal(stdout).print(
      fmt::format("{}: {} units added, {} were there already\n", printable(into), merged.added, merged.known));
  return exit_code::success;
}

int export_cases(const std::string& database, const std::string& folder) {
  fuzz::Store store(database, Open::existing);
  const std::vector<SeriesReport> reports = all_reports(store);
  CaseFiles files{database, folder};
  write_cases(reports, files, std::numeric_limits<std::size_t>::max());
  Terminal(stdout).print(fmt::format("{} failing cases\n", files.written.size()));
  return exit_code::success;
}

}  // namespace

std::function<int()> define_campaign_show(CLI::App& app) {
  const auto database = std::make_shared<std::string>();
  const auto json = std::make_shared<std::string>();
  app.add_option("DB", *database, "the database")->required();
  app.add_option("--json", *json, "write all of it as JSON; - is standard output")->type_name("FILE");
  return [database, json] { return show(*database, *json); };
}

std::function<int()> define_campaign_merge(CLI::App& app) {
  const auto into = std::make_shared<std::string>();
  const auto from = std::make_shared<std::vector<std::string>>();
  app.add_option("OUT", *into, "the database to add to; made where there is none")->required();
  app.add_option("DB", *from, "the databases whose units are added")->required();
  return [into, from] { return merge(*into, *from); };
}

std::function<int()> define_campaign_export(CLI::App& app) {
  const auto database = std::make_shared<std::string>();
  const auto folder = std::make_shared<std::string>();
  app.add_option("DB", *database, "the database")->required();
  app.add_option("-o,--output", *folder, "the folder for the files")->required();
  return [database, folder] { return export_cases(*database, *folder); };
}

}  // namespace torse::cli
