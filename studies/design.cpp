#include "torse/studies/design.hpp"

#include <algorithm>
#include <cmath>

#include "torse/exact/rational/rational.hpp"
#include "torse/io/document.hpp"
#include "torse/io/text.hpp"
#include "torse/studies/built_in.hpp"
#include "torse/studies/routes.hpp"
#include "torse/studies/verdicts.hpp"

namespace torse::studies {
namespace {

constexpr int most_degree = 16;
constexpr int most_pieces = 64;
constexpr int most_repetitions = 100'000;
constexpr std::size_t most_combinations = 100'000;

std::vector<std::string> names_in(const Value& list, const std::vector<std::string>& known) {
  std::vector<std::string> names;
  for (const Value& item : list.items()) {
    const std::string& name = item.string();
    if (std::ranges::find(known, name) == known.end()) item.expected("a known name (torse study list names them)");
    if (std::ranges::find(names, name) != names.end()) {
      item.fail("expected each name once, found " + in_quotes(name) + " again");
    }
    names.push_back(name);
  }
  if (names.empty()) list.expected("at least one name");
  return names;
}

double level_of(const Value& item, Factor factor) {
  if (factor == Factor::degree) return item.integer(1, most_degree);
  if (factor == Factor::pieces) return item.integer(1, most_pieces);
  const double level = item.number<Rational>().to_double();
  const bool ratio = factor == Factor::knot_ratio || factor == Factor::weight_ratio;
  const bool zero = factor == Factor::gap || factor == Factor::offset || factor == Factor::moved;
  if (!(level >= (ratio ? 1.0 : zero ? 0.0 : 0x1p-60)) || level > 0x1p60) {
    item.expected(ratio ? "a number from 1 to 2^60" : "a number of at least 2^-60 (0 for gap, offset, moved) to 2^60");
  }
  return level;
}

std::vector<Variation> read_variations(const Value& factors) {
  factors.expect_keys(std::vector<std::string_view>(factor_names.begin(), factor_names.end()));
  std::vector<Variation> variations;
  int sides = 0;
  for (std::size_t i = 0; i < factor_names.size(); ++i) {
    const std::optional<Value> list = factors.find(factor_names[i]);
    if (!list) continue;
    const Factor factor = static_cast<Factor>(i);
    if (factor == Factor::before || factor == Factor::after || factor == Factor::inside) ++sides;
    Variation variation{factor, {}};
    for (const Value& item : list->items()) variation.levels.push_back(level_of(item, factor));
    if (variation.levels.empty()) list->expected("at least one level");
    variations.push_back(std::move(variation));
  }
  if (sides > 1) {
    factors.fail("expected one of before, after and inside, which are places of the same M*, found " +
                 std::to_string(sides));
  }
  return variations;
}

}  // namespace

std::size_t Design::combinations() const {
  std::size_t count = 1;
  for (const Variation& variation : variations) count *= variation.levels.size();
  return count;
}

std::size_t Design::cases(proofs::Effort effort) const {
  return combinations() * static_cast<std::size_t>(repetitions[static_cast<std::size_t>(effort)]);
}

Levels Design::levels(std::size_t combination) const {
  Levels levels;
  for (auto variation = variations.rbegin(); variation != variations.rend(); ++variation) {
    const std::size_t count = variation->levels.size();
    const Factor factor = variation->factor;
    if (factor == Factor::before || factor == Factor::inside) levels[Factor::after] = 0;
    levels[factor] = variation->levels[combination % count];
    combination /= count;
  }
  return levels;
}

Block Design::block(proofs::Effort effort, std::size_t index, std::size_t count) const {
  const std::size_t all = cases(effort);
  return {all * index / count, all * (index + 1) / count};
}

Design read_design(const std::string& file, const std::string& text) {
  const Document document(file, text);
  const Value root = document.root();
  root.expect_keys(
      {"torse", "type", "name", "title", "kind", "routes", "tests", "scalars", "factors", "repetitions", "seed"});
  static_cast<void>(root.at("torse").integer(1, 1));
  if (root.at("type").string() != "study") root.at("type").expected("\"study\"");
  Design design;
  design.text = text;
  design.name = root.at("name").string();
  design.title = root.at("title").string();
  const std::string& kind = root.at("kind").string();
  if (kind != "routes" && kind != "verdicts") root.at("kind").expected("\"routes\" or \"verdicts\"");
  design.verdicts = kind == "verdicts";
  design.subjects =
      design.verdicts ? names_in(root.at("tests"), verdict_names()) : names_in(root.at("routes"), route_names());
  if (!design.verdicts) design.scalars = names_in(root.at("scalars"), scalar_names());
  design.variations = read_variations(root.at("factors"));
  if (design.combinations() > most_combinations) {
    root.at("factors").fail("expected at most " + std::to_string(most_combinations) + " combinations, found " +
                            std::to_string(design.combinations()));
  }
  const Value repetitions = root.at("repetitions");
  repetitions.expect_keys({"quick", "standard", "deep"});
  design.repetitions = {repetitions.at("quick").integer(1, most_repetitions),
                        repetitions.at("standard").integer(1, most_repetitions),
                        repetitions.at("deep").integer(1, most_repetitions)};
  design.seed = static_cast<std::uint64_t>(root.at("seed").integer(0, 1'000'000'000));
  return design;
}

std::vector<std::string> design_names() {
  std::vector<std::string> names;
  for (const BuiltIn& design : built_in_designs()) names.emplace_back(design.name);
  return names;
}

Design built_in_design(const std::string& name) {
  for (const BuiltIn& design : built_in_designs()) {
    if (design.name == name) return read_design("studies/" + name + ".json", std::string(design.text));
  }
  throw Error("no study has the name " + name);
}

}  // namespace torse::studies
