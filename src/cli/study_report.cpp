// torse study: CSV, the summary on a terminal, and the plot.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "torse/cli/study.hpp"
#include "torse/figures/svg.hpp"
#include "torse/proofs/report.hpp"

namespace torse::cli {
namespace {

using Json = nlohmann::ordered_json;
using studies::Factor;
using studies::Task;

std::string name_of(Factor factor) { return std::string(studies::factor_names[static_cast<std::size_t>(factor)]); }

/// A field with commas or quotes in quotes.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string field(const Json& value) {
  if (value.is_null()) return "";
  return value.is_string() ? field(value.get<std::string>()) : field(value.dump());
}

const std::vector<std::string>& route_columns() {
  static const std::vector<std::string> columns{"route",       "scalar",    "finite",   "ulps",     "units",
                                                "conditioned", "condition", "backward", "warp_deg", "bound"};
  return columns;
}

const std::vector<std::string>& test_columns() {
  static const std::vector<std::string> columns{"test", "says_developable", "wrong"};
  return columns;
}

std::optional<double> number(const Json& result, const char* key) {
  const auto found = result.find(key);
  return found == result.end() || found->is_null() ? std::nullopt : std::optional<double>(found->get<double>());
}

void add_number(Spread& spread, const Json& result, const char* key) {
  if (const std::optional<double> x = number(result, key)) spread.values.push_back(*x);
}

void add_route(StudySummary& summary, const Task& task, const Json& record, const Json& result) {
  const std::pair key(result["route"].get<std::string>(), result["scalar"].get<std::string>());
  if (!summary.routes.contains(key)) summary.order.push_back(key);
  RouteSummary& route = summary.routes[key];
  if (!result["finite"].get<bool>()) {
    ++route.failed;
    return;
  }
  add_number(route.ulps, result, "ulps");
  add_number(route.units, result, "units");
  add_number(route.conditioned, result, "conditioned");
  add_number(route.backward, result, "backward");
  add_number(route.warp, result, "warp_deg");
  add_number(route.bound, result, "bound");
  if (number(result, "bound").value_or(0) > 1) ++summary.above_bound;
  for (const studies::Variation& variation : task.design.variations) {
    const double level = record["factors"][name_of(variation.factor)].get<double>();
    add_number(summary.levels[{key.first, key.second, variation.factor, level}], result, "units");
  }
}

void count(TestSummary& test, bool developable, bool wrong) {
  ++test.cases;
  if (wrong) ++(developable ? test.false_no : test.false_yes);
}

void add_test(StudySummary& summary, const Task& task, const Json& record, const Json& result) {
  const std::string name = result["test"];
  const bool developable = record["developable"];
  const bool wrong = result["wrong"];
  count(summary.tests[name], developable, wrong);
  for (const studies::Variation& variation : task.design.variations) {
    const double level = record["factors"][name_of(variation.factor)].get<double>();
    count(summary.test_levels[{name, variation.factor, level}], developable, wrong);
  }
}

std::string shown(const Spread& spread, double (Spread::*of)() const) {
  return spread.values.empty() ? "-" : fmt::format("{:.3g}", (spread.*of)());
}

/// Levels as powers of two where they are.
std::string level_text(double level) {
  int exponent = 0;
  const bool power = level > 0 && std::frexp(level, &exponent) == 0.5;
  return power && (exponent < -2 || exponent > 11) ? fmt::format("2^{}", exponent - 1) : fmt::format("{:g}", level);
}

bool varies(const studies::Variation& variation) { return variation.levels.size() > 1; }

void print_levels(const Terminal& terminal, const Task& task, const StudySummary& summary) {
  for (const studies::Variation& variation : task.design.variations) {
    if (!varies(variation)) continue;
    std::string head = fmt::format("\nmedian error in u by {:<15}", name_of(variation.factor));
    for (const double level : variation.levels) head += fmt::format(" {:>9}", level_text(level));
    terminal.print(terminal.painted(Paint::dim, head + "\n"));
    for (const auto& [route, scalar] : summary.order) {
      std::string line = fmt::format("{:<26} {:<11}", route, scalar);
      for (const double level : variation.levels) {
        const auto found = summary.levels.find({route, scalar, variation.factor, level});
        line += fmt::format(" {:>9}", found == summary.levels.end() ? "-" : shown(found->second, &Spread::median));
      }
      terminal.print(line + "\n");
    }
  }
}

void print_tests(const Terminal& terminal, const Task& task, const StudySummary& summary) {
  terminal.print(terminal.painted(
      Paint::dim, fmt::format("{:<22} {:>7} {:>10} {:>9}\n", "test", "cases", "false yes", "false no")));
  for (const std::string& name : task.design.subjects) {
    const TestSummary& test = summary.tests.at(name);
    terminal.print(fmt::format("{:<22} {:>7} {:>10} {:>9}\n", name, test.cases, test.false_yes, test.false_no));
  }
  for (const studies::Variation& variation : task.design.variations) {
    if (!varies(variation)) continue;
    std::string head = fmt::format("\nwrong verdicts by {:<10}", name_of(variation.factor));
    for (const double level : variation.levels) head += fmt::format(" {:>9}", level_text(level));
    terminal.print(terminal.painted(Paint::dim, head + "\n"));
    for (const std::string& name : task.design.subjects) {
      std::string line = fmt::format("{:<28}", name);
      for (const double level : variation.levels) {
        const TestSummary& test = summary.test_levels.at({name, variation.factor, level});
        line += fmt::format(" {:>9}", fmt::format("{}/{}", test.false_yes + test.false_no, test.cases));
      }
      terminal.print(line + "\n");
    }
  }
}

void print_routes(const Terminal& terminal, const Task& task, const StudySummary& summary) {
  terminal.print(terminal.painted(
      Paint::dim,
      fmt::format("{:<26} {:<11} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>8} {:>6}\n", "route", "scalar", "ulps",
                  "max", "err/u", "max", "err/cond", "max", "backward", "max warp", "bound")));
  for (const auto& key : summary.order) {
    const RouteSummary& route = summary.routes.at(key);
    terminal.print(fmt::format("{:<26} {:<11} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>8} {:>6}{}\n", key.first,
                               key.second, shown(route.ulps, &Spread::median), shown(route.ulps, &Spread::most),
                               shown(route.units, &Spread::median), shown(route.units, &Spread::most),
                               shown(route.conditioned, &Spread::median), shown(route.conditioned, &Spread::most),
                               shown(route.backward, &Spread::median), shown(route.warp, &Spread::most),
                               shown(route.bound, &Spread::most),
                               route.failed > 0 ? fmt::format("  {} not finite", route.failed) : ""));
  }
  print_levels(terminal, task, summary);
}

}  // namespace

double Spread::median() const {
  std::vector<double> sorted = values;
  std::ranges::sort(sorted);
  return sorted.empty() ? 0 : sorted[(sorted.size() - 1) / 2];
}

double Spread::most() const { return values.empty() ? 0 : *std::ranges::max_element(values); }

std::string study_lines(const std::vector<std::string>& records) {
  std::string text;
  for (const std::string& record : records) text += record + "\n";
  return text;
}

std::string study_csv(const Task& task, const std::vector<std::string>& records) {
  const std::vector<std::string>& columns = task.design.verdicts ? test_columns() : route_columns();
  std::string text;
  if (task.shard == 0) {
    text = "study,case,repetition";
    for (const std::string_view factor : studies::factor_names) text += "," + std::string(factor);
    if (task.design.verdicts) text += ",developable";
    for (const std::string& column : columns) text += "," + column;
    text += task.design.verdicts ? ",input\n" : ",input,more\n";
  }
  for (const std::string& line : records) {
    const Json record = Json::parse(line);
    std::string head = field(record["study"]) + "," + record["case"].dump() + "," + record["repetition"].dump();
    for (const auto& [name, level] : record["factors"].items()) head += "," + level.dump();
    if (task.design.verdicts) head += "," + record["developable"].dump();
    std::string tail = "," + field(record["input"]);
    if (!task.design.verdicts) tail += "," + field(record["more"]);
    for (const Json& result : record["results"]) {
      text += head;
      for (const std::string& column : columns) text += "," + (result.contains(column) ? field(result[column]) : "");
      text += tail + "\n";
    }
  }
  return text;
}

StudySummary summary_of(const Task& task, const std::vector<std::string>& records) {
  StudySummary summary;
  for (const std::string& name : task.design.verdicts ? task.design.subjects : std::vector<std::string>()) {
    summary.tests[name] = {};
    for (const studies::Variation& variation : task.design.variations) {
      for (const double level : variation.levels) summary.test_levels[{name, variation.factor, level}] = {};
    }
  }
  for (const std::string& line : records) {
    const Json record = Json::parse(line);
    for (const Json& result : record["results"]) {
      if (task.design.verdicts) {
        add_test(summary, task, record, result);
      } else {
        add_route(summary, task, record, result);
      }
    }
  }
  return summary;
}

void print_study(const Terminal& terminal, const Task& task, const StudySummary& summary) {
  terminal.print(task.design.name + ": " + task.design.title + "\n");
  if (task.design.verdicts) {
    print_tests(terminal, task, summary);
  } else {
    print_routes(terminal, task, summary);
  }
  const studies::Block block = task.block();
  terminal.print(fmt::format("\n{} cases ({} effort, seed {})\n", block.end - block.begin,
                             proofs::effort_name(task.effort), task.seed));
  if (summary.above_bound > 0) {
    terminal.print(
        terminal.painted(Paint::bad, fmt::format("{} errors exceed the proved bound\n", summary.above_bound)));
  }
}

std::string study_svg(const Task& task, const StudySummary& summary) {
  static const std::vector<std::string> colours{"#1f77b4", "#ff7f0e", "#2ca02c", "#d62728", "#9467bd",
                                                "#8c564b", "#e377c2", "#7f7f7f", "#bcbd22", "#17becf"};
  constexpr double width = 520;
  constexpr double height = 320;
  constexpr double margin = 70;
  const auto by_double = std::ranges::find(summary.order, "double", &std::pair<std::string, std::string>::second);
  const bool has_double = by_double != summary.order.end();
  const std::string drawn = has_double || summary.order.empty() ? "double" : summary.order.front().second;
  std::string plots;
  double top = margin;
  for (const studies::Variation& variation : task.design.variations) {
    if (!varies(variation) || task.design.verdicts) continue;
    figures::SvgPlot plot(task.design.title, true);
    plot.axes(name_of(variation.factor) + " (levels in order)", "median error / u");
    std::size_t colour = 0;
    for (const auto& [route, scalar] : summary.order) {
      if (scalar != drawn) continue;
      figures::SvgLine line;
      for (std::size_t i = 0; i < variation.levels.size(); ++i) {
        const auto found = summary.levels.find({route, scalar, variation.factor, variation.levels[i]});
        if (found != summary.levels.end()) line.emplace_back(static_cast<double>(i), found->second.median());
      }
      plot.add(line, colours[colour++ % colours.size()], route + ", " + scalar);
    }
    plots += plot.text({margin, top, width, height});
    top += height + 2 * margin;
  }
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
      "{1:.0f}\">\n"
      " <style>text {{ font: 11px sans-serif }} .title {{ font-size: 14px }} polyline {{ fill: none; stroke-width: 1.5 "
      "}} .grid {{ stroke: #ddd }} .frame {{ fill: none; stroke: #888 }}</style>\n{2}</svg>\n",
      width + 2 * margin, top, plots);
}

}  // namespace torse::cli
