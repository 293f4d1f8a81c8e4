#include "torse/fuzz/draw/json.hpp"

#include <array>
#include <numeric>
#include <utility>

#include "torse/fuzz/draw/spelling.hpp"
#include "torse/fuzz/input_text.hpp"

namespace torse::fuzz {
namespace {

class Writer {
 public:
  explicit Writer(Choices& choices) : choices_(choices), blanks_(choices.below(3)), escapes_(choices.once_in(3)) {}

  WrittenJson take(const JsonTree& tree) {
    if (choices_.once_in(12)) written_.text = "\xEF\xBB\xBF";
    blank("");
    value(tree, "");
    blank("");
    return std::move(written_);
  }

 private:
  /// Between two tokens.
  void blank(const char* usual) {
    if (blanks_ < 2) {
      written_.text += blanks_ == 0 ? usual : "";
      return;
    }
    constexpr std::array<const char*, 8> kinds{"", " ", "\n", "\t", "\r\n", "  ", "\n\n ", ""};
    written_.text += kinds[choices_.below(kinds.size())];
  }

  void value(const JsonTree& tree, const std::string& place) {
    written_.values[place] = written_.text.size();
    switch (tree.kind) {
      case JsonTree::Kind::literal:
        written_.text += tree.text;
        break;
      case JsonTree::Kind::number:
        number(tree.text);
        break;
      case JsonTree::Kind::string:
        string(tree.text);
        break;
      case JsonTree::Kind::array:
        array(tree, place);
        break;
      case JsonTree::Kind::object:
        object(tree, place);
        break;
    }
  }

  void number(const std::string& spelling) {
    if (is_json_number(spelling) && choices_.below(4) != 3) {
      written_.text += spelling;
    } else {
      string(spelling);
    }
  }

  void string(const std::string& text) {
    written_.text += '"';
    for (const char c : text) {
      const auto byte = static_cast<unsigned char>(c);
      if (byte < 0x20 || c == '"' || c == '\\' || (byte < 0x80 && escapes_ && choices_.once_in(8))) {
        written_.text += "\\u00" + detail::hex_text(std::string_view(&c, 1));
      } else {
        written_.text += c;
      }
    }
    written_.text += '"';
  }

  void array(const JsonTree& tree, const std::string& place) {
    written_.text += '[';
    for (std::size_t i = 0; i < tree.items.size(); ++i) {
      separate(i);
      value(tree.items[i], place + '[' + std::to_string(i) + ']');
    }
    close(']');
  }

  void object(const JsonTree& tree, const std::string& place) {
    written_.text += '{';
    const std::vector<std::size_t> order = drawn_order(tree.items.size());
    for (std::size_t n = 0; n < order.size(); ++n) {
      separate(n);
      const std::string& key = tree.keys[order[n]];
      const std::string member = place.empty() ? key : place + '.' + key;
      written_.keys[member] = written_.text.size();
      string(key);
      blank("");
      written_.text += ':';
      blank(" ");
      value(tree.items[order[n]], member);
    }
    close('}');
  }

  void separate(std::size_t index) {
    blank("");
    if (index == 0) return;
    written_.text += ',';
    blank(" ");
  }

  void close(char bracket) {
    blank("");
    written_.text += bracket;
  }

  std::vector<std::size_t> drawn_order(std::size_t count) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = 0; i + 1 < count; ++i) std::swap(order[i], order[i + choices_.below(count - i)]);
    return order;
  }

  Choices& choices_;
  std::uint64_t blanks_;
  bool escapes_;
  WrittenJson written_;
};

}  // namespace

JsonTree* JsonTree::find(std::string_view key) {
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i] == key) return &items[i];
  }
  return nullptr;
}

WrittenJson write_json(Choices& choices, const JsonTree& tree) { return Writer(choices).take(tree); }

LineColumn line_column(std::string_view text, std::size_t offset) {
  LineColumn at;
  for (const char c : text.substr(0, offset)) {
    ++at.column;
    if (c == '\n') at = {at.line + 1, 1};
  }
  return at;
}

}  // namespace torse::fuzz
