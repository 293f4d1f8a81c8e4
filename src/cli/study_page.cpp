// torse study: the summary as a page, plots over what the design varies and a table.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "torse/cli/study.hpp"
#include "torse/proofs/report.hpp"

namespace torse::cli {
namespace {

using Json = nlohmann::ordered_json;
using studies::Task;
using studies::Variation;

std::string name_of(const Variation& variation) {
  return std::string(studies::factor_names[static_cast<std::size_t>(variation.factor)]);
}

/// A logarithmic axis where levels are positive and spread over more than a factor of 10.
Json axis_of(const Variation& variation) {
  const auto [least, most] = std::ranges::minmax(variation.levels);
  return {{"label", name_of(variation)}, {"log", least > 0 && most > 10 * least}};
}

/// A point for each level; `value` is null where there is none.
template <class Value>
Json series_json(const std::string& name, const Variation& variation, Value value) {
  Json points = Json::array();
  for (const double level : variation.levels) {
    if (const std::optional<double> y = value(level)) points.push_back({level, *y});
  }
  return {{"name", name}, {"points", points}};
}

Json error_plot(const StudySummary& summary, const Variation& variation) {
  Json series = Json::array();
  for (const auto& [route, scalar] : summary.order) {
    series.push_back(series_json(route + ", " + scalar, variation, [&, key = std::pair(route, scalar)](double level) {
      const auto found = summary.levels.find({key.first, key.second, variation.factor, level});
      const bool none = found == summary.levels.end() || found->second.values.empty();
      return none ? std::nullopt : std::optional<double>(found->second.median());
    }));
  }
  return {{"title", "Median error in u by " + name_of(variation)},
          {"x", axis_of(variation)},
          {"y", {{"label", "error / u"}, {"log", true}}},
          {"series", series}};
}

Json verdict_plot(const Task& task, const StudySummary& summary, const Variation& variation) {
  Json series = Json::array();
  for (const std::string& name : task.design.subjects) {
    series.push_back(series_json(name, variation, [&](double level) {
      const TestSummary& test = summary.test_levels.at({name, variation.factor, level});
      const double wrong = static_cast<double>(test.false_yes + test.false_no);
      return test.cases == 0 ? std::nullopt : std::optional<double>(100 * wrong / static_cast<double>(test.cases));
    }));
  }
  return {{"title", "Wrong verdicts by " + name_of(variation)},
          {"x", axis_of(variation)},
          {"y", {{"label", "per cent"}, {"log", false}}},
          {"series", series}};
}

Json median_json(const Spread& spread) { return spread.values.empty() ? Json() : Json(spread.median()); }
Json most_json(const Spread& spread) { return spread.values.empty() ? Json() : Json(spread.most()); }

Json route_table(const StudySummary& summary) {
  Json rows = Json::array();
  for (const auto& key : summary.order) {
    const RouteSummary& route = summary.routes.at(key);
    rows.push_back({key.first, key.second, median_json(route.ulps), most_json(route.ulps), median_json(route.units),
                    most_json(route.units), median_json(route.conditioned), most_json(route.conditioned),
                    median_json(route.backward), most_json(route.warp), most_json(route.bound), route.failed});
  }
  return {{"title", "Errors of each route: medians and largest"},
          {"columns",
           {"Route", "Arithmetic", "Ulps", "Largest", "Error / u", "Largest", "Error / condition", "Largest",
            "Backward error", "Largest warp, degrees", "Largest share of the bound", "Not finite"}},
          {"rows", rows}};
}

Json test_table(const Task& task, const StudySummary& summary) {
  Json rows = Json::array();
  for (const std::string& name : task.design.subjects) {
    const TestSummary& test = summary.tests.at(name);
    rows.push_back({name, test.cases, test.false_yes, test.false_no});
  }
  return {{"title", "Naive tests beside the exact verdict"},
          {"columns", {"Test", "Cases", "Wrongly developable", "Wrongly not developable"}},
          {"rows", rows}};
}

}  // namespace

Json study_section(const Task& task, const StudySummary& summary) {
  Json plots = Json::array();
  for (const Variation& variation : task.design.variations) {
    if (variation.levels.size() < 2) continue;
    plots.push_back(task.design.verdicts ? verdict_plot(task, summary, variation) : error_plot(summary, variation));
  }
  const studies::Block block = task.block();
  const std::string cases = fmt::format(
      "{} cases, {} effort, seed {}. Errors are those of results in an arithmetic of "
      "unit roundoff u against exact results of the same inputs.",
      block.end - block.begin, proofs::effort_name(task.effort), task.seed);
  return {{"kind", "plots"},
          {"title", task.design.name + ": " + task.design.title},
          {"text", {cases}},
          {"plots", plots},
          {"tables", {task.design.verdicts ? test_table(task, summary) : route_table(summary)}}};
}

}  // namespace torse::cli
