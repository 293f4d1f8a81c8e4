// JSON as text in every layout: blanks, escapes, order of keys.
//   JsonTree         what is to be written        json_string, json_number, json_array    its leaves and lists
//   WrittenJson      the text, and where each value and key of it stands       write_json
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "torse/fuzz/choices.hpp"

namespace torse::fuzz {

/// A JSON value. Members of an object are written in any order.
struct JsonTree {
  /// A literal is written as it is; a number with or without quotes, as its spelling allows; a string with quotes.
  enum class Kind { literal, number, string, array, object };

  Kind kind = Kind::object;
  std::string text{};
  std::vector<std::string> keys{};
  std::vector<JsonTree> items{};

  /// Appends a member to an object.
  JsonTree& add(std::string key, JsonTree value) {
    keys.push_back(std::move(key));
    items.push_back(std::move(value));
    return *this;
  }
  /// The member of an object; null if there is none.
  JsonTree* find(std::string_view key);
};

inline JsonTree json_literal(std::string text) { return {JsonTree::Kind::literal, std::move(text)}; }
inline JsonTree json_number(std::string spelling) { return {JsonTree::Kind::number, std::move(spelling)}; }
inline JsonTree json_string(std::string text) { return {JsonTree::Kind::string, std::move(text)}; }
inline JsonTree json_array(std::vector<JsonTree> items) { return {JsonTree::Kind::array, "", {}, std::move(items)}; }

/// A text with the offsets of all its values and keys, by places such as "c.points[3][1]", "" for the whole. A key that
/// occurs twice has the offset of the second one in the text.
struct WrittenJson {
  std::string text;
  std::map<std::string, std::size_t> values;
  std::map<std::string, std::size_t> keys;
};

/// The text of a tree, with drawn blanks, escapes, order of keys and perhaps a byte order mark. The simplest has one
/// blank after each comma and colon.
WrittenJson write_json(Choices& choices, const JsonTree& tree);

/// The line and the column of an offset, both from 1; columns count bytes.
struct LineColumn {
  int line = 1;
  int column = 1;
};
LineColumn line_column(std::string_view text, std::size_t offset);

}  // namespace torse::fuzz
