// The tree is built from the events of nlohmann's SAX parser. The events carry no positions; an iterator that reports
// how far the parser has read, and the separators skipped since the event before, give the start of each token.
#include "torse/io/parse.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "torse/io/text.hpp"

namespace torse {
namespace {

/// nlohmann's parser refuses numbers that overflow its floating type, so the widest one reads them; their values are
/// never used.
using Json = nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t, std::uint64_t, long double>;

/// Walks over the text and tells how far it went.
class TellingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  TellingIterator(const char* at, const char** reached) : at_(at), reached_(reached) {}
  reference operator*() const { return *at_; }
  TellingIterator& operator++() {
    *reached_ = ++at_;
    return *this;
  }
  friend bool operator==(const TellingIterator& a, const TellingIterator& b) { return a.at_ == b.at_; }

 private:
  const char* at_;
  const char** reached_;
};

/// The exponents of all numbers of a document may make so many bits together.
constexpr std::size_t most_exponent_bits = std::size_t{1} << 27;

class TreeBuilder : public Json::json_sax_t {
 public:
  TreeBuilder(const std::string& file, std::string_view text) : file_(file), text_(text), reached_(text.data()) {}

  const char** reached() { return &reached_; }
  Node take_root() { return std::move(root_); }

  bool null() override { return leaf(Node::Kind::null, "null"); }
  bool boolean(bool value) override { return leaf(Node::Kind::boolean, value ? "true" : "false"); }
  bool number_integer(std::int64_t) override { return number(); }
  bool number_unsigned(std::uint64_t) override { return number(); }
  bool number_float(long double, const std::string&) override { return number(); }
  bool string(std::string& value) override { return leaf(Node::Kind::string, std::move(value)); }
  bool binary(Json::binary_t&) override { fail("expected JSON text, found binary data"); }
  bool start_object(std::size_t) override { return open(Node::Kind::object); }
  bool start_array(std::size_t) override { return open(Node::Kind::array); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(std::string& name) override {
    find_token();
    std::vector<std::string>& keys = open_.back()->keys;
    if (std::ranges::find(keys, name) != keys.end())
      fail("expected each key once, found " + in_quotes(name) + " again");
    if (keys.size() == limits::keys) fail("expected at most " + std::to_string(limits::keys) + " keys, found more");
    keys.push_back(std::move(name));
    end_token();
    return true;
  }

  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& error) override {
    constexpr int overflow = 406;
    if (error.id == overflow) {
      find_token();
      fail("expected a number below 1e4932 (a string may hold a larger one), found " + in_quotes(number_text()));
    }
    token_ = std::min(position > 0 ? position - 1 : 0, text_.size());
    fail(syntax_reason(error.what()));
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw FileError(file_, "", position_of(text_, token_), reason);
  }

  /// nlohmann says "[...] syntax error while parsing X - found; last read: '...'; expected Y"; this is said as
  /// everywhere else, with the text at the error instead of all that was read.
  std::string syntax_reason(const std::string& what) const {
    const std::size_t begin = what.find(" - ") == std::string::npos ? 0 : what.find(" - ") + 3;
    const std::size_t end = std::min(what.find("; last read: '", begin), what.size());
    const std::size_t wanted = what.rfind("; expected ");
    std::string found = what.substr(begin, what.find(';', begin) - begin);
    if (found.starts_with("unexpected ")) found.erase(0, 11);
    std::string expected = "JSON";
    if (wanted != std::string::npos)
      expected = what.substr(wanted + 11, wanted < end ? end - wanted - 11 : what.size());
    return "expected " + printable(expected) + ", found " + printable(found) + near();
  }

  /// The text from the start of the word at the error.
  std::string near() const {
    constexpr std::size_t longest = 24;
    if (token_ >= text_.size()) return "";
    std::size_t start = token_;
    const auto in_word = [](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '.';
    };
    while (start > 0 && token_ - start < longest && in_word(text_[start - 1])) --start;
    const std::string_view line = text_.substr(start, text_.find('\n', start) - start);
    return " near " + in_quotes(line.substr(0, longest));
  }

  void find_token() { token_ = std::min(text_.find_first_not_of(" \t\r\n,:\xEF\xBB\xBF", end_), text_.size()); }
  void end_token() { end_ = static_cast<std::size_t>(reached_ - text_.data()); }

  std::string number_text() const {
    const std::size_t end = std::min(text_.find_first_not_of("+-.0123456789eE", token_), text_.size());
    return std::string(text_.substr(token_, end - token_));
  }
  bool number() {
    find_token();
    return leaf(Node::Kind::number, number_text());
  }

  bool leaf(Node::Kind kind, std::string text) {
    exponent_bits_ += exponent_bits(text);
    place({kind, 0, std::move(text)});
    if (exponent_bits_ > most_exponent_bits) {
      fail("expected numbers whose exponents make at most " + std::to_string(most_exponent_bits) +
           " bits together, found more");
    }
    end_token();
    return true;
  }

  bool open(Node::Kind kind) {
    Node* node = place({kind, 0});
    if (open_.size() == limits::depth) {
      fail("expected arrays and objects at most " + std::to_string(limits::depth) + " deep, found deeper ones");
    }
    open_.push_back(node);
    end_token();
    return true;
  }

  bool close() {
    open_.pop_back();
    end_token();
    return true;
  }

  Node* place(Node node) {
    find_token();
    if (++values_ > limits::values) {
      fail("expected at most " + std::to_string(limits::values) + " values, found more");
    }
    node.offset = token_;
    if (open_.empty()) {
      root_ = std::move(node);
      return &root_;
    }
    return &open_.back()->items.emplace_back(std::move(node));
  }

  const std::string& file_;
  std::string_view text_;
  const char* reached_;
  std::size_t token_ = 0;
  std::size_t end_ = 0;
  std::size_t values_ = 0;
  std::size_t exponent_bits_ = 0;
  Node root_;
  std::vector<Node*> open_;
};

/// nlohmann's parser takes a null byte for the end of the text, and keeps the blanks that it skips to write them out,
/// each as several characters, in an error.
void require_plain(const std::string& file, std::string_view text) {
  const auto fail = [&](std::size_t offset, const std::string& reason) {
    throw FileError(file, "", position_of(text, offset), reason);
  };
  std::size_t blanks = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    blanks = c == ' ' || c == '\n' || c == '\t' || c == '\r' ? blanks + 1 : 0;
    if (c == '\0') fail(i, "expected JSON, found a null byte");
    if (blanks > limits::blanks) {
      fail(i, "expected at most " + std::to_string(limits::blanks) + " blanks in a row, found more");
    }
  }
}

}  // namespace

TextPosition position_of(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const std::size_t line_start = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
  const std::string_view line = before.substr(line_start);
  const auto begins_character = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
  const auto characters =
      std::ranges::count_if(line_start == 0 ? without_byte_order_mark(line) : line, begins_character);
  return {.line = static_cast<std::size_t>(std::ranges::count(before, '\n')) + 1,
          .column = line.size() + 1,
          .character = static_cast<std::size_t>(characters) + 1};
}

std::size_t exponent_bits(std::string_view text) {
  const std::size_t before = text.find_last_not_of("0123456789");
  if (before == std::string_view::npos || before + 1 == text.size()) return 0;
  if (text[0] != '-' && text[0] != '+' && (text[0] < '0' || text[0] > '9')) return 0;
  const bool sign = text[before] == '-' || text[before] == '+';
  const char letter = sign && before > 0 ? text[before - 1] : text[before];
  const bool hexadecimal = text.find_first_of("xX") != std::string_view::npos;
  const bool tens = !hexadecimal && (letter == 'e' || letter == 'E');
  const std::size_t percent = tens ? 333 : letter == 'p' || letter == 'P' ? 100 : 0;
  constexpr std::size_t most = limits::binary_exponent;
  std::size_t exponent = 0;
  for (char c : text.substr(before + 1)) exponent = std::min(most, exponent * 10 + static_cast<std::size_t>(c - '0'));
  return exponent * percent / 100;
}

Node parse_json(const std::string& file, std::string_view text) {
  if (text.empty()) throw FileError(file, "expected JSON, found an empty file");
  require_plain(file, text);
  TreeBuilder builder(file, text);
  const TellingIterator first(text.data(), builder.reached());
  const TellingIterator last(text.data() + text.size(), builder.reached());
  Json::sax_parse(first, last, &builder);
  return builder.take_root();
}

}  // namespace torse
