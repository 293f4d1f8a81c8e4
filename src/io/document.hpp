// JSON documents as a tree that keeps the text of every number, and the errors that name a place in them.
//   TextPosition   line and column
//   FileError      file, place, line and column, reason
//   Node           a value of the tree
//   Document       a parsed text
//   Value          a node with its document: typed access, every mismatch a FileError
#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "torse/io/limits.hpp"
#include "torse/io/number.hpp"

namespace torse {

/// A line and a column, counted from 1; 0 for a file as a whole.
struct TextPosition {
  std::size_t line = 0;
  /// In bytes.
  std::size_t column = 0;
  /// In characters (code points), without a byte order mark at the begin of the text.
  std::size_t character = 0;
};

/// A file that cannot be used; `what()` is "file: place (line L, column C): reason" with what there is of it.
class FileError : public Error {
 public:
  /// An error about a file as a whole.
  FileError(std::string file, std::string reason);
  /// An error at a position and a place such as "c.points[3][1]", empty for an error of syntax.
  FileError(std::string file, std::string place, const TextPosition& at, std::string reason);

  const std::string& file() const { return file_; }
  const std::string& place() const { return place_; }
  const std::string& reason() const { return reason_; }
  /// 0 for an error about the file as a whole.
  std::size_t line() const { return at_.line; }
  std::size_t column() const { return at_.column; }
  std::size_t character() const { return at_.character; }

 private:
  std::string file_;
  std::string place_;
  TextPosition at_;
  std::string reason_;
};

/// A value of a document. `text` is the text of a number as it stands in the file, or a string without its escapes.
struct Node {
  enum class Kind { null, boolean, number, string, array, object };

  Kind kind = Kind::null;
  std::size_t offset = 0;
  std::string text{};
  std::vector<Node> items{};
  std::vector<std::string> keys{};
};

class Value;

/// A JSON text (RFC 8259, UTF-8), parsed. Duplicate keys and anything beyond limits.hpp are errors.
class Document {
 public:
  /// `file` is the name for errors. Throws FileError.
  Document(std::string file, std::string text);
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;

  const std::string& file() const { return file_; }
  Value root() const;

  /// The error at a node. A null node is the whole file.
  FileError error(const Node* node, const std::string& reason) const;
  /// The error at a place such as "knots[3]", or at its nearest ancestor that exists.
  FileError error(const std::string& place, const std::string& reason) const;
  /// The error of a library function whose places are members of this document.
  FileError error(const InvalidInput& invalid) const;

 private:
  std::string file_;
  std::string text_;
  Node root_;
};

/// A node of a living document.
class Value {
 public:
  Value(const Document& document, const Node& node) : document_(&document), node_(&node) {}

  /// Throws the FileError "reason, found <this value>" at this place.
  [[noreturn]] void expected(const std::string& what) const;
  /// Throws a FileError at this place.
  [[noreturn]] void fail(const std::string& reason) const;

  /// Throws unless this is an object with no other keys than these.
  void expect_keys(std::initializer_list<std::string_view> keys) const;
  void expect_keys(const std::vector<std::string_view>& keys) const;
  /// The member of an object, if it is there.
  std::optional<Value> find(std::string_view key) const;
  /// The member of an object that must be there.
  Value at(std::string_view key) const;

  /// The entries of an array. Throws unless it is one.
  std::vector<Value> items() const;
  /// A string.
  const std::string& string() const;
  /// A JSON integer in [least, most].
  int integer(int least, int most) const;
  /// The exact value of a number, or of a string that holds one.
  template <ExactField S>
  S number() const {
    if (node_->kind != Node::Kind::number && node_->kind != Node::Kind::string) expected("a number");
    try {
      return parse_number<S>(node_->text);
    } catch (const BadNumber& bad) {
      fail(bad.what());
    }
  }

 private:
  const Document* document_;
  const Node* node_;
};

}  // namespace torse
