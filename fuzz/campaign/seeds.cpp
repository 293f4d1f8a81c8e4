#include "torse/fuzz/campaign/seeds.hpp"

#include <charconv>
#include <optional>
#include <string_view>

#include "torse/io/text.hpp"
#include "torse/scalar/errors.hpp"

namespace torse::fuzz {
namespace {

constexpr std::size_t intervals_in_text = 10;

std::optional<std::uint64_t> seed_from(std::string_view text) {
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (error != std::errc() || end != text.data() + text.size() || seed > Seeds::most) return std::nullopt;
  return seed;
}

}  // namespace

std::string Seeds::text() const {
  if (first == last) return std::to_string(first);
  return std::to_string(first) + ".." + (endless() ? "" : std::to_string(last));
}

Seeds Seeds::from_text(const std::string& text) {
  const std::string_view whole(text);
  const std::size_t dots = whole.find("..");
  const auto first = seed_from(whole.substr(0, dots));
  std::optional<std::uint64_t> last = first;
  if (dots != std::string_view::npos) last = dots + 2 == whole.size() ? most : seed_from(whole.substr(dots + 2));
  if (!first || !last || *last < *first) {
    throw Error("expected A..B with A at most B, A.. without an end, or one seed; found " + in_quotes(text));
  }
  return {*first, *last};
}

void SeedSet::add(std::uint64_t seed) {
  if (!intervals_.empty() && intervals_.back().last + 1 == seed) {
    intervals_.back().last = seed;
  } else {
    intervals_.push_back({seed, seed});
  }
}

std::uint64_t SeedSet::count() const {
  std::uint64_t sum = 0;
  for (const Seeds& interval : intervals_) sum += interval.last - interval.first + 1;
  return sum;
}

std::string SeedSet::text() const {
  std::string text;
  for (std::size_t i = 0; i < intervals_.size() && i <= intervals_in_text; ++i) {
    text += (i == 0 ? "" : ", ") + (i == intervals_in_text ? "..." : intervals_[i].text());
  }
  return text;
}

}  // namespace torse::fuzz
