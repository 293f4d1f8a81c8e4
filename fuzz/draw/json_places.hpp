// Values of a JSON tree with their places, to choose one from.
//   Found            a value and its place
//   find_one, find_member, find_number      one that fits
//   last_key, member, entry                 of places
//   remove_key       a member of an object
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "torse/fuzz/draw/json.hpp"
#include "torse/fuzz/property.hpp"

namespace torse::fuzz {

/// A value of the tree with its place.
struct Found {
  JsonTree* tree;
  std::string place;
};

inline void collect(JsonTree& tree, const std::string& place, std::vector<Found>& found) {
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
inline std::string_view last_key(std::string_view place) {
  const std::size_t dot = place.rfind('.');
  return dot == std::string_view::npos ? place : place.substr(dot + 1);
}

inline Found find_member(Choices& choices, JsonTree& root, std::string_view key) {
  return find_one(choices, root, [&](const Found& x) { return last_key(x.place) == key; });
}

inline Found find_number(Choices& choices, JsonTree& root) {
  return find_one(choices, root, [](const Found& x) { return x.tree->kind == JsonTree::Kind::number; });
}

inline std::string member(const std::string& place, const std::string& key) {
  return place.empty() ? key : place + '.' + key;
}

inline std::string entry(const std::string& place, std::size_t i) { return place + '[' + std::to_string(i) + ']'; }

inline void remove_key(JsonTree& object, std::string_view key) {
  const auto at = std::ranges::find(object.keys, key);
  if (at == object.keys.end()) throw Discard("nothing to damage");
  object.items.erase(object.items.begin() + (at - object.keys.begin()));
  object.keys.erase(at);
}

}  // namespace torse::fuzz
