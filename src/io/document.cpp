// Typed access to a document, and the places of its errors.
#include "torse/io/document.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

#include "torse/io/parse.hpp"
#include "torse/io/text.hpp"

namespace torse {
namespace {

std::string message(const std::string& file, const std::string& place, const TextPosition& at,
                    const std::string& reason) {
  std::string text = printable(file) + ": ";
  if (at.line > 0) {
    const std::string position = "line " + std::to_string(at.line) + ", column " + std::to_string(at.column);
    text += (place.empty() ? position : place + " (" + position + ")") + ": ";
  }
  return text + reason;
}

/// What a value is, in words.
std::string described(const Node& node) {
  switch (node.kind) {
    case Node::Kind::string:
      return in_quotes(node.text);
    case Node::Kind::array:
      return "an array of " + std::to_string(node.items.size());
    case Node::Kind::object:
      return "an object";
    default:
      break;
  }
  return node.text.size() <= 40 ? node.text : node.text.substr(0, 40) + "...";
}

std::string step(const Node& parent, std::size_t i) {
  return parent.kind == Node::Kind::array ? "[" + std::to_string(i) + "]" : "." + printable(parent.keys[i]);
}

/// Whether `target` lies in the tree under `node`; appends the steps to it. The tree is at most limits::depth deep.
bool find_path(const Node& node, const Node* target, std::string& path) {
  if (&node == target) return true;
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const std::size_t before = path.size();
    path += step(node, i);
    if (find_path(node.items[i], target, path)) return true;
    path.resize(before);
  }
  return false;
}

/// The squares of the lengths of all numbers and strings: what their arithmetic may cost.
constexpr double most_squares = 0x1p38;

/// The node at which the sum exceeds that, if any.
const Node* beyond(const Node& node, double& squares) {
  const double length = static_cast<double>(node.text.size());
  squares += length * length;
  if (squares > most_squares) return &node;
  for (const Node& item : node.items) {
    if (const Node* found = beyond(item, squares)) return found;
  }
  return nullptr;
}

const Node* child(const Node& node, std::string_view place) {
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    if (step(node, i) == place) return &node.items[i];
  }
  return nullptr;
}

std::string joined(const std::vector<std::string_view>& words) {
  std::string text;
  for (std::string_view word : words) text += (text.empty() ? "" : ", ") + std::string(word);
  return text;
}

}  // namespace

FileError::FileError(std::string file, std::string reason) : FileError(std::move(file), "", {}, std::move(reason)) {}

FileError::FileError(std::string file, std::string place, const TextPosition& at, std::string reason)
    : Error(message(file, place, at, reason)),
      file_(std::move(file)),
      place_(std::move(place)),
      at_(at),
      reason_(std::move(reason)) {}

Document::Document(std::string file, std::string text)
    : file_(std::move(file)), text_(std::move(text)), root_(parse_json(file_, text_)) {
  double squares = 0;
  if (const Node* node = beyond(root_, squares)) {
    throw error(node, "expected numbers whose lengths have squares that add up to at most 2^38, found more up to here");
  }
}

Value Document::root() const { return Value(*this, root_); }

FileError Document::error(const Node* node, const std::string& reason) const {
  std::string path;
  find_path(root_, node, path);
  if (path.empty()) return FileError(file_, reason);
  return FileError(file_, path.substr(path.front() == '.' ? 1 : 0), position_of(text_, node->offset), reason);
}

FileError Document::error(const std::string& place, const std::string& reason) const {
  const Node* node = &root_;
  std::string rest = "." + place;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find_first_of(".[", 1), rest.size());
    const Node* next = child(*node, rest.substr(0, end));
    if (next == nullptr) break;
    node = next;
    rest.erase(0, end);
  }
  if (!rest.empty()) return error(node, place + ": " + reason);
  return error(node, reason);
}

FileError Document::error(const InvalidInput& invalid) const {
  return error(invalid.place(), std::string(invalid.what()).substr(invalid.place().size() + 2));
}

void Value::fail(const std::string& reason) const { throw document_->error(node_, reason); }

void Value::expected(const std::string& what) const { fail("expected " + what + ", found " + described(*node_)); }

void Value::expect_keys(std::initializer_list<std::string_view> keys) const {
  expect_keys(std::vector<std::string_view>(keys));
}

void Value::expect_keys(const std::vector<std::string_view>& keys) const {
  if (node_->kind != Node::Kind::object) expected("an object");
  for (std::size_t i = 0; i < node_->keys.size(); ++i) {
    if (std::ranges::find(keys, node_->keys[i]) == keys.end()) {
      Value(*document_, node_->items[i])
          .fail("expected one of the keys " + joined(keys) + ", found " + in_quotes(node_->keys[i]));
    }
  }
}

std::optional<Value> Value::find(std::string_view key) const {
  if (node_->kind != Node::Kind::object) expected("an object");
  const auto at = std::ranges::find(node_->keys, key);
  if (at == node_->keys.end()) return std::nullopt;
  return Value(*document_, node_->items[static_cast<std::size_t>(at - node_->keys.begin())]);
}

Value Value::at(std::string_view key) const {
  const std::optional<Value> value = find(key);
  if (!value) fail("expected the key " + in_quotes(key) + ", found none");
  return *value;
}

std::vector<Value> Value::items() const {
  if (node_->kind != Node::Kind::array) expected("an array");
  std::vector<Value> values;
  values.reserve(node_->items.size());
  for (const Node& item : node_->items) values.emplace_back(*document_, item);
  return values;
}

const std::string& Value::string() const {
  if (node_->kind != Node::Kind::string) expected("a string");
  return node_->text;
}

int Value::integer(int least, int most) const {
  int value = 0;
  const char* end = node_->text.data() + node_->text.size();
  const auto [stop, error] = std::from_chars(node_->text.data(), end, value);
  if (node_->kind != Node::Kind::number || error != std::errc() || stop != end || value < least || value > most) {
    expected(least == most ? std::to_string(least)
                           : "an integer from " + std::to_string(least) + " to " + std::to_string(most));
  }
  return value;
}

}  // namespace torse
