// Damages of syntax.
#include <array>

#include "torse/fuzz/draw/damages.hpp"
#include "torse/fuzz/draw/json_places.hpp"

namespace torse::fuzz {
namespace {

/// A number becomes something that is no JSON.
DamagedText literal(Choices& choices, DrawnFile& file) {
  const Found number = find_number(choices, file.tree);
  *number.tree = json_literal(choices.pick<const char*>(
      {"NaN", "Infinity", "-Infinity", "nan", "01", "+1", ".5", "1.", "0x10", "1/2", "'1'", "1e", "--1", "undefined"}));
  return {write_json(choices, file.tree).text, std::nullopt};
}

DamagedText duplicate_key(Choices& choices, DrawnFile& file) {
  const Found object = find_one(choices, file.tree, [](const Found& x) {
    return x.tree->kind == JsonTree::Kind::object && !x.tree->keys.empty();
  });
  const std::size_t i = choices.below(object.tree->keys.size());
  const std::string key = object.tree->keys[i];
  object.tree->add(key, JsonTree(object.tree->items[i]));
  const WrittenJson written = write_json(choices, file.tree);
  return {written.text, written.keys.at(member(object.place, key))};
}

/// The beginning of a text.
DamagedText cut(Choices& choices, DrawnFile& file) {
  std::string text = write_json(choices, file.tree).text;
  const std::size_t end = text.rfind('}');
  const std::size_t size = choices.below(end + 1);
  text.resize(size);
  return {text, std::nullopt};
}

DamagedText trailing(Choices& choices, DrawnFile& file) {
  std::string text = write_json(choices, file.tree).text;
  const std::size_t size = text.size();
  if (choices.once_in(2)) return {text + choices.pick<const char*>({"1", "null", "\"a\"", "/* */"}), std::nullopt};
  return {text + choices.pick<const char*>({"x", "}", "{}", ",", "]"}), size};
}

/// A bracket, comma or colon is left out or becomes another one.
DamagedText punctuation(Choices& choices, DrawnFile& file) {
  std::string text = write_json(choices, file.tree).text;
  std::vector<std::size_t> marks;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') quoted = !quoted;
    if (!quoted && std::string_view("[]{}:,").find(text[i]) != std::string_view::npos) marks.push_back(i);
  }
  const std::size_t at = marks[choices.below(marks.size())];
  const char* other = choices.pick<const char*>({" ", "[", "]", "{", "}", ":", ",", ";"});
  if (*other == text[at]) throw Discard("the same mark");
  text[at] = *other;
  return {text, std::nullopt};
}

/// Bytes that no string may hold: ill-formed UTF-8, control characters, escapes that are none.
DamagedText string_bytes(Choices& choices, DrawnFile& file) {
  std::string text = write_json(choices, file.tree).text;
  std::vector<std::size_t> quotes;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') quotes.push_back(i);
  }
  const std::size_t pair = 2 * choices.below(quotes.size() / 2);
  constexpr std::array<std::string_view, 13> bad{
      "\xff", "\x80", "\xc3", "\xe2\x82", "\xc0\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80",
      "\n",   "\x01", "\\q",  "\\u1g",    "\\uD800",  "\\uDC00"};
  text.insert(quotes[pair] + 1, bad[choices.below(bad.size())]);
  return {text, std::nullopt};
}

/// One array inside another one too many for the format, or many.
DamagedText depth(Choices& choices, DrawnFile& file) {
  const Found number = find_number(choices, file.tree);
  const std::string& place = number.place;
  // Each step of the place is one level below the object of the file.
  const auto steps = static_cast<int>(std::ranges::count(place, '.') + std::ranges::count(place, '['));
  const auto levels = static_cast<std::size_t>(31 - steps + choices.pick({0, 0, 1, 30}));
  *number.tree = json_literal(std::string(levels + 1, '[') + std::string(levels + 1, ']'));
  return {write_json(choices, file.tree).text, std::nullopt};
}

constexpr std::array<TextDamage, 7> damages{{
    {"literal", literal},
    {"duplicate key", duplicate_key},
    {"cut", cut},
    {"trailing", trailing},
    {"punctuation", punctuation},
    {"string bytes", string_bytes},
    {"depth", depth},
}};

}  // namespace

std::span<const TextDamage> syntax_damages() { return damages; }

}  // namespace torse::fuzz
