// A damage changes the tree before it is written, or the text afterwards. Each knows the place of the error because it
// is the only thing that is wrong. One that does not apply to a file (no weights, no knots) makes no case.
#include "torse/fuzz/draw/damage.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "torse/fuzz/draw/numbers.hpp"
#include "torse/fuzz/draw/spelling.hpp"
#include "torse/fuzz/property.hpp"

namespace torse::fuzz {
namespace {

/// A value of the tree with its place.
struct Found {
  JsonTree* tree;
  std::string place;
};

void collect(JsonTree& tree, const std::string& place, std::vector<Found>& found) {
  found.push_back({&tree, place});
  for (std::size_t i = 0; i < tree.items.size(); ++i) {
    const bool array = tree.kind == JsonTree::Kind::array;
    collect(tree.items[i],
            array           ? place + '[' + std::to_string(i) + ']'
            : place.empty() ? tree.keys[i]
                            : place + '.' + tree.keys[i],
            found);
  }
}

/// Draws one of the values that `accepts`.
template <class Predicate>
Found find_one(Choices& choices, JsonTree& root, const Predicate& accepts) {
  std::vector<Found> found;
  collect(root, "", found);
  std::erase_if(found, [&](const Found& x) { return !accepts(x); });
  if (found.empty()) throw Discard("nothing to damage");
  return found[choices.below(found.size())];
}

/// The last key of a place without indices.
std::string_view last_key(std::string_view place) {
  const std::size_t dot = place.rfind('.');
  return dot == std::string_view::npos ? place : place.substr(dot + 1);
}

Found find_member(Choices& choices, JsonTree& root, std::string_view key) {
  return find_one(choices, root, [&](const Found& x) { return last_key(x.place) == key; });
}

Found find_number(Choices& choices, JsonTree& root) {
  return find_one(choices, root, [](const Found& x) { return x.tree->kind == JsonTree::Kind::number; });
}

std::string member(const std::string& place, const std::string& key) { return place.empty() ? key : place + '.' + key; }

std::string entry(const std::string& place, std::size_t i) { return place + '[' + std::to_string(i) + ']'; }

void remove_key(JsonTree& object, std::string_view key) {
  const auto at = std::ranges::find(object.keys, key);
  if (at == object.keys.end()) throw Discard("nothing to damage");
  object.items.erase(object.items.begin() + (at - object.keys.begin()));
  object.keys.erase(at);
}

/// The knot list of a curve and whether it is a CAD list.
struct FoundKnots {
  Found list;
  const SplineMeant* meant;
  std::size_t outer;
};

FoundKnots find_knots(Choices& choices, DrawnFile& file) {
  const Found list = find_member(choices, file.tree, "knots");
  const SplineMeant& meant = list.place == "d.knots" ? file.meant.d : file.meant.c;
  return {list, &meant, (list.tree->items.size() - meant.knots.size()) / 2};
}

// Each damage of a tree returns the place of the error.

std::string version(Choices& choices, DrawnFile& file) {
  *file.tree.find("torse") =
      json_literal(choices.pick<const char*>({"2", "0", "\"1\"", "1.0", "1e0", "-1", "null", "[1]"}));
  return "torse";
}

std::string type(Choices& choices, DrawnFile& file) {
  JsonTree& type = *file.tree.find("type");
  type = choices.once_in(2) ? json_literal(choices.pick<const char*>({"7", "null", "[\"ruled\"]"}))
                            : json_string(choices.pick<const char*>({"surface", "", "Ruled", "case", "ruled "}));
  return "type";
}

std::string missing_key(Choices& choices, DrawnFile& file) {
  const Found object = find_one(choices, file.tree, [](const Found& x) {
    return x.tree->kind == JsonTree::Kind::object && !x.tree->keys.empty();
  });
  const std::string key = object.tree->keys[choices.below(object.tree->keys.size())];
  const bool optional = key == "knots" || key == "weights" ||
                        (file.meant.method == "cylinder" && (key == "M" || key == "Lambda")) ||
                        (file.meant.method == "directrix" && (key == "d0" || key == "v"));
  if (optional) throw Discard("a key that may be missing");
  remove_key(*object.tree, key);
  return object.place;
}

std::string unknown_key(Choices& choices, DrawnFile& file) {
  const Found object =
      find_one(choices, file.tree, [](const Found& x) { return x.tree->kind == JsonTree::Kind::object; });
  const char* key = choices.pick<const char*>({"colour", "Knots", "weight", "comment", "x y", "lambda"});
  object.tree->add(key, json_literal(choices.pick<const char*>({"1", "null", "[]", "{}"})));
  return member(object.place, key);
}

std::string wrong_type(Choices& choices, DrawnFile& file) {
  const Found value = find_one(choices, file.tree, [](const Found& x) {
    return x.tree->kind != JsonTree::Kind::literal && !x.place.empty() && x.place != "type";
  });
  const bool leaf = value.tree->kind == JsonTree::Kind::number || value.tree->kind == JsonTree::Kind::string;
  *value.tree = json_literal(leaf ? choices.pick<const char*>({"null", "true", "false", "[]", "{}", "[1]"})
                                  : choices.pick<const char*>({"null", "7", "\"1\"", "false"}));
  return value.place;
}

std::string wrong_degree(Choices& choices, DrawnFile& file) {
  const Found degree = find_member(choices, file.tree, "degree");
  *degree.tree = json_literal(choices.pick<const char*>(
      {"0", "101", "-1", "1.5", "2.0", "1e0", "\"2\"", "null", "99999999999999999999", "4294967297", "[2]"}));
  return degree.place;
}

std::string bad_number(Choices& choices, DrawnFile& file) {
  const Found number = find_number(choices, file.tree);
  *number.tree = json_string(draw_bad_spelling(choices).text);
  return number.place;
}

std::string zero_weight(Choices& choices, DrawnFile& file) {
  const Found weight =
      find_one(choices, file.tree, [](const Found& x) { return last_key(x.place).starts_with("weights["); });
  *weight.tree = json_number(choices.pick<const char*>({"0", "-0", "0/5", "0.000", "0e9", "0x0p1", "+0"}));
  return weight.place;
}

std::string weight_count(Choices& choices, DrawnFile& file) {
  const Found weights = find_member(choices, file.tree, "weights");
  if (choices.once_in(2)) {
    weights.tree->items.pop_back();
  } else {
    weights.tree->items.push_back(json_literal("1"));
  }
  return weights.place;
}

std::string coordinate_count(Choices& choices, DrawnFile& file) {
  const Found point = find_one(choices, file.tree, [](const Found& x) {
    const std::string_view key = last_key(x.place);
    return key.starts_with("points[") && x.tree->kind == JsonTree::Kind::array;
  });
  if (choices.once_in(2)) {
    point.tree->items.pop_back();
  } else {
    point.tree->items.push_back(json_literal("1"));
  }
  return point.place;
}

/// One point too few: the points of one row of a ruled surface, a curve with a point less than its degree asks for.
std::string point_count(Choices& choices, DrawnFile& file) {
  const Found points = find_member(choices, file.tree, "points");
  const SplineMeant& meant = points.place.starts_with('d') ? file.meant.d : file.meant.c;
  const bool row = file.meant.type == "ruled";
  if (!row && points.tree->items.size() != static_cast<std::size_t>(meant.degree) + 1) throw Discard("points to spare");
  points.tree->items.pop_back();
  JsonTree& owner = points.place == "points" ? file.tree : *file.tree.find(points.place.substr(0, 1));
  if (!row && owner.find("weights") != nullptr) remove_key(owner, "weights");
  return row ? "d.points" : points.place;
}

std::string knot_count(Choices& choices, DrawnFile& file) {
  const FoundKnots knots = find_knots(choices, file);
  std::vector<JsonTree>& items = knots.list.tree->items;
  if (choices.once_in(2)) {
    items.push_back(items.back());
  } else {
    items.pop_back();
  }
  return knots.list.place;
}

std::string knot_decreasing(Choices& choices, DrawnFile& file) {
  const FoundKnots knots = find_knots(choices, file);
  std::vector<JsonTree>& items = knots.list.tree->items;
  const std::size_t i = 1 + choices.below(items.size() - 1);
  const std::size_t before = i - 1;
  const Rational lower = knots.meant->knots[before < knots.outer ? 0 : before - knots.outer] - Rational(1);
  if (before < knots.outer) items[before] = json_number(knots.meant->knots.front().text());
  items[i] = json_number(spelled(choices, lower));
  return entry(knots.list.place, i);
}

/// n + 1 equal knots: the first of n + 1 neighbours and all between take the value of the last.
std::string knot_multiplicity(Choices& choices, DrawnFile& file) {
  const FoundKnots knots = find_knots(choices, file);
  const auto n = static_cast<std::size_t>(knots.meant->degree);
  const std::size_t first = choices.below(knots.meant->knots.size() - n);
  for (std::size_t i = first; i < first + n; ++i) {
    knots.list.tree->items[i + knots.outer] = json_number(spelled(choices, knots.meant->knots[first + n]));
  }
  return entry(knots.list.place, first + n + knots.outer);
}

// Damages of "construct" alone. One that does not apply returns no place.

using Place = std::optional<std::string>;

Place unknown_method(Choices& choices, JsonTree& root) {
  *root.find("method") = json_string(choices.pick<const char*>({"spline", "Cone", "", "bspline "}));
  return "method";
}

Place zero_factor(Choices& choices, JsonTree& root) {
  const char* key = choices.pick<const char*>({"sigma", "omega0"});
  JsonTree* value = root.find(key);
  if (value == nullptr) return std::nullopt;
  *value = json_number(choices.pick<const char*>({"0", "0/3", "-0"}));
  return key;
}

Place polynomial_size(Choices& choices, JsonTree& root) {
  const char* key = choices.pick<const char*>({"a", "b"});
  JsonTree* polynomial = root.find(key);
  if (polynomial == nullptr) return std::nullopt;
  polynomial->items.assign(choices.once_in(2) ? 102 : 0, json_literal("1"));
  return key;
}

Place key_of_another_method(Choices& choices, JsonTree& root) {
  const char* key = choices.pick<const char*>({"Lambda", "M", "sigma", "d0", "omega0", "va", "vb", "a", "b", "v"});
  const std::string& method = root.find("method")->text;
  if (root.find(key) != nullptr || method == "cylinder" || method == "directrix") return std::nullopt;
  root.add(key, json_literal("1"));
  return key;
}

Place weights_of_a_polynomial_method(Choices& choices, JsonTree& root) {
  const std::string& method = root.find("method")->text;
  if (method == "rational" || method == "cylinder" || method == "cone") return std::nullopt;
  JsonTree* c = root.find("c");
  if (c->find("weights") == nullptr) return std::nullopt;
  std::vector<JsonTree>& weights = c->find("weights")->items;
  weights[choices.below(weights.size())] = json_literal(choices.pick<const char*>({"2", "-1", "0.5"}));
  return "c.weights";
}

std::string construction(Choices& choices, DrawnFile& file) {
  constexpr std::array damages{unknown_method, zero_factor, polynomial_size, key_of_another_method,
                               weights_of_a_polynomial_method};
  const Place place = damages[choices.below(damages.size())](choices, file.tree);
  if (!place) throw Discard("nothing to damage");
  return *place;
}

/// A damage of the tree.
struct TreeDamage {
  const char* name;
  std::string (*damage)(Choices&, DrawnFile&);
};

constexpr std::array<TreeDamage, 14> tree_damages{{
    {"version", version},
    {"type", type},
    {"missing key", missing_key},
    {"unknown key", unknown_key},
    {"wrong type", wrong_type},
    {"degree", wrong_degree},
    {"bad number", bad_number},
    {"weight zero", zero_weight},
    {"weight count", weight_count},
    {"coordinate count", coordinate_count},
    {"point count", point_count},
    {"knot count", knot_count},
    {"knot decreasing", knot_decreasing},
    {"knot multiplicity", knot_multiplicity},
}};

// Damages of syntax: the text, and where the parser stops if that is known.

using Damaged = std::pair<std::string, std::optional<std::size_t>>;

/// A number becomes something that is no JSON.
Damaged literal(Choices& choices, DrawnFile& file) {
  const Found number = find_number(choices, file.tree);
  *number.tree = json_literal(choices.pick<const char*>(
      {"NaN", "Infinity", "-Infinity", "nan", "01", "+1", ".5", "1.", "0x10", "1/2", "'1'", "1e", "--1", "undefined"}));
  return {write_json(choices, file.tree).text, std::nullopt};
}

Damaged duplicate_key(Choices& choices, DrawnFile& file) {
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
Damaged cut(Choices& choices, DrawnFile& file) {
  std::string text = write_json(choices, file.tree).text;
  const std::size_t end = text.rfind('}');
  const std::size_t size = choices.below(end + 1);
  text.resize(size);
  return {text, std::nullopt};
}

Damaged trailing(Choices& choices, DrawnFile& file) {
  std::string text = write_json(choices, file.tree).text;
  const std::size_t size = text.size();
  if (choices.once_in(2)) return {text + choices.pick<const char*>({"1", "null", "\"a\"", "/* */"}), std::nullopt};
  return {text + choices.pick<const char*>({"x", "}", "{}", ",", "]"}), size};
}

/// A bracket, comma or colon is left out or becomes another one.
Damaged punctuation(Choices& choices, DrawnFile& file) {
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
Damaged string_bytes(Choices& choices, DrawnFile& file) {
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
Damaged depth(Choices& choices, DrawnFile& file) {
  const Found number = find_number(choices, file.tree);
  const std::string& place = number.place;
  // Each step of the place is one level below the object of the file.
  const auto steps = static_cast<int>(std::ranges::count(place, '.') + std::ranges::count(place, '['));
  const auto levels = static_cast<std::size_t>(31 - steps + choices.pick({0, 0, 1, 30}));
  *number.tree = json_literal(std::string(levels + 1, '[') + std::string(levels + 1, ']'));
  return {write_json(choices, file.tree).text, std::nullopt};
}

/// A damage of the syntax.
struct TextDamage {
  const char* name;
  Damaged (*damage)(Choices&, DrawnFile&);
};

constexpr std::array<TextDamage, 7> text_damages{{
    {"literal", literal},
    {"duplicate key", duplicate_key},
    {"cut", cut},
    {"trailing", trailing},
    {"punctuation", punctuation},
    {"string bytes", string_bytes},
    {"depth", depth},
}};

DamagedFile damaged_tree(Choices& choices, DrawnFile file, const TreeDamage& damage) {
  const std::string place = damage.damage(choices, file);
  const WrittenJson written = write_json(choices, file.tree);
  DamagedFile damaged{file.meant.type, damage.name, written.text, place, LineColumn{0, 0}};
  if (!place.empty()) damaged.at = line_column(written.text, written.values.at(place));
  return damaged;
}

DamagedFile damaged_text(Choices& choices, DrawnFile file, const TextDamage& damage) {
  auto [text, offset] = damage.damage(choices, file);
  DamagedFile damaged{file.meant.type, damage.name, std::move(text), "", std::nullopt};
  if (offset) damaged.at = line_column(damaged.text, *offset);
  return damaged;
}

}  // namespace

DamagedFile draw_damaged_file(Choices& choices, const Scale& scale, Labels& labels) {
  DrawnFile file = draw_file(choices, scale, labels);
  const std::size_t own = file.meant.type == "construct" ? 4 : 0;
  const std::size_t kind = choices.below(tree_damages.size() + text_damages.size() + own);
  DamagedFile damaged = kind < tree_damages.size() ? damaged_tree(choices, std::move(file), tree_damages[kind])
                        : kind < tree_damages.size() + text_damages.size()
                            ? damaged_text(choices, std::move(file), text_damages[kind - tree_damages.size()])
                            : damaged_tree(choices, std::move(file), {"construction", construction});
  labels.add("damage", damaged.damage);
  return damaged;
}

std::string scrambled(Choices& choices, std::string text) {
  constexpr std::string_view likely = "0123456789-+.eE/xX\"[]{}:, \n\\ntruefalse";
  const bool numbers = choices.below(2) == 0;
  for (int left = choices.between(1, 8); left > 0 && !text.empty(); --left) {
    std::size_t at = choices.below(text.size());
    if (numbers) at = std::min(text.find_first_of("0123456789", at), text.size() - 1);
    const std::size_t run = std::min<std::size_t>(1 + choices.below(12), text.size() - at);
    switch (choices.below(numbers ? 2 : 7)) {
      case 0:
        text[at] = static_cast<char>('0' + choices.below(10));
        break;
      case 1:
        text.erase(at, 1);
        break;
      case 2:
        text.erase(at, run);
        break;
      case 3:
        text[at] = likely[choices.below(likely.size())];
        break;
      case 4:
        text[at] = static_cast<char>(choices.below(256));
        break;
      case 5:
        text.insert(at, 1, likely[choices.below(likely.size())]);
        break;
      default:
        text.insert(choices.below(text.size()), text.substr(at, run));
    }
  }
  return text;
}

}  // namespace torse::fuzz
