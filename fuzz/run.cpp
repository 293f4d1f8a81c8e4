#include "torse/fuzz/run.hpp"

#include <utility>

#include "torse/fuzz/properties.hpp"
#include "torse/io/spline_file.hpp"

namespace torse::fuzz {
namespace {

/// The share of discarded cases above which a run proves nothing: one in two.
constexpr std::uint64_t discards_at_most = 2;
/// Seeds whose cases suffice to meet every label that must be met.
constexpr std::uint64_t seeds_to_judge = 20;

bool fails(const Property& property, const Scale& scale, Choices& choices) {
  return property.run(choices, scale).result == CaseResult::failed;
}

SavedCase saved(const Property& property, const Scale& scale, std::uint64_t seed, int index, const Record& record) {
  const Record small = shrink(property, scale, record);
  Choices run = Choices::from_record(small);
  Choices write = Choices::from_record(small);
  return {seed, index, property.run(run, scale).message, case_file(property, property.input_text(write, scale))};
}

}  // namespace

void Tally::add(const Tally& other) {
  cases += other.cases;
  failed += other.failed;
  discarded += other.discarded;
  labels.add(other.labels);
  discards.add(other.discards);
  failures.insert(failures.end(), other.failures.begin(), other.failures.end());
}

Choices draw_case(const Property& property, std::uint64_t seed, int index) {
  return Choices::from_seed(proofs::seed_of(seed, property.info().name, static_cast<std::uint64_t>(index)));
}

Tally run_seed(const Property& property, proofs::Effort effort, std::uint64_t seed) {
  const Scale scale = scale_of(effort);
  Tally tally;
  for (int index = 0; index < property.info().batch; ++index) {
    Choices choices = draw_case(property, seed, index);
    const CaseReport report = property.run(choices, scale);
    ++tally.cases;
    if (report.result == CaseResult::discarded) {
      ++tally.discarded;
      tally.discards.add("reason", report.message, 1);
      continue;
    }
    tally.labels.add(report.labels);
    if (report.result == CaseResult::held) continue;
    ++tally.failed;
    if (tally.failures.empty()) tally.failures.push_back(saved(property, scale, seed, index, choices.record()));
  }
  return tally;
}

Record shrink(const Property& property, const Scale& scale, Record failing, int runs) {
  failing = trimmed(std::move(failing));
  bool smaller = true;
  while (smaller) {
    smaller = false;
    for (const Edit& edit : edits(failing)) {
      if (runs-- == 0) return failing;
      Choices choices = Choices::from_record(edited(failing, edit));
      if (!fails(property, scale, choices)) continue;
      Record next = trimmed(choices.record());
      if (!simpler(next, failing)) continue;
      failing = std::move(next);
      smaller = true;
      break;
    }
  }
  return failing;
}

namespace {

/// A label "key=value".
std::pair<std::string, std::string> split(std::string_view label) {
  const std::size_t sign = label.find('=');
  return {std::string(label.substr(0, sign)), std::string(label.substr(sign + 1))};
}

/// The labels for which `holds` is false, after a heading; empty for none.
template <class Predicate>
std::string failing(const std::vector<std::string_view>& labels, const std::string& heading, const Predicate& holds) {
  std::string list;
  for (const std::string_view label : labels) {
    const auto [key, value] = split(label);
    if (!holds(key, value)) list += (list.empty() ? heading : ", ") + std::string(label);
  }
  return list;
}

}  // namespace

std::string vacuity(const Property& property, const Tally& tally) {
  if (tally.cases < static_cast<std::uint64_t>(property.info().batch) * seeds_to_judge) return {};
  if (tally.discarded * discards_at_most > tally.cases) {
    return std::to_string(tally.discarded) + " of " + std::to_string(tally.cases) + " cases were discarded";
  }
  const PropertyInfo& info = property.info();
  const std::string missing = failing(info.must_meet, "never met: ", [&](const auto& key, const auto& value) {
    return tally.labels.count(key, value) > 0;
  });
  if (!missing.empty()) return missing;
  return failing(info.mostly, "in fewer than half of the cases: ", [&](const auto& key, const auto& value) {
    return tally.labels.count(key, value) * 2 >= tally.labels.count(key);
  });
}

std::string case_file(const Property& property, const std::string& input) {
  return "{\"torse\": 1, \"type\": \"case\", \"property\": \"" + std::string(property.info().name) +
         "\",\n \"input\": " + input + "}\n";
}

CaseReport replay_case(const Document& document) {
  require_type(document, "case");
  const Value root = document.root();
  root.expect_keys({"torse", "type", "property", "input"});
  const Property* property = find_property(root.at("property").string());
  if (property == nullptr) root.at("property").expected("the name of a property");
  return property->replay(root.at("input"));
}

}  // namespace torse::fuzz
