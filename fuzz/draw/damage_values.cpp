// Damages of keys, types, counts and ranges.
#include <array>

#include "torse/fuzz/draw/damages.hpp"
#include "torse/fuzz/draw/json_places.hpp"
#include "torse/fuzz/draw/numbers.hpp"
#include "torse/fuzz/draw/spelling.hpp"

namespace torse::fuzz {
namespace {

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

constexpr std::array<TreeDamage, 14> damages{{
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

}  // namespace

std::span<const TreeDamage> value_damages() { return damages; }

}  // namespace torse::fuzz
