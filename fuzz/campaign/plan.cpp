#include "torse/fuzz/campaign/plan.hpp"

#include <charconv>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "torse/io/file.hpp"
#include "torse/io/text.hpp"
#include "torse/proofs/report.hpp"

namespace torse::fuzz {
namespace {

/// The number in a variable; none where it is not set. Throws Error.
std::optional<std::uint64_t> variable(const char* name) {
  const char* const value = std::getenv(name);
  if (value == nullptr) return std::nullopt;
  const std::string_view text(value);
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw Error(std::string(name) + ": expected a number, found " + in_quotes(text));
  }
  return number;
}

}  // namespace

Series Plan::series(std::size_t property) const {
  return {std::string(properties[property]->info().name), std::string(proofs::effort_name(effort))};
}

std::size_t Plan::place(const Series& series) const {
  std::size_t place = 0;
  while (properties[place]->info().name != series.property) ++place;
  return place;
}

std::string Plan::text() const {
  std::string text(proofs::effort_name(effort));
  for (const Property* property : properties) {
    text += " " + std::string(property->info().name) + ":" + std::to_string(property->info().batch);
  }
  return text;
}

std::string unit_name(const Series& series, std::uint64_t seed) {
  return printable(series.property) + ", seed " + std::to_string(seed) + ", " + printable(series.effort) + " effort";
}

Shard shard_of_environment() {
  if (const char* file = std::getenv("GTEST_SHARD_STATUS_FILE"); file != nullptr && *file != '\0') write_file(file, "");
  const auto total = variable("GTEST_TOTAL_SHARDS");
  const auto index = variable("GTEST_SHARD_INDEX");
  if (!total && !index) return {};
  if (!total || !index) throw Error("GTEST_TOTAL_SHARDS and GTEST_SHARD_INDEX: expected both or neither");
  if (*index >= *total) {
    throw Error("GTEST_SHARD_INDEX: expected a number below GTEST_TOTAL_SHARDS, found " + std::to_string(*index) +
                " of " + std::to_string(*total));
  }
  return {*index, *total};
}

}  // namespace torse::fuzz
