// torse campaign diff: the units of two databases, one by one.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>

#include "torse/cli/campaign.hpp"
#include "torse/cli/command.hpp"
#include "torse/cli/json_report.hpp"
#include "torse/fuzz/campaign/compare.hpp"
#include "torse/io/text.hpp"

namespace torse::cli {
namespace {

using Json = nlohmann::ordered_json;
using fuzz::Difference;
using fuzz::Distribution;

/// A count that differs between the sums of A and B.
struct Shift {
  std::string label;  ///< "key=value"
  std::uint64_t a{};
  std::uint64_t b{};
};

void add_shifts(const Distribution& a, const Distribution& b, std::vector<Shift>& shifts) {
  std::set<std::pair<std::string, std::string>> labels;
  for (const Distribution* distribution : {&a, &b}) {
    for (const auto& [key, values] : distribution->counts()) {
      for (const auto& [value, count] : values) labels.emplace(key, value);
    }
  }
  for (const auto& [key, value] : labels) {
    const Shift shift{printable(key) + "=" + printable(value), a.count(key, value), b.count(key, value)};
    if (shift.a != shift.b) shifts.push_back(shift);
  }
}

std::vector<Shift> shifts_of(const Difference& difference) {
  const fuzz::Tally& a = difference.a;
  const fuzz::Tally& b = difference.b;
  std::vector<Shift> shifts;
  for (const Shift& shift : {Shift{"cases", a.cases, b.cases}, Shift{"failed", a.failed, b.failed},
                             Shift{"discarded", a.discarded, b.discarded}}) {
    if (shift.a != shift.b) shifts.push_back(shift);
  }
  add_shifts(a.labels, b.labels, shifts);
  add_shifts(a.discards, b.discards, shifts);
  return shifts;
}

void print_seeds(const Terminal& terminal, Paint paint, const char* what, const fuzz::SeedSet& seeds) {
  if (seeds.empty()) return;
  terminal.print(fmt::format("  {}: {} seeds: {}\n", terminal.painted(paint, what), seeds.count(), seeds.text()));
}

void print_difference(const Terminal& terminal, const Difference& difference) {
  terminal.print(fmt::format("{}, {} effort: {} seeds agree\n", printable(difference.series.property),
                             printable(difference.series.effort), difference.same));
  print_seeds(terminal, Paint::bad, "fails in B only", difference.broken);
  print_seeds(terminal, Paint::good, "fails in A only", difference.fixed);
  print_seeds(terminal, Paint::doubtful, "other cases, same verdict", difference.changed);
  print_seeds(terminal, Paint::dim, "only in A", difference.only_in_a);
  print_seeds(terminal, Paint::dim, "only in B", difference.only_in_b);
  for (const Shift& shift : shifts_of(difference)) {
    terminal.print(fmt::format("    {}: {} in A, {} in B\n", shift.label, shift.a, shift.b));
  }
}

Json seeds_json(const fuzz::SeedSet& seeds) {
  Json list = Json::array();
  for (const fuzz::Seeds& interval : seeds.intervals()) list.push_back({interval.first, interval.last});
  return list;
}

Json difference_json(const Difference& difference) {
  Json shifts = Json::object();
  for (const Shift& shift : shifts_of(difference)) shifts[shift.label] = {{"a", shift.a}, {"b", shift.b}};
  return {{"property", printable(difference.series.property)},
          {"effort", printable(difference.series.effort)},
          {"same", difference.same},
          {"broken", seeds_json(difference.broken)},
          {"fixed", seeds_json(difference.fixed)},
          {"changed", seeds_json(difference.changed)},
          {"only_in_a", seeds_json(difference.only_in_a)},
          {"only_in_b", seeds_json(difference.only_in_b)},
          {"shifts", shifts}};
}

int code_of(const std::vector<Difference>& differences) {
  if (std::ranges::any_of(differences, &Difference::verdicts_differ)) return exit_code::refuted;
  return std::ranges::all_of(differences, &Difference::equal) ? exit_code::success : exit_code::undecided;
}

std::string verdict(int code) {
  if (code == exit_code::success) return "equal";
  return code == exit_code::refuted ? "verdicts differ" : "no verdict differs, but they are not equal";
}

int diff(const std::string& a, const std::string& b, const std::string& json_file) {
  fuzz::Store store_a(a, fuzz::Database::Open::existing);
  fuzz::Store store_b(b, fuzz::Database::Open::existing);
  const std::vector<Difference> differences = fuzz::compare(store_a, store_b);
  const int code = code_of(differences);
  if (!json_file.empty()) {
    Json json{{"torse", 1},
              {"a", printable(a)},
              {"b", printable(b)},
              {"equal", code == exit_code::success},
              {"properties", Json::array()}};
    for (const Difference& difference : differences) json["properties"].push_back(difference_json(difference));
    write_json(json_file, json);
    if (json_file == "-") return code;
  }
  const Terminal terminal(stdout);
  for (const Difference& difference : differences) print_difference(terminal, difference);
  terminal.print(verdict(code) + "\n");
  return code;
}

}  // namespace

std::function<int()> define_campaign_diff(CLI::App& app) {
  const auto a = std::make_shared<std::string>();
  const auto b = std::make_shared<std::string>();
  const auto json = std::make_shared<std::string>();
  app.add_option("A", *a, "a database")->required();
  app.add_option("B", *b, "another one, the later")->required();
  app.add_option("--json", *json, "write the differences as JSON; - is standard output")->type_name("FILE");
  return [a, b, json] { return diff(*a, *b, *json); };
}

}  // namespace torse::cli
