// Reports of a campaign: for people, as JSON, for JUnit and SARIF.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "torse/cli/campaign.hpp"
#include "torse/fuzz/properties.hpp"
#include "torse/io/document.hpp"
#include "torse/io/file.hpp"
#include "torse/io/text.hpp"

namespace torse::cli {
namespace {

using Json = nlohmann::ordered_json;
using fuzz::Failure;

/// What a person is shown of a long list.
constexpr std::size_t values_shown = 12;
constexpr std::size_t failures_shown = 20;

/// "x 60 (60.0%), y 40 (40.0%)", the most frequent first. A case may have a label several times, or not at all.
std::string shares(const std::map<std::string, std::uint64_t>& counts) {
  std::uint64_t all = 0;
  for (const auto& [value, count] : counts) all += count;
  std::vector<std::pair<std::string, std::uint64_t>> list(counts.begin(), counts.end());
  std::ranges::stable_sort(list, std::greater(), &std::pair<std::string, std::uint64_t>::second);
  std::string text;
  for (std::size_t i = 0; i < list.size() && i < values_shown; ++i) {
    const double percent = all == 0 ? 0 : 100.0 * static_cast<double>(list[i].second) / static_cast<double>(all);
    text += fmt::format("{}{} {} ({:.1f}%)", i == 0 ? "" : ", ", printable(list[i].first), list[i].second, percent);
  }
  if (list.size() > values_shown) text += fmt::format(", and {} more", list.size() - values_shown);
  return text;
}

void print_distribution(const Terminal& terminal, const SeriesReport& report) {
  const fuzz::Tally& tally = report.tally;
  for (const auto& [key, values] : tally.labels.counts()) {
    terminal.print(fmt::format("  {:<22} {}\n", printable(key), shares(values)));
  }
  for (const auto& [key, values] : tally.discards.counts()) {
    terminal.print(fmt::format("  {:<22} {}\n", "discarded", shares(values)));
  }
}

/// The verdict on a series in one line.
std::string message_of(const SeriesReport& report) {
  if (report.tally.failed > 0) {
    const std::string first = report.failures.empty() ? ""
                                                      : fmt::format("; seed {}: {}", report.failures.front().saved.seed,
                                                                    printable(report.failures.front().saved.message));
    return fmt::format("{} of {} cases fail{}", report.tally.failed, report.tally.cases, first);
  }
  if (!report.vacuous.empty()) return "vacuous: " + report.vacuous;
  return fmt::format("{} cases of {} seeds hold", report.tally.cases - report.tally.discarded, report.units);
}

Json distribution_json(const fuzz::Distribution& distribution) {
  Json json = Json::object();
  for (const auto& [key, values] : distribution.counts()) {
    for (const auto& [value, count] : values) json[printable(key)][printable(value)] = count;
  }
  return json;
}

Json series_json(const SeriesReport& report) {
  const fuzz::Tally& tally = report.tally;
  return {{"property", printable(report.series.property)},
          {"effort", printable(report.series.effort)},
          {"seeds", report.units},
          {"cases", tally.cases},
          {"failed", tally.failed},
          {"discarded", tally.discarded},
          {"vacuous", report.vacuous.empty() ? Json(nullptr) : Json(report.vacuous)},
          {"seconds", report.seconds},
          {"cases_per_second", report.speed()},
          {"labels", distribution_json(tally.labels)},
          {"discards", distribution_json(tally.discards)}};
}

Json failure_json(const Failure& failure, const CaseFiles& files) {
  const std::string file = files.file(failure);
  return {{"property", printable(failure.series.property)},
          {"effort", printable(failure.series.effort)},
          {"seed", failure.saved.seed},
          {"case", failure.saved.index},
          {"message", printable(failure.saved.message)},
          {"file", file.empty() ? Json(nullptr) : Json(printable(file))},
          {"replay", files.replay(failure)}};
}

}  // namespace

std::string CaseFiles::path(const Failure& failure) const {
  constexpr std::string_view allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-";
  for (const std::string& name : {failure.series.property, failure.series.effort}) {
    if (name.find_first_not_of(allowed) == std::string::npos) continue;
    throw FileError(database, "expected the name of a property and an effort, found " + in_quotes(name));
  }
  const std::string name = fmt::format("{}-{}-{}-{}.json", failure.series.property, failure.series.effort,
                                       failure.saved.seed, failure.saved.index);
  return (std::filesystem::path(folder) / name).string();
}

std::string CaseFiles::file(const Failure& failure) const {
  if (written.empty()) return "";
  const std::string name = path(failure);
  return written.contains(name) ? name : "";
}

std::string CaseFiles::replay(const Failure& failure) const {
  const std::string name = file(failure);
  return "torse " + printable(command_line({"replay", file_word(name.empty() ? database : name)}));
}

SeriesReport series_report(fuzz::Store& store, const fuzz::Series& series, const fuzz::Seeds& seeds) {
  SeriesReport report;
  report.series = series;
  report.units = store.unit_count(series, seeds);
  const fuzz::UnitResult total = store.total(series, seeds);
  report.tally = total.tally;
  report.seconds = static_cast<double>(total.microseconds) / 1e6;
  const fuzz::Property* property = fuzz::find_property(series.property);
  if (property != nullptr) report.vacuous = fuzz::vacuity(*property, report.tally);
  report.failures = store.failures(series, seeds);
  return report;
}

void print_reports(const Terminal& terminal, const std::vector<SeriesReport>& reports) {
  terminal.print(
      terminal.painted(Paint::dim, fmt::format("{:<24} {:<9} {:>9} {:>12} {:>8} {:>10} {:>14}\n", "property", "effort",
                                               "seeds", "cases", "failed", "discarded", "cases/s core")));
  for (const SeriesReport& report : reports) {
    const fuzz::Tally& tally = report.tally;
    const std::string failed = fmt::format("{:>8}", tally.failed);
    terminal.print(fmt::format("{:<24} {:<9} {:>9} {:>12} {} {:>10} {:>14.0f}\n", printable(report.series.property),
                               printable(report.series.effort), report.units, tally.cases,
                               tally.failed == 0 ? failed : terminal.painted(Paint::bad, failed), tally.discarded,
                               report.speed()));
    print_distribution(terminal, report);
  }
}

void print_failures(const Terminal& terminal, const std::vector<SeriesReport>& reports, const CaseFiles& files) {
  std::size_t count = 0;
  for (const SeriesReport& report : reports) {
    if (!report.vacuous.empty()) {
      terminal.print(fmt::format("{} {}, {} effort: {}\n", terminal.painted(Paint::bad, "vacuous:"),
                                 printable(report.series.property), printable(report.series.effort), report.vacuous));
    }
    for (const Failure& failure : report.failures) {
      if (++count > failures_shown) continue;
      terminal.print(fmt::format("{} {}: {}\n", terminal.painted(Paint::bad, "failed:"),
                                 fuzz::unit_name(failure.series, failure.saved.seed),
                                 printable(failure.saved.message)));
      const std::string file = files.file(failure);
      if (!file.empty()) terminal.print("  case: " + printable(file) + "\n");
      terminal.print("  " + terminal.painted(Paint::dim, "replay: " + files.replay(failure)) + "\n");
    }
  }
  if (count > failures_shown) terminal.print(fmt::format("and {} failing cases more\n", count - failures_shown));
}

void add_reports(Json& json, const std::vector<SeriesReport>& reports, const CaseFiles& files) {
  json["properties"] = Json::array();
  json["failures"] = Json::array();
  for (const SeriesReport& report : reports) {
    json["properties"].push_back(series_json(report));
    for (const Failure& failure : report.failures) json["failures"].push_back(failure_json(failure, files));
  }
}

std::vector<ReportCase> cases_of(const std::vector<SeriesReport>& reports, const CaseFiles& files) {
  std::vector<ReportCase> cases;
  for (const SeriesReport& report : reports) {
    ReportCase c;
    c.suite = "campaign";
    c.name = report.series.property;
    c.outcome = report.failed() ? Outcome::failed : Outcome::passed;
    c.message = message_of(report);
    if (!report.failures.empty()) {
      c.replay = files.replay(report.failures.front());
      c.file = files.file(report.failures.front());
    }
    c.rule = report.series.property;
    if (const fuzz::Property* property = fuzz::find_property(report.series.property)) {
      c.rule_text = std::string(property->info().statement);
    }
    c.seconds = report.seconds;
    cases.push_back(std::move(c));
  }
  return cases;
}

void write_cases(const std::vector<SeriesReport>& reports, CaseFiles& files, std::size_t most) {
  for (const SeriesReport& report : reports) {
    for (const Failure& failure : report.failures) {
      if (files.written.size() == most) return;
      if (files.written.empty()) make_folder(files.folder);
      const std::string path = files.path(failure);
      write_file(path, failure.saved.text);
      files.written.insert(path);
    }
  }
}

}  // namespace torse::cli
