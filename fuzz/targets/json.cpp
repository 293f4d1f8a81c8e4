// JSON documents: the tree tells where its values stand in the text, and what a reader accepts is written and read back
// equal.
//   The tree         offsets, texts of numbers, places of errors
//   The files        curve, rails, ruled; construct is read twice
#include <cctype>
#include <optional>
#include <string>

#include "torse/exact/rational/rational.hpp"
#include "torse/fuzz/targets/target.hpp"
#include "torse/io/construct_file.hpp"
#include "torse/io/parse.hpp"

namespace torse::targets {
namespace {

using Q = Rational;

bool equal_nets(const WeightedPoints<Q, 3>& a, const WeightedPoints<Q, 3>& b) {
  return a.points == b.points && a.weights == b.weights;
}

bool equal_knots(const KnotList<Q>& a, const KnotList<Q>& b) {
  return a.degree() == b.degree() && a.list() == b.list();
}

bool equal(const CurveFile<Q>& a, const CurveFile<Q>& b) {
  return equal_knots(a.knots, b.knots) && equal_nets(a.net, b.net);
}

bool equal(const RailsFile<Q>& a, const RailsFile<Q>& b) { return equal(a.c, b.c) && equal(a.d, b.d); }

bool equal(const RuledFile<Q>& a, const RuledFile<Q>& b) {
  return equal_knots(a.knots, b.knots) && equal_nets(a.c, b.c) && equal_nets(a.d, b.d);
}

bool equal(const ConstructFile<Q>& a, const ConstructFile<Q>& b) {
  return a.method == b.method && equal_knots(a.knots, b.knots) && equal_nets(a.c, b.c) && a.lambda == b.lambda &&
         a.m == b.m && a.sigma == b.sigma && a.omega0 == b.omega0 && a.d0 == b.d0 && a.va == b.va && a.vb == b.vb &&
         a.a == b.a && a.b == b.b && a.v == b.v;
}

/// The byte that a value begins with.
bool begins(const Node& node, char byte) {
  switch (node.kind) {
    case Node::Kind::null:
      return byte == 'n';
    case Node::Kind::boolean:
      return byte == 't' || byte == 'f';
    case Node::Kind::number:
      return byte == '-' || std::isdigit(static_cast<unsigned char>(byte)) != 0;
    case Node::Kind::string:
      return byte == '"';
    case Node::Kind::array:
      return byte == '[';
    case Node::Kind::object:
      return byte == '{';
  }
  return false;
}

void check_tree(const Node& node, std::string_view text) {
  require(node.offset < text.size() && begins(node, text[node.offset]), "a value stands where its offset says");
  if (node.kind == Node::Kind::number) {
    require(text.substr(node.offset, node.text.size()) == node.text, "a number has the text that stands there");
    const std::string_view rest = text.substr(node.offset + node.text.size());
    require(rest.empty() || std::string_view(" \t\r\n,]}").find(rest[0]) != std::string_view::npos,
            "a number ends where its text does");
  }
  require(node.kind != Node::Kind::object || node.keys.size() == node.items.size(), "a value for each key");
  std::size_t after = node.offset;
  for (const Node& item : node.items) {
    require(item.offset > after, "values stand in their order");
    after = item.offset;
    check_tree(item, text);
  }
}

/// Errors are about this file, and at a place in the text.
void check_error(const FileError& error, std::string_view text) {
  require(error.file() == "fuzz.json" && !error.reason().empty(), "an error names its file and its reason");
  if (error.line() == 0) return;
  std::size_t begin = 0;
  for (std::size_t line = 1; line < error.line(); ++line) {
    begin = text.find('\n', begin);
    require(begin != std::string_view::npos, "the line of an error is in the text");
    ++begin;
  }
  require(error.column() >= 1 && begin + error.column() - 1 <= text.size(), "the column of an error is in the text");
}

template <class Read, class Write>
void check_round_trip(const Document& document, Read read, Write write) {
  const auto value = read(document);
  const Document again("fuzz.json", write(value));
  require(equal(value, read(again)), "what is written reads back equal");
}

void check_file(const Document& document) {
  const std::string& type = file_type(document);
  if (type == "curve") {
    check_round_trip(document, read_curve<Q>, write_curve<Q>);
  } else if (type == "rails") {
    check_round_trip(document, read_rails<Q>, write_rails<Q>);
  } else if (type == "construct") {
    require(equal(read_construct<Q>(document), read_construct<Q>(document)), "reading twice gives the same");
  } else {
    check_round_trip(document, read_ruled<Q>, write_ruled<Q>);
  }
}

void check(const std::string& text) {
  try {
    check_tree(parse_json("fuzz.json", text), text);
    check_file(Document("fuzz.json", text));
  } catch (const FileError& error) {
    check_error(error, text);
  }
}

}  // namespace
}  // namespace torse::targets

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  torse::targets::check(std::string(torse::targets::text_of(data, size)));
  return 0;
}
